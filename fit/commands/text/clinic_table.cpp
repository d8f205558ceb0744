#include "commands/text/clinic_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace trunk {
namespace {

struct Column {
  const char *name, *head, *unit, *words;
};
constexpr std::array columns{
    Column{"pleural_swing_cmH2O", "dPpl", "cmH2O", "pleural pressure swings by"},
    Column{"gastric_swing_cmH2O", "dPga", "cmH2O", "gastric pressure swings by"},
    Column{"transdiaphragmatic_swing_cmH2O", "dPdi", "cmH2O", "transdiaphragmatic pressure swings by"},
    Column{"work_of_breathing_J_per_L", "WOB", "J/L", "inspiratory work of breathing"},
    Column{"pressure_time_product_pleural_cmH2O_s_per_min", "PTPpl", "/min",
           "pressure-time product, pleural"},
    Column{"pressure_time_product_transdiaphragmatic_cmH2O_s_per_min", "PTPdi", "/min",
           "pressure-time product, transdiaphragmatic"},
    Column{"tension_time_index", "TTdi", "1", "tension-time index"},
    Column{"dynamic_lung_compliance_ml_per_cmH2O", "Cdyn", "ml/cm", "dynamic lung compliance"},
    Column{"lung_resistance_cmH2O_s_per_L", "R", "cm s/L", "lung resistance"},
    Column{"intrinsic_peep_cmH2O", "PEEPi", "cmH2O", "intrinsic PEEP"}};

using Value = std::function<double(const ClinicNumber&)>;

// Returns every doubt once, a line each.
std::string doubts_of(const std::vector<ClinicNumber>& numbers) {
  std::string text;
  for (const ClinicNumber& n : numbers)
    if (!n.doubt.empty() && text.find(n.doubt) == std::string::npos)
      text += "  Do not trust the resistance and the work against it: " + n.doubt + ".\n";
  return text;
}

std::string cell(double value) {
  return std::isnan(value) ? "-" : fmt::format("{:.3g}", value);
}

}  // namespace

std::string clinic_table(const std::vector<ClinicNumber>& numbers, const std::vector<Breath>& used) {
  std::vector<const ClinicNumber*> shown;
  std::string heads = "  breath    ", units = "            ";
  for (const Column& column : columns)
    for (const ClinicNumber& number : numbers)
      if (number.name == column.name) {
        shown.push_back(&number);
        heads += fmt::format(" {:>7}", column.head), units += fmt::format(" {:>7}", column.unit);
      }
  if (shown.empty()) return "";
  const auto row = [&](const std::string& head, const Value& value) {
    std::string text = fmt::format("  {:<10}", head);
    for (const ClinicNumber* number : shown) text += fmt::format(" {:>7}", cell(value(*number)));
    return text + "\n";
  };
  std::string text = heads + "\n" + units + "\n";
  for (std::size_t b = 0; b < used.size(); ++b)
    text += row(std::to_string(used[b].number), [b](const ClinicNumber& n) { return n.each[b]; });
  text += row("mean", [](const ClinicNumber& n) { return n.mean; });
  text += row("95 % from", [](const ClinicNumber& n) { return n.lower95; });
  text += row("     to", [](const ClinicNumber& n) { return n.upper95; });
  return text + row("mean curve", [](const ClinicNumber& n) { return n.of_mean_breath; }) +
         doubts_of(numbers);
}

std::string clinic_lines(const std::vector<ClinicNumber>& numbers) {
  std::string text;
  for (const Column& column : columns)
    for (const ClinicNumber& n : numbers)
      if (n.name == column.name)
        text += fmt::format("  {:<42}{:>8}  {:>18}  {}\n", column.words, cell(n.mean),
                            fmt::format("{} to {}", cell(n.lower95), cell(n.upper95)),
                            n.unit == "1" ? "" : n.unit);
  return text.empty() ? "" : "measured, mean over breaths with 95 % interval\n" + text + doubts_of(numbers);
}

}  // namespace trunk
