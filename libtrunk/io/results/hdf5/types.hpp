#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "results/hdf5/id.hpp"

namespace trunk::hdf5 {

/// Returns the type of UTF-8 text of at most so many bytes and a final zero, without which netCDF-C reads too
/// far. It is for attributes and single texts, which are in object headers and have a checksum there.
inline Type text_type(std::size_t bytes) {
  Type type(H5Tcopy(H5T_C_S1), "prepare text");
  require(H5Tset_size(type, bytes + 1), "prepare text");
  require(H5Tset_cset(type, H5T_CSET_UTF8), "prepare text");
  require(H5Tset_strpad(type, H5T_STR_NULLTERM), "prepare text");
  return type;
}

/// Returns the type of UTF-8 text of any length, for arrays. Fixed lengths would be simpler, but netCDF-C 4.9
/// crashes on arrays of them. HDF5 stores texts of any length in a heap without checksums, and version 1.10
/// crashes or never returns if the heap is damaged. Therefore this layer writes such arrays for other
/// programs, but reads only the copy in their attribute `texts`.
inline Type free_text_type() {
  Type type = text_type(0);
  require(H5Tset_size(type, H5T_VARIABLE), "prepare text");
  return type;
}

/// Values in the form that HDF5 needs: one block of memory, its type in memory and its type in the file.
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

/// Returns the text whose hash represents several texts: each text followed by a zero.
inline std::string joined(std::span<const std::string> texts) {
  std::string block;
  for (const std::string& text : texts) block.append(text.c_str(), std::strlen(text.c_str()) + 1);
  return block;
}

}  // namespace trunk::hdf5
