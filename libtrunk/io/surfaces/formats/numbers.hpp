#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

/// Private to the surfaces layer: numbers in binary files.
namespace trunk {

/// The type of a number in a binary file.
struct NumberType {
  enum class Kind { whole, natural, real } kind = Kind::real;
  std::size_t bytes = 0;  // 1, 2, 4 or 8; a real 4 or 8
};

/// Returns the type that PLY, VTK or VTP gives a name to, such as "float", "Float32", "vtktypeint64" or
/// "uchar", in any case; nothing if the name is not known.
std::optional<NumberType> number_type(std::string_view name) noexcept;

/// Returns the number whose bytes begin at `at`. Whole numbers beyond 2^53 are rounded.
double number_at(const char* at, NumberType type, bool big_endian) noexcept;

}  // namespace trunk
