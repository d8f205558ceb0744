#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

/// Private to the surfaces layer: binary numbers of a file.
namespace trunk {

/// The type of a number in a binary file.
struct NumberType {
  enum class Kind { whole, natural, real } kind = Kind::real;
  std::size_t bytes = 0;  // 1, 2, 4 or 8; a real 4 or 8
};

/// By the names that PLY, VTK and VTP have for it: "float", "Float32", "vtktypeint64", "uchar"; any case.
std::optional<NumberType> number_type(std::string_view name) noexcept;

/// The number whose bytes begin at `at`, which are there. Whole numbers beyond 2^53 are rounded.
double number_at(const char* at, NumberType type, bool big_endian) noexcept;

}  // namespace trunk
