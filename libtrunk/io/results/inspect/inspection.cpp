#include "results/inspect/inspection.hpp"

#include <map>

#include "results/hdf5/read.hpp"
#include "results/read/open_results.hpp"
#include "results/read/read_numbers.hpp"
#include "results/read/read_parts.hpp"

namespace trunk::layout {
namespace {

std::string type_name(hid_t dataset) {
  const hdf5::Type type(H5Dget_type(dataset), "read a type");
  const std::string bits = std::to_string(H5Tget_size(type) * 8);
  switch (H5Tget_class(type)) {
    case H5T_FLOAT:
      return "float" + bits;
    case H5T_INTEGER:
      return "int" + bits;
    case H5T_STRING:
      return "text";
    default:
      return "other";
  }
}

DatasetInfo info_of(hid_t dataset, const std::string& path) {
  const auto shape = hdf5::shape_of(dataset);
  return {path,
          hdf5::read_attribute_if_any(dataset, "units"),
          hdf5::read_attribute_if_any(dataset, "long_name"),
          type_name(dataset),
          {shape.begin(), shape.end()},
          H5Dget_storage_size(dataset)};
}

void add_texts(hid_t object, const std::vector<std::string>& names,
               std::vector<std::pair<std::string, std::string>>& to) {
  for (const std::string& name : names) {
    std::string text = hdf5::read_attribute_if_any(object, name);
    if (!text.empty()) to.emplace_back(name, std::move(text));
  }
}

void add_run(hid_t root, Inspection& file) {
  file.parameters = read_numbers(root, "parameters");
  file.measures = read_numbers(root, "measures");
}

void add_fit(hid_t root, Inspection& file) {
  const hdf5::Group result(H5Gopen2(root, "result", H5P_DEFAULT), "open result");
  if (hdf5::has_link(root, "results")) {
    add_texts(hdf5::open_group(root, "results"), {"grade"}, file.heading);
    add_texts(hdf5::open_group(root, "problem"), {"input"}, file.heading);
  }
  add_texts(result, {"verdict", "stop_reason", "algorithm"}, file.heading);
  read_estimates(root, file.fit);
  read_results_of_fit(root, file.fit);
  if (hdf5::has_link(result, "notes")) file.fit.notes = hdf5::read_texts(result, "notes");
  file.statistics = read_numbers(root, "result/statistics");
  file.measures = read_numbers(root, "best_run/measures");
}

void add_sweep(hid_t root, Inspection& file) {
  std::map<std::string, std::size_t> counts;
  for (const std::string& status : hdf5::read_texts(root, "table/status")) ++counts[status];
  file.run_status.assign(counts.begin(), counts.end());
}

void add_provenance(hid_t root, Inspection& file) {
  const hdf5::Group provenance(H5Gopen2(root, "provenance", H5P_DEFAULT), "open provenance");
  add_texts(provenance, hdf5::attribute_names(provenance), file.provenance);
}

void add_datasets(hid_t root, Inspection& file) {
  hdf5::walk(root, [&](hid_t object, H5I_type_t kind, const std::string& path) {
    if (kind != H5I_DATASET) return;
    hdf5::verify(object, path);
    file.datasets.push_back(info_of(object, path));
  });
}

}  // namespace

Inspection inspect_results(const std::filesystem::path& path) {
  Inspection file;
  read_results(path, [&](hid_t root, const std::string& kind) {
    file.kind = kind;
    file.file_bytes = std::filesystem::file_size(path);
    add_texts(root, {"title", "status", "message"}, file.heading);
    if (kind == "run") add_run(root, file);
    if (kind == "fit") add_fit(root, file);
    if (kind == "sweep") add_sweep(root, file);
    add_provenance(root, file);
    add_datasets(root, file);
  });
  return file;
}

}  // namespace trunk::layout
