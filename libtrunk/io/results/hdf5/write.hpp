#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/hdf5/id.hpp"

/// Private to the results layer: writing. All data have checksums (fletcher32, or that of the object header),
/// CF `units` and `long_name`, and a dimension scale on every axis, but no times of creation. All functions
/// throw Error.
namespace trunk::hdf5 {

/// The name and the meaning of a dataset. `units` is empty if it is not a quantity (texts, codes).
struct Label {
  std::string name, units, long_name;
};

/// A dimension scale: one axis of other datasets, and its coordinates.
struct Axis {
  Dataset scale;
  hsize_t size;
};
using Axes = std::initializer_list<std::reference_wrapper<const Axis>>;

Group create_group(hid_t parent, const std::string& name);

/// Gives an object of the same file a second name.
void link_again(hid_t from, const std::string& object_path, hid_t to, const std::string& name);

void write_attribute(hid_t object, const std::string& name, std::string_view text);
void write_attribute(hid_t object, const std::string& name, const char* text);
void write_attribute(hid_t object, const std::string& name, std::span<const std::string> texts);
void write_attribute(hid_t object, const std::string& name, std::span<const std::int32_t> values);
void write_attribute(hid_t object, const std::string& name, std::span<const std::int64_t> values);
void write_attribute(hid_t object, const std::string& name, std::int32_t value);
void write_attribute(hid_t object, const std::string& name, std::int64_t value);
void write_attribute(hid_t object, const std::string& name, std::uint64_t value);

/// Writes text without a final zero, as VTK needs it.
void write_ascii_attribute(hid_t object, const std::string& name, const std::string& text);

/// Writes an array over `axes`, row-major. Value is double, std::int32_t, std::int64_t or std::string.
template <typename Value>
Dataset write_array(hid_t group, const Label&, std::span<const Value> values, Axes axes);

template <typename Value>
Dataset write_array(hid_t group, const Label& label, const std::vector<Value>& values, Axes axes) {
  return write_array(group, label, std::span<const Value>(values), axes);
}

/// Writes a virtual dataset: the numbers of the dataset `source` below `source_group`, in the same order over
/// other `axes`. No number is copied.
Dataset write_view(hid_t group, const Label&, hid_t source_group, const std::string& source, Axes axes);

/// Writes an array of doubles over two axes that need not fit into memory: it calls `fill(first, rows)` for
/// some rows at a time.
using FillRows = std::function<void(std::size_t first, std::span<double> rows)>;
Dataset write_rows(hid_t group, const Label&, const FillRows& fill, const Axis& rows, const Axis& columns);

/// Writes a one-dimensional array that is an axis.
template <typename Value>
Axis write_axis(hid_t group, const Label&, const std::vector<Value>& coordinates);

/// Writes the axis 0, 1 … size-1.
Axis write_count_axis(hid_t group, const Label&, std::size_t size);

/// Writes a single number.
void write_number(hid_t group, const Label&, double value);

/// Writes a text of any length, with its SHA-256 as an attribute.
void write_text(hid_t group, const Label&, const std::string& text);

/// Writes an attribute that is a reference to the object at `object_path` below `group`.
void refer_to(hid_t object, const std::string& name, hid_t group, const std::string& object_path);

/// Writes the meanings of the codes 0, 1 … of a dataset (CF flag_values and flag_meanings).
void write_flags(hid_t dataset, const std::vector<std::string>& meanings);

}  // namespace trunk::hdf5
