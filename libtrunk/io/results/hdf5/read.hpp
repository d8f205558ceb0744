#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "results/hdf5/id.hpp"

/// Private to the results layer: reading files that may be damaged or made to harm. All throw Error.
namespace trunk::hdf5 {

bool has_link(hid_t group, const std::string& name);
bool has_attribute(hid_t object, const std::string& name);

/// The text, or for a whole number its digits.
std::string read_attribute(hid_t object, const std::string& name);

/// Empty when there is none.
std::string read_attribute_if_any(hid_t object, const std::string& name);

std::vector<std::string> attribute_names(hid_t object);

std::vector<std::string> link_names(hid_t group);

/// Nothing that lies in another file, or is reached by a link that could lead to one.
Group open_group(hid_t group, const std::string& path);
Dataset open_dataset(hid_t group, const std::string& path);
std::vector<hsize_t> shape_of(hid_t dataset);

/// All values, row-major.
std::vector<double> read_doubles(hid_t group, const std::string& path);
std::vector<std::int64_t> read_integers(hid_t group, const std::string& path);
/// One text; throws Error where its checksum does not agree.
std::string read_text(hid_t group, const std::string& path);
std::vector<std::string> read_texts(hid_t group, const std::string& path);

/// Reads a dataset through, so that its checksums are tested, and forgets the values.
void verify(hid_t dataset, const std::string& path);

/// Calls `visit` for each group and dataset below `group` once, in the order written, with its first path
/// from there. Follows neither links to other files nor soft links.
void walk(hid_t group,
          const std::function<void(hid_t object, H5I_type_t kind, const std::string& path)>& visit);

}  // namespace trunk::hdf5
