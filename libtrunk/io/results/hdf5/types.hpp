#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "results/hdf5/id.hpp"

namespace trunk::hdf5 {

/// UTF-8 text of at most so many bytes and a final zero (netCDF-C reads on without it), for attributes and
/// single texts: these lie in object headers, under a checksum.
inline Type text_type(std::size_t bytes) {
  Type type(H5Tcopy(H5T_C_S1), "prepare text");
  require(H5Tset_size(type, bytes + 1), "prepare text");
  require(H5Tset_cset(type, H5T_CSET_UTF8), "prepare text");
  require(H5Tset_strpad(type, H5T_STR_NULLTERM), "prepare text");
  return type;
}

/// UTF-8 text of any length, for arrays. Fixed lengths would be simpler, but netCDF-C 4.9 crashes on
/// arrays of them. HDF5 keeps free lengths in a heap without checksums, and 1.10 crashes or never
/// returns when that is damaged: the layer writes such arrays, for others, and never reads them. It
/// reads the copy that they carry in the attribute `texts`.
inline Type free_text_type() {
  Type type = text_type(0);
  require(H5Tset_size(type, H5T_VARIABLE), "prepare text");
  return type;
}

/// Values as HDF5 wants them: one block of memory and its type, here and in the file.
template <typename Value>
class Packed {
 public:
  explicit Packed(std::span<const Value> values) : values_(values) {}
  const void* data() const { return values_.data(); }
  std::size_t value_bytes() const { return sizeof(Value); }

  hid_t file_type() const {
    if constexpr (std::is_same_v<Value, double>) return H5T_IEEE_F64LE;
    if constexpr (std::is_same_v<Value, std::int32_t>) return H5T_STD_I32LE;
    if constexpr (std::is_same_v<Value, std::int64_t>) return H5T_STD_I64LE;
  }
  hid_t memory_type() const {
    if constexpr (std::is_same_v<Value, double>) return H5T_NATIVE_DOUBLE;
    if constexpr (std::is_same_v<Value, std::int32_t>) return H5T_NATIVE_INT32;
    if constexpr (std::is_same_v<Value, std::int64_t>) return H5T_NATIVE_INT64;
  }

 private:
  std::span<const Value> values_;
};

template <>
class Packed<std::string> {
 public:
  explicit Packed(std::span<const std::string> values) : type_(free_text_type()) {
    for (const std::string& value : values) texts_.push_back(value.c_str());
  }
  const void* data() const { return texts_.data(); }
  std::size_t value_bytes() const { return sizeof(const char*); }
  hid_t file_type() const { return type_; }
  hid_t memory_type() const { return type_; }

 private:
  std::vector<const char*> texts_;
  Type type_;
};

/// What is hashed of several texts: each with a zero behind it.
inline std::string joined(std::span<const std::string> texts) {
  std::string block;
  for (const std::string& text : texts) block.append(text.c_str(), std::strlen(text.c_str()) + 1);
  return block;
}

}  // namespace trunk::hdf5
