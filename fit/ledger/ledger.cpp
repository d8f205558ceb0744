#include "ledger/ledger.hpp"

#include <sqlite3.h>

#include <cstring>
#include <stdexcept>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

constexpr std::size_t most_values = 1'000'000;

}  // namespace

struct Ledger::File {
  using Statement = std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)>;

  std::filesystem::path path;
  std::unique_ptr<sqlite3, decltype(&sqlite3_close)> database{nullptr, &sqlite3_close};
  Statement insert{nullptr, &sqlite3_finalize};

  [[noreturn]] void fail() const {
    const int code = sqlite3_errcode(database.get());
    const std::string message = sqlite3_errmsg(database.get());
    const Place at{path.string()};
    if (code == SQLITE_NOTADB || code == SQLITE_ERROR || code == SQLITE_CORRUPT)
      throw InputError(at, "is not a ledger of this program (" + message + ")",
                       "no file, or the ledger of an interrupted fit", "delete it or name another result");
    if (code == SQLITE_BUSY || code == SQLITE_LOCKED)
      throw InputError(at, "is in use: another fit is writing this result", "one fit at a time",
                       "wait for the other fit, or name another result");
    throw InputError(at, "cannot be written: " + message, "",
                     "check the space on the disk and the rights on the folder");
  }
  void execute(const char* sql) const {
    if (sqlite3_exec(database.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail();
  }
  Statement prepared(const char* sql) const {
    sqlite3_stmt* statement = nullptr;
    if (sqlite3_prepare_v2(database.get(), sql, -1, &statement, nullptr) != SQLITE_OK) fail();
    return {statement, &sqlite3_finalize};
  }
  /// Returns false at the end of the rows.
  bool step(const Statement& statement) const {
    const int code = sqlite3_step(statement.get());
    if (code != SQLITE_ROW && code != SQLITE_DONE) fail();
    return code == SQLITE_ROW;
  }
};

namespace {

std::string blob(sqlite3_stmt* row, int column) {
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(row, column));
  const void* data = sqlite3_column_blob(row, column);
  return size == 0 ? std::string() : std::string(static_cast<const char*>(data), size);
}

void bind_blob(sqlite3_stmt* statement, int at, const void* data, std::size_t size) {
  sqlite3_bind_blob(statement, at, data, static_cast<int>(size), SQLITE_TRANSIENT);
}

std::vector<double> numbers(const std::string& bytes) {
  std::vector<double> values(std::min(bytes.size() / sizeof(double), most_values));
  if (!values.empty()) std::memcpy(values.data(), bytes.data(), values.size() * sizeof(double));
  return values;
}

}  // namespace

Ledger::Ledger() = default;
Ledger::~Ledger() = default;

Ledger::Ledger(const std::filesystem::path& path, const std::string& problem)
    : file_(std::make_unique<File>()) {
  file_->path = path;
  const bool is_new = !std::filesystem::exists(path);
  try {
    open(problem);
  } catch (...) {
    if (is_new) discard();  // it holds nothing yet
    throw;
  }
}

void Ledger::open(const std::string& problem) {
  const std::filesystem::path& path = file_->path;
  sqlite3* database = nullptr;
  const int opened = sqlite3_open(path.c_str(), &database);
  file_->database.reset(database);
  if (opened != SQLITE_OK) file_->fail();
  // An entry outlives a process that is killed, but not a machine that loses power.
  file_->execute(
      "PRAGMA synchronous = OFF; PRAGMA locking_mode = EXCLUSIVE; BEGIN IMMEDIATE;"
      "CREATE TABLE IF NOT EXISTS problem (text TEXT);"
      "CREATE TABLE IF NOT EXISTS entry (key BLOB PRIMARY KEY, status INTEGER, lasted_s REAL, "
      "wall_s REAL, numbers BLOB);");
  const File::Statement known = file_->prepared("SELECT text FROM problem");
  const bool same = file_->step(known) && blob(known.get(), 0) == problem;
  sqlite3_reset(known.get());
  if (!same) {
    file_->execute("DELETE FROM entry; DELETE FROM problem");
    const File::Statement name = file_->prepared("INSERT INTO problem VALUES (?)");
    sqlite3_bind_text(name.get(), 1, problem.data(), static_cast<int>(problem.size()), SQLITE_TRANSIENT);
    file_->step(name);
  }
  const File::Statement rows = file_->prepared("SELECT key, status, lasted_s, wall_s, numbers FROM entry");
  while (file_->step(rows))
    entries_[blob(rows.get(), 0)] = {sqlite3_column_int(rows.get(), 1), sqlite3_column_double(rows.get(), 2),
                                     sqlite3_column_double(rows.get(), 3), numbers(blob(rows.get(), 4))};
  found_ = entries_.size();
  file_->execute("COMMIT");
  file_->insert = file_->prepared("INSERT OR REPLACE INTO entry VALUES (?, ?, ?, ?, ?)");
}

const LedgerEntry* Ledger::find(const std::string& key) const {
  const auto at = entries_.find(key);
  return at == entries_.end() ? nullptr : &at->second;
}

void Ledger::add(const std::string& key, LedgerEntry entry) {
  if (file_) {
    sqlite3_stmt* insert = file_->insert.get();
    bind_blob(insert, 1, key.data(), key.size());
    sqlite3_bind_int(insert, 2, entry.status);
    sqlite3_bind_double(insert, 3, entry.lasted_s);
    sqlite3_bind_double(insert, 4, entry.wall_s);
    bind_blob(insert, 5, entry.values.data(), entry.values.size() * sizeof(double));
    file_->step(file_->insert);
    sqlite3_reset(insert);
  }
  entries_[key] = std::move(entry);
}

void Ledger::discard() {
  if (!file_) return;
  const std::filesystem::path path = file_->path;
  file_.reset();
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
  // SQLite leaves this file if its process is killed while it writes.
  std::filesystem::remove(path.string() + "-journal", ignored);
}

}  // namespace trunk
