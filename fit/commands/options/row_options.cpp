#include "commands/options/row_options.hpp"

#include <algorithm>
#include <sstream>

#include "commands/options/fit_options.hpp"
#include "errors/input_error.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

/// Returns the path of a file that the list names: relative to the list.
std::string beside_list(const std::filesystem::path& list, const std::string& file) {
  return (list.parent_path() / file).string();
}

/// Returns a cell as the option of a command line; files are relative to the list.
std::string argument(const std::filesystem::path& list, const std::string& option, const std::string& value) {
  if (option == "trace" || option == "predict") return "--" + option + "=" + beside_list(list, value);
  const auto at = value.find("=@");
  if (option == "fix" && at != std::string::npos)
    return "--fix=" + value.substr(0, at + 2) + beside_list(list, value.substr(at + 2));
  return "--" + option + "=" + value;
}

}  // namespace

RowOptions::RowOptions(const CohortList& list, const FitRequest& for_all) : list_(list), for_all_(for_all) {
  options_.set_help_flag();
  add_subject_options(options_, request_);
  require_columns();
  for (const CohortSubject& subject : list.subjects) request(subject);
}

void RowOptions::require_columns() {
  std::string known = "subject, scenario";
  for (const CLI::Option* option : options_.get_options())
    for (const std::string& name : option->get_lnames())
      if (name != "scenario") known += ", " + name;
  for (const std::string& column : list_.columns)
    if (column != "subject" && column != "scenario" && !options_.get_option_no_throw("--" + column))
      throw InputError({list_.path.string(), list_.header_line},
                       "column " + excerpt(column) + " is no option of `trunk fit`",
                       "only columns among " + known);
}

std::vector<std::string> RowOptions::arguments(const CohortSubject& subject) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < list_.columns.size(); ++i) {
    const std::string &column = list_.columns[i], &value = subject.cells[i];
    if (value.empty() || column == "subject" || column == "scenario") continue;
    if (options_.get_option("--" + column)->get_expected_max() <= 1) {
      result.push_back(argument(list_.path, column, value));
      continue;
    }
    std::istringstream several(value);  // an option that may be repeated: values between blanks
    for (std::string one; several >> one;) result.push_back(argument(list_.path, column, one));
  }
  std::reverse(result.begin(), result.end());  // as CLI11 takes them
  return result;
}

FitRequest RowOptions::request(const CohortSubject& subject) {
  const std::lock_guard lock(mutex_);
  request_ = for_all_;
  try {
    options_.parse(arguments(subject));
  } catch (const CLI::ParseError& error) {
    throw InputError({list_.path.string(), subject.line}, error.what());
  }
  const auto scenario = std::find(list_.columns.begin(), list_.columns.end(), "scenario");
  if (scenario != list_.columns.end())
    if (const auto& file = subject.cells[static_cast<std::size_t>(scenario - list_.columns.begin())];
        !file.empty())
      request_.scenario = beside_list(list_.path, file);
  return request_;
}

}  // namespace trunk
