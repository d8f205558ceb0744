#include "commands/cohort_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "errors/input_error.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

/// A file as the list names it, seen from here.
std::string beside_list(const std::filesystem::path& list, const std::string& file) {
  return (list.parent_path() / file).string();
}

/// A value of an option as the list gives it; those that name files are seen from here.
std::string argument(const std::filesystem::path& list, const std::string& option, const std::string& value) {
  if (option == "trace" || option == "predict") return "--" + option + "=" + beside_list(list, value);
  const auto at = value.find("=@");
  if (option == "fix" && at != std::string::npos)
    return "--fix=" + value.substr(0, at + 2) + beside_list(list, value.substr(at + 2));
  return "--" + option + "=" + value;
}

double number_in(const Json& json, const char* key) {
  const auto at = json.find(key);
  return at != json.end() && at->is_number() ? at->get<double>() : std::nan("");
}

void add_interval(const Json& estimate, const std::string& name, CohortRow& row) {
  const std::string unit = estimate.value("unit", "");
  row.numbers.push_back({name, unit, number_in(estimate, "value")});
  // At a bound the interval of a linear model means nothing.
  const bool at_bound = estimate.value("at_bound", false);
  const auto end = [&](const char* key) { return at_bound ? std::nan("") : number_in(estimate, key); };
  row.numbers.push_back({name + "_lower95", unit, end("lower95")});
  row.numbers.push_back({name + "_upper95", unit, end("upper95")});
  row.numbers.push_back({name + "_at_bound", "1", at_bound ? 1.0 : 0.0});
}

/// "4013 (3800 to 4240)"
std::string interval_text(const CohortRow& row, const std::string& name) {
  const auto number = [&](const std::string& wanted) {
    for (const NamedValue& v : row.numbers)
      if (v.name == wanted) return v.value;
    return std::nan("");
  };
  const double value = number(name);
  if (!std::isfinite(value)) return "-";
  if (number(name + "_at_bound") == 1.0) return fmt::format("{:.4g} (AT BOUND)", value);
  return fmt::format("{:.4g} ({} to {})", value, shown(number(name + "_lower95"), "{:.4g}"),
                     shown(number(name + "_upper95"), "{:.4g}"));
}

}  // namespace

CohortRows::CohortRows(const CohortList& list, const FitRequest& for_all) : list_(list), for_all_(for_all) {
  options_.set_help_flag();
  add_subject_options(options_, request_);
  require_columns();
  for (const CohortSubject& subject : list.subjects) request(subject);
}

void CohortRows::require_columns() {
  std::string known = "subject, scenario";
  for (const CLI::Option* option : options_.get_options())
    for (const std::string& name : option->get_lnames())
      if (name != "scenario") known += ", " + name;
  for (const std::string& column : list_.columns)
    if (column != "subject" && column != "scenario" && !options_.get_option_no_throw("--" + column))
      throw InputError(list_.path.string(), list_.header_line,
                       fmt::format("column {} found; expected subject, trace and options of `trunk fit`: {}",
                                   excerpt(column), known));
}

std::vector<std::string> CohortRows::arguments(const CohortSubject& subject) {
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

FitRequest CohortRows::request(const CohortSubject& subject) {
  const std::lock_guard lock(mutex_);
  request_ = for_all_;
  try {
    options_.parse(arguments(subject));
  } catch (const CLI::ParseError& error) {
    throw InputError(list_.path.string(), subject.line, error.what());
  }
  const auto scenario = std::find(list_.columns.begin(), list_.columns.end(), "scenario");
  if (scenario != list_.columns.end())
    if (const auto& file = subject.cells[static_cast<std::size_t>(scenario - list_.columns.begin())];
        !file.empty())
      request_.scenario = beside_list(list_.path, file);
  return request_;
}

CohortRow cohort_row(const std::string& subject, const Json& fit) {
  CohortRow row;
  row.subject = subject;
  row.status = fit.at("status").get<std::string>();
  row.identifiable = fit.at("identifiable").get<bool>();
  row.verdict = fit.at("verdict").get<std::string>();
  for (const auto& [name, estimate] : fit.at("parameters").items()) add_interval(estimate, name, row);
  if (fit.contains("ratio")) add_interval(fit["ratio"], "ratio", row);
  for (const char* key : {"nrmse_percent", "baseline_nrmse_percent", "tidal_volume_measured_ml",
                          "breaths_used", "breaths_rejected"})
    row.numbers.push_back({key, "", number_in(fit, key)});
  if (!fit.contains("predictions")) return row;
  for (const Json& p : fit["predictions"]) {
    const std::string name = p.at("name").get<std::string>();
    add_interval(p.at("delta_v_ml"), name + "_delta_v_ml", row);
    add_interval(p.at("ratio_percent"), name + "_percent", row);
    row.numbers.push_back({name + "_failed_draws", "1", number_in(p, "failed")});
  }
  return row;
}

std::string cohort_table(const std::vector<CohortRow>& rows) {
  std::size_t width = 7;
  std::vector<std::string> names;  // of what some subject has an estimate of, in percent or a parameter
  for (const CohortRow& row : rows) {
    width = std::max(width, row.subject.size());
    for (const NamedValue& v : row.numbers) {
      if (!v.name.ends_with("_lower95") || v.name.ends_with("_ml_lower95")) continue;
      const std::string name = v.name.substr(0, v.name.size() - 8);
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  std::string text = fmt::format("  {:<{}}  {:<16}", "subject", width, "status");
  for (const std::string& name : names) text += fmt::format("  {:<32}", name);
  for (const CohortRow& row : rows) {
    text += fmt::format("\n  {:<{}}  {:<16}", row.subject, width, row.status);
    if (row.status == "failed")
      text += "  " + row.error;
    else
      for (const std::string& name : names) text += fmt::format("  {:<32}", interval_text(row, name));
  }
  return text;
}

}  // namespace trunk
