#include "cohort/folder.hpp"

#include "errors/input_error.hpp"
#include "files/read_file.hpp"
#include "files/replace_file.hpp"
#include "results/read/results_kind.hpp"

namespace trunk {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_summary = 10'000'000;  // bytes

}  // namespace

CohortFolder::CohortFolder(fs::path path, const CohortList& list, bool force) : path_(std::move(path)) {
  if (path_.filename().empty()) path_ = path_.parent_path();  // DIR/
  const Place place{path_.string()};
  if (fs::exists(path_) && !fs::is_directory(path_)) throw InputError(place, "is a file", "a folder");
  const fs::path parent = path_.has_parent_path() ? path_.parent_path() : fs::path(".");
  if (!fs::is_directory(parent))
    throw InputError(place, "cannot be made: there is no folder '" + parent.string() + "'");
  if (fs::exists(path_) && !fs::exists(path_ / "cohort.list") && !fs::is_empty(path_) && !force)
    throw InputError(place, "is not empty and holds no cohort", "a new folder, or --force");
  std::error_code error;
  fs::create_directory(path_, error);
  if (error) throw InputError(place, "cannot be made: " + error.message());
  require_writable_output(path_ / "cohort.list", true);
  replace_file(path_ / "cohort.list", list.text);
}

fs::path CohortFolder::fit_file(const std::string& subject) const {
  return path_ / (subject + ".h5");
}
fs::path CohortFolder::summary_file(const std::string& subject) const {
  return path_ / (subject + ".json");
}

std::optional<StoredFit> CohortFolder::stored(const std::string& subject) const {
  if (!fs::exists(summary_file(subject)) || !is_complete(fit_file(subject))) return std::nullopt;
  return stored_fit(read_text_file(summary_file(subject), longest_summary), summary_file(subject));
}

void CohortFolder::store(const std::string& subject, const StoredFit& fit, const Json& details) const {
  replace_file(summary_file(subject), text_of(fit, details));
}
void CohortFolder::store_table(const std::string& text) const {
  replace_file(table_file(), text);
}

}  // namespace trunk
