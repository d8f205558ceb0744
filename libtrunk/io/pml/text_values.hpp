#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

/// Private to the pml layer: numbers and characters of XML texts, independent of the locale.
namespace trunk::pml {

/// Returns the text without white space at either end.
std::string_view trimmed(std::string_view text) noexcept;

/// Returns the finite number that is the whole text, apart from white space around it; nothing otherwise.
std::optional<double> finite_number(std::string_view text) noexcept;

/// The largest index of an atom or cell, because other programs store indexes in 32 bits.
inline constexpr std::size_t largest_index = 2'147'483'647;

/// Returns the whole number of decimal digits that is the whole text, apart from white space around it;
/// nothing if there is another character or the number is above largest_index.
std::optional<std::size_t> whole_number(std::string_view text) noexcept;

/// Returns the position of the first byte that XML 1.0 in UTF-8 forbids (a control character or invalid
/// UTF-8); npos if there is none.
std::size_t first_forbidden(std::string_view text) noexcept;

}  // namespace trunk::pml
