#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/hdf5/id.hpp"

/// Private to the results layer: what is written is checksummed (data by fletcher32 or in a
/// checksummed object header), carries CF `units` and `long_name`, has a dimension scale on every
/// axis, and no times. All functions throw Error.
namespace trunk::hdf5 {

/// How a dataset is called and what it means. Empty `units` = not a quantity (text, codes).
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

/// A second name for an object of the same file.
void link_again(hid_t from, const std::string& target, hid_t to, const std::string& name);

void write_attribute(hid_t object, const std::string& name, std::string_view text);
void write_attribute(hid_t object, const std::string& name, const char* text);
void write_attribute(hid_t object, const std::string& name, std::span<const std::string> texts);
void write_attribute(hid_t object, const std::string& name, std::span<const std::int32_t> values);
void write_attribute(hid_t object, const std::string& name, std::span<const std::int64_t> values);
void write_attribute(hid_t object, const std::string& name, std::int32_t value);
void write_attribute(hid_t object, const std::string& name, std::int64_t value);
void write_attribute(hid_t object, const std::string& name, std::uint64_t value);

/// Text without an end sign, as VTK wants it.
void write_ascii_attribute(hid_t object, const std::string& name, const std::string& text);

/// An array over `axes`, row-major. Value is double, std::int32_t, std::int64_t or std::string.
template <typename Value>
Dataset write_array(hid_t group, const Label&, std::span<const Value> values, Axes axes);

template <typename Value>
Dataset write_array(hid_t group, const Label& label, const std::vector<Value>& values, Axes axes) {
  return write_array(group, label, std::span<const Value>(values), axes);
}

/// The numbers of another dataset of the file, `source` seen from `group`, in the same order over other
/// `axes`: none are copied (an HDF5 virtual dataset).
Dataset write_view(hid_t group, const Label&, hid_t source_group, const std::string& source, Axes axes);

/// An array of doubles over two axes that need not be in memory as a whole: `fill(first, rows)` is asked for
/// some rows, from the first on, after the other.
using FillRows = std::function<void(std::size_t first, std::span<double> rows)>;
Dataset write_rows(hid_t group, const Label&, const FillRows& fill, const Axis& rows, const Axis& columns);

/// A one-dimensional array that is an axis itself.
template <typename Value>
Axis write_axis(hid_t group, const Label&, const std::vector<Value>& coordinates);

/// The axis 0, 1 … size-1.
Axis write_count_axis(hid_t group, const Label&, std::size_t size);

/// A single number.
void write_number(hid_t group, const Label&, double value);

/// A text of any length, with its sha256 as an attribute.
void write_text(hid_t group, const Label&, const std::string& text);

/// An attribute that is a reference to the object `target`, seen from `group`.
void refer_to(hid_t object, const std::string& name, hid_t group, const std::string& target);

/// Says what the codes 0, 1 … of a dataset mean (CF flag_values, flag_meanings).
void write_flags(hid_t dataset, const std::vector<std::string>& meanings);

}  // namespace trunk::hdf5
