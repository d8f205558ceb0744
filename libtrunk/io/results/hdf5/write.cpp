#include "results/hdf5/write.hpp"

#include <hdf5_hl.h>

#include <algorithm>
#include <numeric>

#include "files/sha256.hpp"
#include "results/hdf5/types.hpp"

namespace trunk::hdf5 {
namespace {

constexpr hsize_t chunk_bytes = hsize_t{1} << 20;  // the default chunk cache holds one such chunk
constexpr hsize_t frames_per_chunk = 64;
constexpr hsize_t bytes_at_once = hsize_t{32} << 20;

void check_name(const std::string& name) {
  if (name.empty() || name == "." || name.find('/') != std::string::npos) {
    throw Error("cannot write a dataset named '" + name + "': names are not empty and have no '/'");
  }
}

Properties dataset_properties() {
  Properties properties(H5Pcreate(H5P_DATASET_CREATE), "prepare a dataset");
  require(H5Pset_obj_track_times(properties, false), "leave times out");
  return properties;
}

/// Returns chunks with few rows if a row is large, so that a reader of one frame need not decompress the
/// whole array.
std::vector<hsize_t> chunk_shape(std::vector<hsize_t> shape, std::size_t value_bytes) {
  hsize_t row_bytes = value_bytes;
  for (std::size_t axis = 1; axis < shape.size(); ++axis) {
    shape[axis] = std::max<hsize_t>(shape[axis], 1);
    row_bytes *= shape[axis];
  }
  const hsize_t most = shape.size() > 2 ? frames_per_chunk : chunk_bytes;
  shape[0] = std::clamp<hsize_t>(std::min(chunk_bytes / row_bytes, shape[0]), 1, most);
  return shape;
}

Properties filtered(const std::vector<hsize_t>& shape, std::size_t value_bytes) {
  Properties properties = dataset_properties();
  const auto chunk = chunk_shape(shape, value_bytes);
  require(H5Pset_chunk(properties, static_cast<int>(chunk.size()), chunk.data()), "choose chunks");
  require(H5Pset_shuffle(properties), "shuffle");
  // Level 2, since higher levels take 50 % longer and save only 2 %.
  require(H5Pset_deflate(properties, 2), "compress");
  require(H5Pset_fletcher32(properties), "add checksums");
  return properties;
}

void write_label(hid_t dataset, const Label& label) {
  if (!label.units.empty()) write_attribute(dataset, "units", label.units);
  if (!label.long_name.empty()) write_attribute(dataset, "long_name", label.long_name);
}

void attach(hid_t dataset, const Label& label, Axes axes) {
  unsigned dimension = 0;
  for (const Axis& axis : axes) {
    require(H5DSattach_scale(dataset, axis.scale, dimension++), "name the axes of " + label.name);
  }
}

std::string path_of(hid_t object) {
  const auto size = require(H5Iget_name(object, nullptr, 0), "name a dataset");
  std::string path(static_cast<std::size_t>(size) + 1, '\0');
  require(H5Iget_name(object, path.data(), path.size()), "name a dataset");
  path.pop_back();
  return path;
}

/// Returns the properties of datasets without filters: single values, and texts, whose bytes are elsewhere.
/// They are contiguous, since R's ncdf4 opens no file with a compact dataset.
Properties unfiltered() {
  Properties properties = dataset_properties();
  require(H5Pset_layout(properties, H5D_CONTIGUOUS), "choose a layout");
  return properties;
}

template <typename Value>
Dataset write_shape(hid_t group, const Label& label, std::span<const Value> values,
                    const std::vector<hsize_t>& shape) {
  check_name(label.name);
  const std::string doing = "write dataset " + label.name;
  const auto expected = std::accumulate(shape.begin(), shape.end(), hsize_t{1}, std::multiplies<>());
  if (values.size() != expected) {
    throw Error("cannot write dataset " + label.name + ": it has " + std::to_string(values.size()) +
                " values, its axes make " + std::to_string(expected));
  }
  const Packed<Value> packed(values);
  constexpr bool is_text = std::is_same_v<Value, std::string>;
  const Properties properties = is_text ? unfiltered() : filtered(shape, packed.value_bytes());
  const Space space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), doing);
  Dataset dataset(
      H5Dcreate2(group, label.name.c_str(), packed.file_type(), space, H5P_DEFAULT, properties, H5P_DEFAULT),
      doing);
  if (expected > 0) {
    require(H5Dwrite(dataset, packed.memory_type(), H5S_ALL, H5S_ALL, H5P_DEFAULT, packed.data()), doing);
  }
  write_label(dataset, label);
  if constexpr (is_text) {
    if (!values.empty()) write_attribute(dataset, "texts", values);
    write_attribute(dataset, "sha256", sha256_of_text(joined(values)));
  }
  return dataset;
}

Dataset write_scalar(hid_t group, const Label& label, hid_t file_type, hid_t memory_type, const void* value) {
  check_name(label.name);
  const std::string doing = "write dataset " + label.name;
  const Properties properties = unfiltered();
  const Space space(H5Screate(H5S_SCALAR), doing);
  Dataset dataset(
      H5Dcreate2(group, label.name.c_str(), file_type, space, H5P_DEFAULT, properties, H5P_DEFAULT), doing);
  require(H5Dwrite(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, value), doing);
  write_label(dataset, label);
  return dataset;
}

}  // namespace

