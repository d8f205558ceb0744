#include "results/hdf5/read.hpp"

#include <algorithm>
#include <limits>

#include "files/sha256.hpp"
#include "results/hdf5/types.hpp"

namespace trunk::hdf5 {
namespace {

constexpr hsize_t best_compression = 2000;     // deflate reaches 1032
constexpr hsize_t largest = hsize_t{1} << 32;  // bytes; a curve of 10^7 steps has 80 MB

std::string up_to_padding(const char* bytes, std::size_t size) {
  return {bytes, std::find(bytes, bytes + size, '\0')};
}

bool is_fixed_text(hid_t type) {
  return H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) == 0;
}

/// Returns the number of bytes of all values. Throws Error if it is more than the file can hold, since a
/// small damaged file may declare petabytes.
std::size_t declared_bytes(hid_t dataset, hid_t type, const std::string& path) {
  const Space space(H5Dget_space(dataset), "read the shape of " + path);
  const auto values = static_cast<hsize_t>(require(H5Sget_simple_extent_npoints(space), "read " + path));
  const hsize_t value_bytes = H5Tget_size(type), stored = H5Dget_storage_size(dataset);
  if (value_bytes == 0 || values > std::numeric_limits<hsize_t>::max() / value_bytes ||
      values * value_bytes > largest || values * value_bytes / best_compression > stored) {
    throw Error("cannot read " + path + ": it declares more values than the file can hold");
  }
  return values * value_bytes;
}

template <typename Value>
std::vector<Value> read_as(hid_t dataset, hid_t memory_type, const std::string& path) {
  const Type type(H5Dget_type(dataset), "read the type of " + path);
  const std::size_t values = declared_bytes(dataset, type, path) / H5Tget_size(type);
  std::vector<Value> buffer(values * H5Tget_size(memory_type) / sizeof(Value));
  require(H5Dread(dataset, memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer.data()), "read " + path);
  return buffer;
}

void require_hash(hid_t dataset, const std::string& path, const std::string& text) {
  const std::string expected = read_attribute_if_any(dataset, "sha256");
  if (!expected.empty() && sha256_of_text(text) != expected) {
    throw Error("cannot read " + path + " (data error detected by its sha256)");
  }
}

/// Reads the copy of an array of texts that is safe to read; see free_text_type.
std::vector<std::string> read_text_copy(hid_t dataset, const std::string& path) {
  std::vector<std::string> texts;
  if (has_attribute(dataset, "texts")) {
    const std::string doing = "read the texts of " + path;
    const Attribute attribute(H5Aopen(dataset, "texts", H5P_DEFAULT), doing);
    const Type type(H5Aget_type(attribute), doing);
    if (!is_fixed_text(type)) throw Error("cannot " + doing + ": they are not of fixed length");
    const std::size_t width = H5Tget_size(type);
    std::vector<char> block(H5Aget_storage_size(attribute));
    require(H5Aread(attribute, type, block.data()), doing);
    for (std::size_t at = 0; at + width <= block.size(); at += width) {
      texts.push_back(up_to_padding(block.data() + at, width));
    }
  }
  require_hash(dataset, path, joined(texts));
  return texts;
}

/// Throws Error if the values are in another file. They could be in any file of the machine, and opening some
/// files never returns.
void require_own_values(hid_t dataset, const std::string& path) {
  const Properties properties(H5Dget_create_plist(dataset), "read the layout of " + path);
  if (H5Pget_layout(properties) == H5D_VIRTUAL || H5Pget_external_count(properties) != 0)
    throw Error("cannot read " + path + ": its values are elsewhere");
}

/// Throws Error if a part of the path is not in the file itself.
void require_own(hid_t group, const std::string& path) {
  for (std::size_t end = path.find('/');; end = path.find('/', end + 1)) {
    const std::string part = path.substr(0, end);
    H5L_info_t link{};
    require(H5Lget_info(group, part.c_str(), &link, H5P_DEFAULT), "find " + part);
    if (link.type != H5L_TYPE_HARD) throw Error("cannot open " + part + ": it is a link to somewhere else");
    if (end == std::string::npos) return;
  }
}

}  // namespace

bool has_link(hid_t group, const std::string& name) {
  return require(H5Lexists(group, name.c_str(), H5P_DEFAULT), "look for " + name) > 0;
}

bool has_attribute(hid_t object, const std::string& name) {
  return require(H5Aexists(object, name.c_str()), "look for attribute " + name) > 0;
}

