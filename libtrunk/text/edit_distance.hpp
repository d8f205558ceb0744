#pragma once

#include <cstddef>
#include <string_view>

namespace trunk {

/// Returns the Levenshtein distance: the smallest number of bytes to insert, delete or replace to turn one
/// word into the other.
std::size_t edit_distance(std::string_view from, std::string_view to);

}  // namespace trunk
