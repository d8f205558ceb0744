#include "results/hdf5/read.hpp"
#include "results/read/read_numbers.hpp"
#include "results/read/read_parts.hpp"

namespace trunk {
namespace {

using Result = FitRecord::Result;

/// Assigns a column of the table to the results. Throws hdf5::Error if it has another length.
template <typename Value, typename Member>
void fill(const std::vector<Value>& column, const std::string& path, Member Result::*member,
          std::vector<Result>& results) {
  if (column.size() != results.size()) throw hdf5::Error(path + " has the wrong length");
  for (std::size_t i = 0; i < column.size(); ++i) results[i].*member = static_cast<Member>(column[i]);
}

std::vector<Result> read_table(hid_t root, const std::string& group) {
  const auto path = [&](const char* column) { return group + "/" + column; };
  std::vector<Result> results(hdf5::read_texts(root, path("name")).size());
  for (const auto& [column, member] : {std::pair{"name", &Result::name},
                                       {"unit", &Result::unit},
                                       {"grade", &Result::grade},
                                       {"assumption", &Result::assumption},
                                       {"reason", &Result::reason},
                                       {"meaning", &Result::meaning}})
    fill(hdf5::read_texts(root, path(column)), path(column), member, results);
  if (hdf5::has_link(hdf5::open_group(root, group), "rests_on"))
    fill(hdf5::read_texts(root, path("rests_on")), path("rests_on"), &Result::rests_on, results);
  for (const auto& [column, member] :
       {std::pair{"value", &Result::value}, {"lower95", &Result::lower95}, {"upper95", &Result::upper95}})
    fill(hdf5::read_doubles(root, path(column)), path(column), member, results);
  fill(hdf5::read_doubles(root, path("headline")), path("headline"), &Result::headline, results);
  return results;
}

}  // namespace

std::vector<FitRecord::Gate> layout::read_gates_of_fit(hid_t root) {
  if (hdf5::read_attribute(root, "schema_version") == "1") return {};
  if (!hdf5::has_link(hdf5::open_group(root, "results"), "gates")) return {};
  const auto names = hdf5::read_texts(root, "results/gates/name"),
             sentences = hdf5::read_texts(root, "results/gates/sentence");
  if (sentences.size() != names.size()) throw hdf5::Error("results/gates/sentence has the wrong length");
  std::vector<FitRecord::Gate> gates;
  for (std::size_t i = 0; i < names.size(); ++i) gates.push_back({names[i], sentences[i]});
  return gates;
}

void layout::read_results_of_fit(hid_t root, FitRecord& fit) {
  if (hdf5::read_attribute(root, "schema_version") == "1") return;
  const hdf5::Group results = hdf5::open_group(root, "results");
  fit.input = hdf5::read_attribute_if_any(hdf5::open_group(root, "problem"), "input");
  fit.grade = hdf5::read_attribute(results, "grade");
  fit.results = read_table(root, "results");
  fit.gates = read_gates_of_fit(root);
  if (!hdf5::has_link(results, "straight_activation")) return;
  fit.straight = read_table(root, "results/straight_activation");
  for (const NamedValue& number : read_numbers(root, "results/straight_activation"))
    if (number.name == "nrmse_percent") fit.straight_nrmse_percent = number.value;
}

}  // namespace trunk
