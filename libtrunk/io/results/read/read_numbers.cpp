#include "results/read/read_numbers.hpp"

#include "results/hdf5/read.hpp"

namespace trunk::layout {

std::vector<NamedValue> read_numbers(hid_t root, const std::string& group) {
  std::vector<NamedValue> numbers;
  const hdf5::Group source = hdf5::open_group(root, group);
  hdf5::walk(source, [&](hid_t object, H5I_type_t kind, const std::string& name) {
    if (kind != H5I_DATASET || !hdf5::shape_of(object).empty()) return;
    if (!hdf5::has_attribute(object, "units")) return;  // a text
    const auto value = hdf5::read_doubles(source, name);
    if (value.size() == 1) numbers.push_back({name, hdf5::read_attribute(object, "units"), value.front()});
  });
  return numbers;
}

std::vector<NamedValue> read_best_parameters(hid_t root) {
  const auto names = hdf5::read_texts(root, "parameters/name");
  const auto units = hdf5::read_texts(root, "parameters/unit");
  const auto best = hdf5::read_doubles(root, "parameters/best");
  if (units.size() != names.size() || best.size() != names.size()) {
    throw hdf5::Error("the columns of its parameters differ in length");
  }
  std::vector<NamedValue> parameters;
  for (std::size_t i = 0; i < names.size(); ++i) parameters.push_back({names[i], units[i], best[i]});
  return parameters;
}

}  // namespace trunk::layout
