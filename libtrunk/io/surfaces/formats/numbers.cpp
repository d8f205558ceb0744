#include "surfaces/formats/numbers.hpp"

#include <bit>
#include <cstdint>
#include <string>

#include "surfaces/formats/words.hpp"

namespace trunk {

std::optional<NumberType> number_type(std::string_view name) noexcept {
  using Kind = NumberType::Kind;
  struct Named {
    std::string_view name;
    NumberType type;
  };
  static constexpr Named known[] = {{"float", {Kind::real, 4}},
                                    {"float32", {Kind::real, 4}},
                                    {"double", {Kind::real, 8}},
                                    {"float64", {Kind::real, 8}},
                                    {"char", {Kind::whole, 1}},
                                    {"signed_char", {Kind::whole, 1}},
                                    {"int8", {Kind::whole, 1}},
                                    {"uchar", {Kind::natural, 1}},
                                    {"unsigned_char", {Kind::natural, 1}},
                                    {"uint8", {Kind::natural, 1}},
                                    {"short", {Kind::whole, 2}},
                                    {"int16", {Kind::whole, 2}},
                                    {"ushort", {Kind::natural, 2}},
                                    {"unsigned_short", {Kind::natural, 2}},
                                    {"uint16", {Kind::natural, 2}},
                                    {"int", {Kind::whole, 4}},
                                    {"int32", {Kind::whole, 4}},
                                    {"uint", {Kind::natural, 4}},
                                    {"unsigned_int", {Kind::natural, 4}},
                                    {"uint32", {Kind::natural, 4}},
                                    {"long", {Kind::whole, 8}},
                                    {"unsigned_long", {Kind::natural, 8}},
                                    {"int64", {Kind::whole, 8}},
                                    {"uint64", {Kind::natural, 8}},
                                    {"vtktypeint32", {Kind::whole, 4}},
                                    {"vtktypeint64", {Kind::whole, 8}},
                                    {"vtkidtype", {Kind::whole, 4}}};
  for (const auto& [known_name, type] : known)
    if (same_word(name, known_name)) return type;
  return std::nullopt;
}

double number_at(const char* at, NumberType type, bool big_endian) noexcept {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < type.bytes; ++i) {
    const std::size_t from = big_endian ? type.bytes - 1 - i : i;
    bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(at[from])) << (8 * i);
  }
  if (type.kind == NumberType::Kind::real)
    return type.bytes == 4 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
                           : std::bit_cast<double>(bits);
  if (type.kind == NumberType::Kind::natural) return static_cast<double>(bits);
  const auto unused = static_cast<unsigned>(64 - 8 * type.bytes);  // shifting up and down extends the sign
  // clang-tidy cannot see that a number has one byte or more. NOLINTNEXTLINE
  const std::uint64_t raised = bits << unused;
  return static_cast<double>(static_cast<std::int64_t>(raised) >> unused);
}

}  // namespace trunk
