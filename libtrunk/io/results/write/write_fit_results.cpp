#include <algorithm>

#include "results/hdf5/write.hpp"
#include "results/write/layout.hpp"

namespace trunk {
namespace {

using hdf5::Axis, hdf5::create_group, hdf5::Group, hdf5::write_array, hdf5::write_axis;
using Result = FitRecord::Result;

template <typename Value>
std::vector<Value> column(const std::vector<Result>& results, Value Result::*member) {
  std::vector<Value> values;
  for (const Result& r : results) values.push_back(r.*member);
  return values;
}

void write_table(hid_t group, const std::vector<Result>& results) {
  const Axis name = write_axis(group, {"name", "", "result"}, column(results, &Result::name));
  std::vector<std::string> units = column(results, &Result::unit);
  for (std::string& unit : units) unit = layout::file_unit(unit);
  write_array(group, {"unit", "", "unit of the result"}, units, {name});
  const auto numbers = [&](const char* what, const std::string& meaning, double Result::*member) {
    write_array(group, {what, "", meaning + ", in the unit that `unit` gives"}, column(results, member),
                {name});
  };
  numbers("value", "best value; NaN: withheld", &Result::value);
  numbers("lower95", "lower end of the 95 % interval; -inf: no limit", &Result::lower95);
  numbers("upper95", "upper end of the 95 % interval; inf: no limit", &Result::upper95);
  const auto texts = [&](const char* what, const char* meaning, std::string Result::*member) {
    write_array(group, {what, "", meaning}, column(results, member), {name});
  };
  texts("grade", "how far the result can be trusted", &Result::grade);
  texts("assumption", "what the interval stands on", &Result::assumption);
  texts("reason", "why the result is not determined", &Result::reason);
  texts("meaning", "what the result says", &Result::meaning);
  if (std::any_of(results.begin(), results.end(), [](const Result& r) { return !r.rests_on.empty(); }))
    texts("rests_on", "shares of what was measured, and of priors, in what is known of the result",
          &Result::rests_on);
  write_array(group, {"headline", "1", "place among the results that are shown first, from 1; 0: none"},
              column(results, &Result::headline), {name});
}

}  // namespace

void layout::write_results(hid_t root, const FitRecord& fit) {
  const Group results = create_group(root, "results");
  hdf5::write_attribute(results, "grade", fit.grade);
  write_table(results, fit.results);
  if (!fit.gates.empty()) {
    const Group gates = create_group(results, "gates");
    std::vector<std::string> names, sentences;
    for (const FitRecord::Gate& gate : fit.gates) {
      names.push_back(gate.name);
      sentences.push_back(gate.sentence);
    }
    const Axis name = write_axis(gates, {"name", "", "gate"}, names);
    write_array(gates, {"sentence", "", "what stands against the fit"}, sentences, {name});
  }
  if (fit.straight.empty()) return;
  const Group straight = create_group(results, "straight_activation");
  write_table(straight, fit.straight);
  write_numbers(straight, {{"nrmse_percent", "percent", fit.straight_nrmse_percent}});
}

}  // namespace trunk
