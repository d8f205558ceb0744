#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace trunk {

/// Arrays that are too long for JSON, in one block of little-endian numbers. JSON holds a reference instead
/// of each array: {"as": "f8", "at": first byte, "n": number of values}.
class Packed {
 public:
  using Json = nlohmann::ordered_json;

  // Each adds an array and returns its reference. They throw std::runtime_error if the block exceeds 256 MB.
  Json add(const std::vector<double>& values);         ///< "f8"
  Json add_single(const std::vector<double>& values);  ///< "f4": for curves that are only drawn
  Json add(const std::vector<std::int32_t>& values);   ///< "i4"
  Json add(const std::vector<std::int16_t>& values);   ///< "i2"
  Json add(const std::vector<std::uint8_t>& values);   ///< "u1"

  std::size_t bytes() const { return block_.size(); }
  /// Returns the block, compressed by gzip, in base64.
  std::string text() const;

 private:
  template <typename Value>
  Json append(const char* as, const std::vector<Value>& values);

  std::string block_;
};

}  // namespace trunk
