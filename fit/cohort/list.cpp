#include "cohort/list.hpp"

#include <algorithm>
#include <map>

#include "errors/input_error.hpp"
#include "files/read_file.hpp"
#include "tables/delimited_text.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

constexpr std::size_t max_file_bytes = 50'000'000, longest_name = 100;

void require_file_name(const DelimitedText& table, std::size_t line, const std::string& name) {
  const auto odd = [](unsigned char c) { return c < 32 || c == 127 || c == '/' || c == '\\'; };
  const bool fits = !name.empty() && name.size() <= longest_name &&
                    std::string_view(".-+=@").find(name.front()) == std::string_view::npos &&
                    name != "cohort" && std::none_of(name.begin(), name.end(), odd);
  if (fits) return;
  throw InputError(
      {table.source(), line},
      name.empty() ? "this row names no subject" : "subject " + excerpt(name) + " cannot name a result file",
      "1 to 100 characters without a slash, which do not begin with one of . - + = @ and are not "
      "'cohort'");
}

std::vector<std::string> distinct_columns(const DelimitedText& table) {
  const auto& names = table.names();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
        names.begin() + static_cast<std::ptrdiff_t>(i))
      throw InputError({table.source(), table.header_line()}, "column " + excerpt(names[i]) + " stands twice",
                       "each column once");
  return names;
}

}  // namespace

CohortList read_cohort_list(const std::filesystem::path& path) {
  CohortList list;
  list.path = path;
  list.text = read_text_file(path, max_file_bytes);
  DelimitedText table(path.string(), list.text, &list_layout);
  list.header_line = table.header_line();
  list.columns = distinct_columns(table);
  const auto subject = std::find(list.columns.begin(), list.columns.end(), "subject");
  if (subject == list.columns.end())
    throw InputError({table.source(), table.header_line()}, "there is no column 'subject'",
                     "a header such as subject,trace");
  const auto at = static_cast<std::size_t>(subject - list.columns.begin());
  std::map<std::string, std::size_t> lines;
  for (DelimitedText::Row row; table.next(row);) {
    CohortSubject s{"", row.line, {row.cells.begin(), row.cells.end()}};
    s.cells.resize(list.columns.size());
    s.name = s.cells[at];
    require_file_name(table, row.line, s.name);
    if (const auto [first, is_new] = lines.emplace(s.name, row.line); !is_new)
      throw InputError(
          {table.source(), row.line},
          "subject " + excerpt(s.name) + " stands in line " + std::to_string(first->second) + " as well",
          "each subject once");
    list.subjects.push_back(std::move(s));
    if (list.subjects.size() > CohortList::max_subjects)
      throw InputError({table.source(), row.line},
                       "this is subject " + std::to_string(list.subjects.size()) + " of the list",
                       "at most " + std::to_string(CohortList::max_subjects) + " subjects",
                       "divide the list");
  }
  if (list.subjects.empty())
    throw InputError({table.source()}, "the list names no subject", "a row for each below the header");
  return list;
}

}  // namespace trunk