std::string read_attribute(hid_t object, const std::string& name) {
  const std::string doing = "read attribute " + name;
  const Attribute attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), doing);
  const Space space(H5Aget_space(attribute), doing);
  const Type type(H5Aget_type(attribute), doing);
  if (H5Sget_simple_extent_npoints(space) != 1) throw Error("cannot " + doing + ": it is not a single value");
  if (is_fixed_text(type)) {
    std::vector<char> text(H5Tget_size(type));
    require(H5Aread(attribute, type, text.data()), doing);
    return up_to_padding(text.data(), text.size());
  }
  if (H5Tget_class(type) != H5T_INTEGER)
    throw Error("cannot " + doing + ": it is neither text nor whole number");
  std::uint64_t value = 0;
  require(H5Aread(attribute, H5T_NATIVE_UINT64, &value), doing);
  return std::to_string(value);
}

std::string read_attribute_if_any(hid_t object, const std::string& name) {
  return has_attribute(object, name) ? read_attribute(object, name) : "";
}

std::vector<std::string> attribute_names(hid_t object) {
  std::vector<std::string> names;
  hsize_t start = 0;
  const auto collect = [](hid_t, const char* name, const H5A_info_t*, void* found) -> herr_t {
    static_cast<std::vector<std::string>*>(found)->emplace_back(name);
    return 0;
  };
  require(H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, &start, collect, &names), "list attributes");
  return names;
}

Group open_group(hid_t group, const std::string& path) {
  require_own(group, path);
  return Group(H5Gopen2(group, path.c_str(), H5P_DEFAULT), "open " + path);
}

Dataset open_dataset(hid_t group, const std::string& path) {
  require_own(group, path);
  Dataset dataset(H5Dopen2(group, path.c_str(), H5P_DEFAULT), "open " + path);
  require_own_values(dataset, path);
  return dataset;
}

std::vector<hsize_t> shape_of(hid_t dataset) {
  const Space space(H5Dget_space(dataset), "read a shape");
  const int rank = require(H5Sget_simple_extent_ndims(space), "read a shape");
  std::vector<hsize_t> shape(static_cast<std::size_t>(rank));
  require(H5Sget_simple_extent_dims(space, shape.data(), nullptr), "read a shape");
  return shape;
}

std::vector<double> read_doubles(hid_t group, const std::string& path) {
  return read_as<double>(open_dataset(group, path), H5T_NATIVE_DOUBLE, path);
}

std::vector<std::int64_t> read_integers(hid_t group, const std::string& path) {
  return read_as<std::int64_t>(open_dataset(group, path), H5T_NATIVE_INT64, path);
}

std::vector<std::string> read_texts(hid_t group, const std::string& path) {
  return read_text_copy(open_dataset(group, path), path);
}

std::string read_text(hid_t group, const std::string& path) {
  const Dataset dataset = open_dataset(group, path);
  const Type type(H5Dget_type(dataset), "read the type of " + path);
  if (!is_fixed_text(type)) throw Error(path + " is not a text");
  const Type native(H5Tget_native_type(type, H5T_DIR_DEFAULT), "read the type of " + path);
  const auto block = read_as<char>(dataset, native, path);
  std::string text = up_to_padding(block.data(), block.size());
  require_hash(dataset, path, text);
  return text;
}

void verify(hid_t dataset, const std::string& path) {
  const Properties properties(H5Dget_create_plist(dataset), "read the layout of " + path);
  if (H5Pget_layout(properties) == H5D_VIRTUAL) return;  // the dataset that it shows is verified itself
  require_own_values(dataset, path);
  const Type type(H5Dget_type(dataset), "read the type of " + path);
  if (H5Tis_variable_str(type) > 0) {
    read_text_copy(dataset, path);
    return;
  }
  // Values with pointers inside are not ours: another program has added them.
  if (H5Tdetect_class(type, H5T_VLEN) != 0 ||
      H5Tdetect_class(type, H5T_STRING) != (H5Tget_class(type) == H5T_STRING)) {
    return;
  }
  const Type native(H5Tget_native_type(type, H5T_DIR_DEFAULT), "read the type of " + path);
  const auto block = read_as<char>(dataset, native, path);
  if (is_fixed_text(type)) require_hash(dataset, path, up_to_padding(block.data(), block.size()));
}

}  // namespace trunk::hdf5
