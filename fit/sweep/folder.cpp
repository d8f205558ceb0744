#include "sweep/folder.hpp"

#include <fmt/format.h>

#include <charconv>
#include <span>

#include "errors/input_error.hpp"
#include "io/text_file.hpp"
#include "io/trunk_pml.hpp"
#include "recording/provenance.hpp"
#include "results/sha256.hpp"
#include "results/target_file.hpp"

namespace trunk {
namespace {

namespace fs = std::filesystem;

/// First line the number of runs, second the hash of all that decides their results.
std::string fingerprint_of(const SweepDesign& design) {
  const Provenance program = provenance_of({}, "");
  std::string all = program.version + program.git_sha + (program.git_dirty ? "+" : "") + design.text;
  for (const auto& file : design.scenarios) {
    const Scenario scenario = read_scenario(file).scenario;
    all += to_toml(scenario);
    if (scenario.mesh) all += trunk_pml(scenario);
  }
  return fmt::format("{}\n{}\n", design.runs(), sha256_of_text(all));
}

std::string read_fingerprint(const fs::path& folder) {
  const fs::path file = folder / "fingerprint";
  return fs::exists(file) ? read_text_file(file, 1000) : "";
}

fs::path run_path(const fs::path& folder, std::size_t run) {
  return folder / fmt::format("runs/{:05}.h5", run);
}

/// True for a new folder, and for one in which a sweep could only just begin.
bool holds_nothing(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() != ".part" &&
        !(entry.path().filename() == "runs" && fs::is_empty(entry.path())))
      return false;
  return true;
}

/// What a killed sweep left half written.
void remove_half_files(const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".part") fs::remove(entry.path());
}

void make_folder(const fs::path& path) {
  const fs::path parent = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(parent))
    throw InputError(path.string(), 0, "cannot be made: there is no folder '" + parent.string() + "'");
  if (fs::exists(path) && !fs::is_directory(path))
    throw InputError(path.string(), 0, "is a file, expected a folder");
  std::error_code error;
  fs::create_directories(path / "runs", error);
  if (error) throw InputError(path.string(), 0, "cannot be made: " + error.message());
}

}  // namespace

SweepFolder::SweepFolder(fs::path path, const SweepDesign& design, bool force) : path_(std::move(path)) {
  if (path_.filename().empty()) path_ = path_.parent_path();  // DIR/
  const std::string mine = fingerprint_of(design);
  std::string found = fs::is_directory(path_) ? read_fingerprint(path_) : "";
  if (found.empty() && fs::is_directory(path_) && !holds_nothing(path_) && !force)
    throw InputError(path_.string(), 0, "is not empty and holds no sweep, expected a new folder or --force");
  if (!found.empty() && found != mine) {
    if (!force)
      throw InputError(
          path_.string(), 0,
          "holds another sweep (its design, a scenario or the program differs); expected a new folder, "
          "or --force to delete its runs");
    fs::remove_all(path_ / "runs");
    fs::remove(sweep_file());
    fs::remove(table_file());
    found.clear();
  }
  make_folder(path_);
  require_writable_target(path_ / "fingerprint", true);
  remove_half_files(path_ / "runs");
  if (found.empty()) replace_file(path_ / "fingerprint", std::as_bytes(std::span(mine)));
}

fs::path SweepFolder::run_file(std::size_t run) const {
  return run_path(path_, run);
}
std::string SweepFolder::run_file_name(std::size_t run) const {
  return run_path("", run).string();
}
bool SweepFolder::is_done(std::size_t run) const {
  return is_complete(run_file(run));
}

SweepProgress progress_of(const fs::path& folder) {
  SweepProgress progress;
  const std::string found = fs::is_directory(folder) ? read_fingerprint(folder) : "";
  const auto parsed = std::from_chars(found.data(), found.data() + found.size(), progress.runs);
  if (found.empty() || parsed.ec != std::errc())
    throw InputError(folder.string(), 0, "holds no sweep, expected a folder written by `trunk sweep`");
  for (std::size_t run = 0; run < progress.runs; ++run)
    progress.done += is_complete(run_path(folder, run)) ? 1 : 0;
  progress.has_table = fs::exists(folder / "sweep.h5");
  return progress;
}

}  // namespace trunk
