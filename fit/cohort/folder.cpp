#include "cohort/folder.hpp"

#include <span>

#include "errors/input_error.hpp"
#include "files/read_file.hpp"
#include "files/replace_file.hpp"
#include "results/read/results_kind.hpp"

namespace trunk {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_summary = 10'000'000;

void store(const fs::path& path, const std::string& text) {
  replace_file(path, std::as_bytes(std::span(text)));
}

}  // namespace

CohortFolder::CohortFolder(fs::path path, const CohortList& list, bool force) : path_(std::move(path)) {
  if (path_.filename().empty()) path_ = path_.parent_path();  // DIR/
  if (fs::exists(path_) && !fs::is_directory(path_))
    throw InputError(path_.string(), 0, "is a file, expected a folder");
  const fs::path parent = path_.has_parent_path() ? path_.parent_path() : fs::path(".");
  if (!fs::is_directory(parent))
    throw InputError(path_.string(), 0, "cannot be made: there is no folder '" + parent.string() + "'");
  if (fs::exists(path_) && !fs::exists(path_ / "cohort.list") && !fs::is_empty(path_) && !force)
    throw InputError(path_.string(), 0, "is not empty and holds no cohort, expected a new folder or --force");
  std::error_code error;
  fs::create_directory(path_, error);
  if (error) throw InputError(path_.string(), 0, "cannot be made: " + error.message());
  require_writable_output(path_ / "cohort.list", true);
  store(path_ / "cohort.list", list.text);
}

fs::path CohortFolder::fit_file(const std::string& subject) const {
  return path_ / (subject + ".h5");
}
fs::path CohortFolder::summary_file(const std::string& subject) const {
  return path_ / (subject + ".json");
}

std::optional<std::string> CohortFolder::summary(const std::string& subject) const {
  if (!fs::exists(summary_file(subject)) || !is_complete(fit_file(subject))) return std::nullopt;
  return read_text_file(summary_file(subject), longest_summary);
}

void CohortFolder::store_summary(const std::string& subject, const std::string& text) const {
  store(summary_file(subject), text);
}
void CohortFolder::store_table(const std::string& text) const {
  store(table_file(), text);
}

}  // namespace trunk
