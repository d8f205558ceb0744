#include <algorithm>
#include <numeric>

#include "results/hdf5/types.hpp"
#include "results/hdf5/write.hpp"

namespace trunk::hdf5 {
namespace {

void write_raw_attribute(hid_t object, const std::string& name, hid_t file_type, hid_t memory_type,
                         const Space& space, const void* value) {
  const std::string doing = "write attribute " + name;
  const Attribute attribute(H5Acreate2(object, name.c_str(), file_type, space, H5P_DEFAULT, H5P_DEFAULT),
                            doing);
  require(H5Awrite(attribute, memory_type, value), doing);
}

}  // namespace

void write_attribute(hid_t object, const std::string& name, std::string_view text) {
  const Type type = text_type(text.size());
  const std::string terminated(text);
  write_raw_attribute(object, name, type, type, Space(H5Screate(H5S_SCALAR), "write " + name),
                      terminated.c_str());
}

void write_attribute(hid_t object, const std::string& name, const char* text) {
  write_attribute(object, name, std::string_view(text));
}

void write_attribute(hid_t object, const std::string& name, std::span<const std::string> texts) {
  std::size_t width = 0;
  for (const std::string& text : texts) width = std::max(width, text.size());
  std::string block;
  for (const std::string& text : texts) block += text + std::string(width + 1 - text.size(), '\0');
  const Type type = text_type(width);
  const hsize_t size = texts.size();
  write_raw_attribute(object, name, type, type, Space(H5Screate_simple(1, &size, nullptr), "write " + name),
                      block.data());
}

void write_attribute(hid_t object, const std::string& name, std::span<const std::int32_t> values) {
  const hsize_t size = values.size();
  write_raw_attribute(object, name, H5T_STD_I32LE, H5T_NATIVE_INT32,
                      Space(H5Screate_simple(1, &size, nullptr), "write " + name), values.data());
}

void write_attribute(hid_t object, const std::string& name, std::span<const std::int64_t> values) {
  const hsize_t size = values.size();
  write_raw_attribute(object, name, H5T_STD_I64LE, H5T_NATIVE_INT64,
                      Space(H5Screate_simple(1, &size, nullptr), "write " + name), values.data());
}

void write_attribute(hid_t object, const std::string& name, std::int64_t value) {
  write_raw_attribute(object, name, H5T_STD_I64LE, H5T_NATIVE_INT64,
                      Space(H5Screate(H5S_SCALAR), "write " + name), &value);
}

void write_ascii_attribute(hid_t object, const std::string& name, const std::string& text) {
  const Type type(H5Tcopy(H5T_C_S1), "prepare text");
  require(H5Tset_size(type, text.size()), "prepare text");
  require(H5Tset_strpad(type, H5T_STR_NULLPAD), "prepare text");
  write_raw_attribute(object, name, type, type, Space(H5Screate(H5S_SCALAR), "write " + name), text.data());
}

void write_attribute(hid_t object, const std::string& name, std::int32_t value) {
  write_raw_attribute(object, name, H5T_STD_I32LE, H5T_NATIVE_INT32,
                      Space(H5Screate(H5S_SCALAR), "write " + name), &value);
}

void write_attribute(hid_t object, const std::string& name, std::uint64_t value) {
  write_raw_attribute(object, name, H5T_STD_U64LE, H5T_NATIVE_UINT64,
                      Space(H5Screate(H5S_SCALAR), "write " + name), &value);
}

void refer_to(hid_t object, const std::string& name, hid_t group, const std::string& object_path) {
  hobj_ref_t reference{};
  require(H5Rcreate(&reference, group, object_path.c_str(), H5R_OBJECT, -1), "refer to " + object_path);
  // This is an array of one reference, because h5netcdf 1.1 fails on a scalar one.
  const hsize_t size = 1;
  write_raw_attribute(object, name, H5T_STD_REF_OBJ, H5T_STD_REF_OBJ,
                      Space(H5Screate_simple(1, &size, nullptr), "write " + name), &reference);
}

void write_flags(hid_t dataset, const std::vector<std::string>& meanings) {
  std::vector<std::int32_t> codes(meanings.size());
  std::iota(codes.begin(), codes.end(), 0);
  if (codes.empty()) return;
  std::string words;
  for (std::string meaning : meanings) {
    std::replace(meaning.begin(), meaning.end(), ' ', '_');  // CF separates meanings by spaces
    words += (words.empty() ? "" : " ") + meaning;
  }
  write_attribute(dataset, "flag_values", codes);
  write_attribute(dataset, "flag_meanings", words);
}

}  // namespace trunk::hdf5
