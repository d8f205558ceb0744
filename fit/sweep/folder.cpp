#include "sweep/folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>

#include "errors/input_error.hpp"
#include "files/read_file.hpp"
#include "files/replace_file.hpp"
#include "sweep/fingerprint.hpp"

namespace trunk {
namespace {

namespace fs = std::filesystem;

/// Returns true if the folder is new, or if a sweep was interrupted in it before it stored anything.
bool holds_nothing(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const bool empty_folder = (name == "runs" || name == "journal") && fs::is_empty(entry.path());
    if (entry.path().extension() != ".part" && name != "lock" && name != "sweep.toml" && !empty_folder)
      return false;
  }
  return true;
}

/// Removes the incomplete files of killed processes.
void remove_half_files(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".part") fs::remove(entry.path());
}

void make_folder(const fs::path& path) {
  const fs::path parent = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(parent))
    throw InputError({path.string()}, "cannot be made: there is no folder '" + parent.string() + "'", "",
                     "make that folder first");
  if (fs::exists(path) && !fs::is_directory(path)) throw InputError({path.string()}, "is a file", "a folder");
  for (const char* part : {"runs", "journal"}) {
    std::error_code error;
    fs::create_directories(path / part, error);
    if (error)
      throw InputError({path.string()}, "cannot be made: " + error.message(), "",
                       "check the rights on the folder, or name another one");
  }
  require_writable_output(path / "fingerprint", true);
}

fs::path without_slash(const fs::path& path) {
  return path.filename().empty() ? path.parent_path() : path;  // DIR/
}

/// Returns true if the folder holds another sweep that must be deleted. Throws InputError if it holds
/// anything but this sweep and `force` is false.
bool holds_another(const fs::path& folder, const std::string& mine, bool force) {
  if (!fs::is_directory(folder)) return false;
  // Another shard may write the fingerprint at this moment, so the other files are looked at first.
  const bool foreign = !holds_nothing(folder);
  const std::string found = read_fingerprint(folder);
  if (identity(found) == identity(mine)) return false;
  if (force) return !found.empty();
  if (!found.empty())
    throw InputError({folder.string()},
                     "holds another sweep (its design, a scenario, a subject or the program differs)",
                     "a new folder", "name a new one, or delete its runs with --force");
  if (foreign)
    throw InputError({folder.string()}, "is not empty and holds no sweep", "a new folder",
                     "name a new one, or use this one with --force");
  return false;
}

}  // namespace

SweepFolder::SweepFolder(const fs::path& path, const SweepDesign& design, const Shard& shard, bool force)
    : path_(without_slash(path)), fingerprint_(fingerprint_of(design)) {
  const bool replaces = holds_another(path_, fingerprint_, force);
  make_folder(path_);
  lock(shard.count == 1 || replaces ? LockKind::alone : LockKind::shared);
  if (holds_another(path_, fingerprint_, force)) {
    for (const char* part : {"runs", "journal", "sweep.h5", "table.csv", "fingerprint"})
      fs::remove_all(path_ / part);
    make_folder(path_);
  }
  if (shard.count > 1) try_lock(*lock_, LockKind::shared);
  if (shard.count == 1) remove_half_files(path_ / "runs");
  if (const std::string found = read_fingerprint(path_); !found.empty()) {
    fingerprint_ = found;
    return;
  }
  replace_file(path_ / "sweep.toml", design.text);
  replace_file(path_ / "fingerprint", fingerprint_);
}

SweepFolder::SweepFolder(const fs::path& path)
    : path_(without_slash(path)), fingerprint_(read_fingerprint(path_)) {
  runs_in(fingerprint_, path_);
  const auto lines = lines_from(1, fingerprint_);
  if (lines.empty() || lines[0] != program_text())
    throw InputError(
        {path_.string()}, fmt::format("was written by {}", lines.empty() ? "another program" : lines[0]),
        fmt::format("this program's version, {}", program_text()), "use the program that wrote it");
  lock(LockKind::alone);
  remove_half_files(path_ / "runs");
}

void SweepFolder::lock(LockKind kind) {
  const fs::path file = path_ / "lock";
  const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0)
    throw InputError({file.string()}, std::string("cannot be written: ") + std::strerror(errno), "",
                     "check the rights on the folder");
  lock_ = std::shared_ptr<const int>(new int(descriptor), [](const int* held) {
    close(*held);
    delete held;
  });
  if (!try_lock(descriptor, kind))
    throw InputError({path_.string()}, "is in use by another process", "one process, or only shards",
                     "wait for it to end, or give each process its own --shard k/n");
}

fs::path SweepFolder::run_file(std::size_t run) const {
  return path_ / run_file_name(run);
}
std::string SweepFolder::run_file_name(std::size_t run) {
  return fmt::format("runs/{:05}.h5", run);
}

Journal SweepFolder::journal(const Shard& shard) const {
  return {path_ / "journal" / fmt::format("{}-of-{}", shard.number, shard.count), identity(fingerprint_)};
}

void SweepFolder::for_each_row(const std::function<void(SweepRow)>& visit) const {
  read_journals(path_ / "journal", identity(fingerprint_), most_runs_in(fingerprint_, path_), visit);
}

SweepDesign SweepFolder::design() const {
  const fs::path file = path_ / "sweep.toml";
  SweepDesign design = parse_sweep_design(read_text_file(file, longest_sweep_text), file.string());
  if (design.runs() != runs_in(fingerprint_, path_))
    throw InputError({file.string()}, fmt::format("makes {} runs: it was changed", design.runs()),
                     std::to_string(runs_in(fingerprint_, path_)), "restore the file, or start a new folder");
  return design;
}

std::vector<std::pair<std::string, std::string>> SweepFolder::inputs() const {
  std::vector<std::pair<std::string, std::string>> inputs;
  for (const std::string& line : lines_from(3, fingerprint_)) {
    const auto gap = std::min(line.find("  "), line.size());
    inputs.emplace_back(line.substr(std::min(gap + 2, line.size())), line.substr(0, gap));
  }
  return inputs;
}

}  // namespace trunk
