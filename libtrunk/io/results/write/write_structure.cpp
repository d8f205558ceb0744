#include "results/write/layout.hpp"

namespace trunk::layout {

void write_structure(hid_t group, const Structure& s) {
  if (s.empty()) return;
  const hdf5::Group structure = hdf5::create_group(group, "structure");
  const auto texts = [&](const std::string& name, const std::string& meaning,
                         std::string Structure::Choice::*member, const hdf5::Axis& axis) {
    std::vector<std::string> all;
    for (const Structure::Choice& c : s.choices) all.push_back(c.*member);
    hdf5::write_array(structure, {name, "", meaning}, all, {axis});
  };
  const auto numbers = [&](const std::string& name, const std::string& meaning,
                           double Structure::Choice::*member, const hdf5::Axis& axis) {
    std::vector<double> all;
    for (const Structure::Choice& c : s.choices) all.push_back(c.*member);
    hdf5::write_array(structure, {name, "", meaning}, all, {axis});
  };
  if (!s.choices.empty()) {
    std::vector<std::string> names;
    for (const Structure::Choice& c : s.choices) names.push_back(c.name);
    const hdf5::Axis choice = hdf5::write_axis(structure, {"choice", "", "choice of the model"}, names);
    const hdf5::Axis measure =
        hdf5::write_axis(structure, {"measure", "", "number with a structural interval"}, s.measures);
    texts("keys", "its keys in a scenario", &Structure::Choice::keys, choice);
    texts("unit", "unit of its first key", &Structure::Choice::unit, choice);
    texts("source", "source of its range", &Structure::Choice::source, choice);
    numbers("low", "lower end of its range, in its unit", &Structure::Choice::low, choice);
    numbers("value", "the value of the scenario, in its unit", &Structure::Choice::value, choice);
    numbers("high", "upper end of its range, in its unit", &Structure::Choice::high, choice);
    hdf5::write_array(structure, {"share", "1", "part of the variance that a choice makes up"}, s.shares,
                      {measure, choice});
  }
  if (!s.left_out.empty())
    hdf5::write_axis(structure, {"left_out", "", "choices that were not varied, and why"}, s.left_out);
}

}  // namespace trunk::layout
