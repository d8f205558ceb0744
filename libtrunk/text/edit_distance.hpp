#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace trunk {

/// Returns the Levenshtein distance: the smallest number of bytes to insert, delete or replace to turn one
/// word into the other.
std::size_t edit_distance(std::string_view from, std::string_view to);

/// Returns the name that somebody who typed `word` probably means: the one at the smallest edit distance, the
/// first of several. Returns "" if none is near. Near (our choice) is a distance of at most a third of the
/// letters of the word, rounded up, and less than all of them; hyphens before the word do not count.
std::string nearest_name(std::string_view word, const std::vector<std::string>& names);

}  // namespace trunk
