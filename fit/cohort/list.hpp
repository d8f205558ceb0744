#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace trunk {

/// A subject of a cohort, with the cells of its row as text.
struct CohortSubject {
  std::string name;
  std::size_t line = 0;
  std::vector<std::string> cells;  // [columns]; "" if the row leaves the cell empty
};

/// A cohort as its list gives it: a column `subject`, and others by name.
struct CohortList {
  std::filesystem::path path;
  std::string text;
  std::size_t header_line = 0;
  std::vector<std::string> columns;
  std::vector<CohortSubject> subjects;

  static constexpr std::size_t max_subjects = 100'000;
};

/// Returns the list in a file (delimited text with a header). Subjects become names of files: 1 to 100
/// characters, no '/',
/// '\' or control character, not beginning with one of . - + = @ (a formula to a spreadsheet), each once.
/// Throws InputError with file and line.
CohortList read_cohort_list(const std::filesystem::path& path);

}  // namespace trunk
