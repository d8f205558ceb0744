#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "results/hdf5/id.hpp"

/// Private to the results layer: reading files that may be damaged or malicious. All functions throw Error.
namespace trunk::hdf5 {

bool has_link(hid_t group, const std::string& name);
bool has_attribute(hid_t object, const std::string& name);

/// Returns the text of an attribute, or the digits of a whole number.
std::string read_attribute(hid_t object, const std::string& name);

/// Returns the same, or "" if there is no such attribute.
std::string read_attribute_if_any(hid_t object, const std::string& name);

std::vector<std::string> attribute_names(hid_t object);

std::vector<std::string> link_names(hid_t group);

/// Open a group or dataset; throw Error if it is in another file, or behind a link that may lead to one.
Group open_group(hid_t group, const std::string& path);
Dataset open_dataset(hid_t group, const std::string& path);
std::vector<hsize_t> shape_of(hid_t dataset);

/// Return all values, row-major.
std::vector<double> read_doubles(hid_t group, const std::string& path);
std::vector<std::int64_t> read_integers(hid_t group, const std::string& path);
/// Return one text, or an array of texts; throw Error if the checksum does not match.
std::string read_text(hid_t group, const std::string& path);
std::vector<std::string> read_texts(hid_t group, const std::string& path);

/// Reads a whole dataset to check its checksums, and discards the values.
void verify(hid_t dataset, const std::string& path);

/// Calls `visit` once for each group and dataset below `group`, in the order of writing, with its first path
/// from `group`. Follows neither links to other files nor soft links.
void walk(hid_t group,
          const std::function<void(hid_t object, H5I_type_t kind, const std::string& path)>& visit);

}  // namespace trunk::hdf5
