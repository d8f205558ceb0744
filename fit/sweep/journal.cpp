#include "sweep/journal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include "errors/input_error.hpp"
#include "files/lock.hpp"
#include "files/sha256.hpp"

namespace trunk {
namespace {

constexpr std::size_t longest_row = std::size_t{1} << 26, longest_error = 500;
constexpr std::size_t checksum_size = 16;

/// The file holds for each row its size, its bytes, and the beginning of their SHA-256. Numbers have the
/// machine's byte order: only machines of one kind share the folder of a sweep.
template <class Number>
void put(std::string& bytes, const Number& number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}
void put(std::string& bytes, const std::string& text) {
  put(bytes, static_cast<std::uint32_t>(text.size()));
  bytes += text;
}
void put(std::string& bytes, const std::vector<double>& numbers) {
  put(bytes, static_cast<std::uint32_t>(numbers.size()));
  bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
}

std::string bytes_of(const SweepRow& row) {
  std::string body;
  put(body, row.run);
  put(body, row.status);
  put(body, row.error.substr(0, longest_error));
  put(body, row.ended_at);
  put(body, row.has_file);
  put(body, row.measures);
  put(body, row.curve);
  if (!row.intervals.empty()) put(body, row.intervals);
  std::string bytes;
  put(bytes, static_cast<std::uint32_t>(body.size()));
  return bytes + body + sha256_of_text(body).substr(0, checksum_size);
}

/// Takes values from the front of a text; `ok` becomes false if the text is too short.
struct Parser {
  std::string_view rest;
  bool ok = true;

  void take(void* to, std::size_t size) {
    ok = ok && size <= rest.size();
    if (!ok || size == 0) return;
    std::memcpy(to, rest.data(), size);
    rest.remove_prefix(size);
  }
  std::size_t take_count(std::size_t value_size) {
    std::uint32_t count = 0;
    take(&count, sizeof count);
    ok = ok && count <= rest.size() / value_size;
    return ok ? count : 0;
  }
  void take(std::string& text) {
    text.resize(take_count(1));
    take(text.data(), text.size());
  }
  void take(std::vector<double>& numbers) {
    numbers.resize(take_count(sizeof(double)));
    take(numbers.data(), numbers.size() * sizeof(double));
  }
};

bool parse(std::string_view body, SweepRow& row) {
  Parser parser{body};
  char has_file = 0;
  parser.take(&row.run, sizeof row.run);
  parser.take(row.status);
  parser.take(row.error);
  parser.take(&row.ended_at, sizeof row.ended_at);
  parser.take(&has_file, sizeof has_file);
  parser.take(row.measures);
  parser.take(row.curve);
  if (parser.ok && !parser.rest.empty()) parser.take(row.intervals);
  row.has_file = has_file != 0;
  return parser.ok && parser.rest.empty();
}

/// Reads the next row; returns false if it is incomplete or damaged, or at the end.
bool read_row(std::istream& file, std::string& body, SweepRow& row) {
  std::uint32_t size = 0;
  char checksum[checksum_size];
  if (!file.read(reinterpret_cast<char*>(&size), sizeof size) || size > longest_row) return false;
  body.resize(size);
  if (!file.read(body.data(), size) || !file.read(checksum, checksum_size)) return false;
  return sha256_of_text(body).compare(0, checksum_size, checksum, checksum_size) == 0 && parse(body, row);
}

/// Returns the rank of a row among those of its run; the row with the largest rank counts. A failed row never
/// replaces a completed one, whatever the clocks of the machines say.
std::pair<int, double> rank_of(const SweepRow& row) {
  return {row.status == "completed" ? 2 : 1, row.ended_at};
}

/// Moves `at` forward to the next place where the head of a row could be, so that a row with a damaged size
/// does not hide the rows after it. Returns false if there is none.
bool find_row(std::istream& file, std::size_t& at) {
  constexpr std::uint64_t most_runs = 1 << 24;
  constexpr std::uint32_t longest_status = 32;
  const auto could_be_head = [](std::string_view head) {
    Parser parser{head};
    std::uint32_t size = 0, status = 0;
    std::uint64_t run = 0;
    parser.take(&size, sizeof size);
    parser.take(&run, sizeof run);
    parser.take(&status, sizeof status);
    return size <= longest_row && run < most_runs && status > 0 && status <= longest_status;
  };
  std::array<char, 16> head{};  // size, run, and length of the status
  file.clear();
  file.seekg(static_cast<std::streamoff>(at));
  file.read(head.data(), head.size());
  for (; file && !could_be_head({head.data(), head.size()}); ++at) {
    std::shift_left(head.begin(), head.end(), 1);
    file.get(head.back());
  }
  return file && file.seekg(static_cast<std::streamoff>(at));
}

/// Returns the error of a write that just failed (errno).
InputError not_written(const std::filesystem::path& path) {
  return {{path.string()},
          std::string("cannot be written: ") + std::strerror(errno),
          "",
          "check the space on the disk and the rights on the folder"};
}

std::string heading(const std::string& fingerprint) {
  return "trunk sweep journal 1\n" + fingerprint + "\n";
}

}  // namespace

std::size_t read_journal(const std::filesystem::path& path, const std::string& fingerprint,
                         const std::function<void(SweepRow)>& visit) {
  std::ifstream file(path, std::ios::binary);
  std::string found(heading(fingerprint).size(), '\0');
  if (!file.read(found.data(), static_cast<std::streamsize>(found.size())) || found != heading(fingerprint))
    return 0;
  std::size_t at = found.size(), end = at;
  std::string body;
  do {
    for (SweepRow row; read_row(file, body, row); row = {}) {
      at += sizeof(std::uint32_t) + body.size() + checksum_size;
      end = at;
      visit(std::move(row));
    }
  } while (find_row(file, ++at));
  if (file.bad())
    throw InputError({path.string()}, std::string("cannot be read: ") + std::strerror(errno), "",
                     "check the disk");
  return end;
}

void read_journals(const std::filesystem::path& folder, const std::string& fingerprint, std::size_t runs,
                   const std::function<void(SweepRow)>& visit) {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(folder))
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::pair<int, double>> highest(runs);
  for (const auto& file : files)
    read_journal(file, fingerprint, [&](SweepRow row) {
      if (row.run >= runs || rank_of(row) < highest[row.run]) return;
      highest[row.run] = rank_of(row);
      visit(std::move(row));
    });
}

Journal::Journal(std::filesystem::path path, const std::string& fingerprint)
    : path_(std::move(path)),
      descriptor_(open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
  const auto fail = [&](InputError error) {
    if (descriptor_ >= 0) close(descriptor_);
    throw error;
  };
  if (descriptor_ < 0) fail(not_written(path_));
  if (!try_lock(descriptor_, LockKind::alone))
    fail({{path_.string()},
          "is being written by another process",
          "one process for each shard",
          "give each its own --shard, or wait"});
  const std::size_t end = read_journal(path_, fingerprint, [](const SweepRow&) {});
  if (ftruncate(descriptor_, static_cast<off_t>(end)) != 0) fail(not_written(path_));
  if (end == 0) write_all(heading(fingerprint));
}

Journal::~Journal() {
  close(descriptor_);
}

void Journal::append(std::span<const SweepRow> rows) {
  std::string bytes;
  for (const SweepRow& row : rows) bytes += bytes_of(row);
  write_all(bytes);
}

void Journal::write_all(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw not_written(path_);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void Journal::synchronise() {
  fsync(descriptor_);
}

}  // namespace trunk