Group create_group(hid_t parent, const std::string& name) {
  check_name(name);
  const Properties properties(H5Pcreate(H5P_GROUP_CREATE), "prepare a group");
  require(H5Pset_obj_track_times(properties, false), "leave times out");
  require(H5Pset_link_creation_order(properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED),
          "keep the order");
  return Group(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, properties, H5P_DEFAULT),
               "create group " + name);
}

void link_again(hid_t from, const std::string& object_path, hid_t to, const std::string& name) {
  require(H5Lcreate_hard(from, object_path.c_str(), to, name.c_str(), H5P_DEFAULT, H5P_DEFAULT),
          "link " + name);
}

template <typename Value>
Dataset write_array(hid_t group, const Label& label, std::span<const Value> values, Axes axes) {
  std::vector<hsize_t> shape;
  for (const Axis& axis : axes) shape.push_back(axis.size);
  Dataset dataset = write_shape(group, label, values, shape);
  attach(dataset, label, axes);
  return dataset;
}

Dataset write_view(hid_t group, const Label& label, hid_t source_group, const std::string& source,
                   Axes axes) {
  const std::string doing = "write dataset " + label.name;
  const Dataset original(H5Dopen2(source_group, source.c_str(), H5P_DEFAULT), "open " + source);
  const Space original_space(H5Dget_space(original), doing);
  const Type type(H5Dget_type(original), doing);
  std::vector<hsize_t> shape;
  for (const Axis& axis : axes) shape.push_back(axis.size);
  const Space space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), doing);
  Properties properties = dataset_properties();
  require(H5Pset_virtual(properties, space, ".", path_of(original).c_str(), original_space), doing);
  Dataset dataset(H5Dcreate2(group, label.name.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
                  doing);
  write_label(dataset, label);
  attach(dataset, label, axes);
  return dataset;
}

Dataset write_rows(hid_t group, const Label& label, const FillRows& fill, const Axis& rows,
                   const Axis& columns) {
  const std::string doing = "write dataset " + label.name;
  const std::vector<hsize_t> shape = {rows.size, columns.size};
  const Space space(H5Screate_simple(2, shape.data(), nullptr), doing);
  Dataset dataset(H5Dcreate2(group, label.name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT,
                             filtered(shape, sizeof(double)), H5P_DEFAULT),
                  doing);
  const hsize_t row_bytes = std::max<hsize_t>(1, columns.size * sizeof(double));
  const hsize_t at_once = std::max<hsize_t>({1, bytes_at_once / row_bytes, rows.size / 8});
  std::vector<double> values;
  for (hsize_t first = 0; columns.size > 0 && first < rows.size; first += at_once) {
    const hsize_t start[2] = {first, 0}, count[2] = {std::min(at_once, rows.size - first), columns.size};
    values.resize(count[0] * count[1]);
    fill(first, values);
    const Space part(H5Screate_simple(2, count, nullptr), doing);
    require(H5Sselect_hyperslab(space, H5S_SELECT_SET, start, nullptr, count, nullptr), doing);
    require(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, part, space, H5P_DEFAULT, values.data()), doing);
  }
  write_label(dataset, label);
  require(H5DSattach_scale(dataset, rows.scale, 0), "name the axes of " + label.name);
  require(H5DSattach_scale(dataset, columns.scale, 1), "name the axes of " + label.name);
  return dataset;
}

template <typename Value>
Axis write_axis(hid_t group, const Label& label, const std::vector<Value>& coordinates) {
  const hsize_t size = coordinates.size();
  Axis axis{write_shape(group, label, std::span<const Value>(coordinates), {size}), size};
  require(H5DSset_scale(axis.scale, label.name.c_str()), "make " + label.name + " an axis");
  return axis;
}

Axis write_count_axis(hid_t group, const Label& label, std::size_t size) {
  std::vector<std::int32_t> count(size);
  std::iota(count.begin(), count.end(), 0);
  return write_axis(group, label, count);
}

void write_number(hid_t group, const Label& label, double value) {
  write_scalar(group, label, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, &value);
}

void write_text(hid_t group, const Label& label, const std::string& text) {
  const Type type = text_type(text.size());
  const Dataset dataset = write_scalar(group, label, type, type, text.c_str());
  write_attribute(dataset, "sha256", sha256_of_text(text));
}

template Dataset write_array(hid_t, const Label&, std::span<const double>, Axes);
template Dataset write_array(hid_t, const Label&, std::span<const std::int32_t>, Axes);
template Dataset write_array(hid_t, const Label&, std::span<const std::int64_t>, Axes);
template Dataset write_array(hid_t, const Label&, std::span<const std::string>, Axes);
template Axis write_axis(hid_t, const Label&, const std::vector<double>&);
template Axis write_axis(hid_t, const Label&, const std::vector<std::int32_t>&);
template Axis write_axis(hid_t, const Label&, const std::vector<std::string>&);

}  // namespace trunk::hdf5
