#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace trunk {

/// The numbers of a page too many for JSON: one block of little-endian arrays, and what JSON says in their
/// place, {"as": "f8", "at": first byte, "n": how many}.
class Packed {
 public:
  using Json = nlohmann::ordered_json;

  Json add(const std::vector<double>& values);         ///< "f8"
  Json add_single(const std::vector<double>& values);  ///< "f4": for curves that are only looked at
  Json add(const std::vector<std::int32_t>& values);   ///< "i4"
  Json add(const std::vector<std::int16_t>& values);   ///< "i2"
  Json add(const std::vector<std::uint8_t>& values);   ///< "u1"

  std::size_t bytes() const { return block_.size(); }
  /// The block compressed by gzip, in base64.
  std::string text() const;

 private:
  template <typename Value>
  Json append(const char* as, const std::vector<Value>& values);

  std::string block_;
};

}  // namespace trunk
