#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

/// Private to the pml layer: numbers and characters of XML texts, without locale.
namespace trunk::pml {

/// Without white space at either end.
std::string_view trimmed(std::string_view text) noexcept;

/// A finite number that fills the text but for white space around it; nothing else.
std::optional<double> finite_number(std::string_view text) noexcept;

/// The largest index of an atom or cell: other programs keep them in 32 bits.
inline constexpr std::size_t largest_index = 2'147'483'647;

/// Decimal digits alone, at most largest_index, white space around them allowed.
std::optional<std::size_t> whole_number(std::string_view text) noexcept;

/// Where the first byte stands that XML 1.0 in UTF-8 forbids: a control character or broken UTF-8; npos if
/// nowhere.
std::size_t first_forbidden(std::string_view text) noexcept;

/// Text of a file as a message cites it: in quotes, on one line, at most 40 bytes.
std::string cited(std::string_view text);

}  // namespace trunk::pml
