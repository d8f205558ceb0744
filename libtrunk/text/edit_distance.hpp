#pragma once

#include <cstddef>
#include <string_view>

namespace trunk {

/// Returns Levenshtein's distance: the fewest insertions, deletions and replacements of bytes that turn one
/// word into the other.
std::size_t edit_distance(std::string_view from, std::string_view to);

}  // namespace trunk
