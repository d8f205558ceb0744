#include "text/edit_distance.hpp"

#include <algorithm>
#include <numeric>

namespace trunk {

std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (from[i] == to[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

std::string nearest_name(std::string_view word, const std::vector<std::string>& names) {
  const std::size_t letters = word.size() - std::min(word.find_first_not_of('-'), word.size());
  std::size_t fewest = std::min((letters + 2) / 3 + 1, letters);  // a near name needs fewer edits than this
  std::string nearest;
  for (const std::string& name : names)
    if (const std::size_t edits = edit_distance(word, name); edits < fewest) {
      fewest = edits;
      nearest = name;
    }
  return nearest;
}

}  // namespace trunk
