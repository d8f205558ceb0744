#include "anatomy/trunk_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

std::string names_of(const TrunkMesh& mesh) {
  std::string names;
  for (const Regions* regions : {&mesh.regions, &mesh.landmarks})
    for (const auto& [name, particles] : *regions) names += (names.empty() ? "" : ", ") + name;
  return names;
}

bool contains(const std::vector<int>& particles, int i) {
  return std::find(particles.begin(), particles.end(), i) != particles.end();
}

/// "3" or "0-3"; none where the text is neither.
bool add_range(std::string_view item, std::vector<int>& particles, int count) {
  int first = 0, last = 0;
  const char *begin = item.data(), *end = begin + item.size();
  const auto low = std::from_chars(begin, end, first);
  if (low.ec != std::errc{}) return false;
  last = first;
  if (low.ptr != end) {
    if (*low.ptr != '-') return false;
    const auto high = std::from_chars(low.ptr + 1, end, last);
    if (high.ec != std::errc{} || high.ptr != end) return false;
  }
  if (first < 0 || last < first || last >= count) return false;
  for (int i = first; i <= last; ++i) particles.push_back(i);
  return true;
}

}  // namespace

std::size_t TrunkMesh::distinct_triangles() const {
  std::set<Triangle> distinct;
  for (const auto* surface : {&abdomen, &lung})
    for (Triangle t : *surface) {
      std::sort(t.begin(), t.end());
      distinct.insert(t);
    }
  return distinct.size();
}

const std::vector<int>& TrunkMesh::named(const std::string& name) const {
  static const std::vector<int> none;
  for (const Regions* names : {&regions, &landmarks})
    if (const auto at = names->find(name); at != names->end()) return at->second;
  return none;
}

std::size_t TrunkMesh::apposition_top_row() const {
  const std::vector<int>& top = named("apposition_top");
  const auto& line = muscle_lines.front();
  const auto at = std::find_if(line.begin(), line.end(), [&](int i) { return contains(top, i); });
  return static_cast<std::size_t>(at - line.begin());
}

std::vector<int> selected_particles(const TrunkMesh& mesh, const std::string& text,
                                    const std::string& origin) {
  std::set<int> particles;
  std::vector<int> range;
  const int count = static_cast<int>(mesh.rest.size());
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string item = text.substr(begin, end - begin);
    range.clear();
    if (item == "*" && add_range(fmt::format("0-{}", count - 1), range, count))
      particles.insert(range.begin(), range.end());
    else if (const auto& region = mesh.named(item); !region.empty())
      particles.insert(region.begin(), region.end());
    else if (add_range(item, range, count))
      particles.insert(range.begin(), range.end());
    else
      throw InputError(
          fmt::format("{}: there is no region or particle '{}', expected particles 0 to {} (as in 0-3,7), * "
                      "for all, or one of {}",
                      origin, item, count - 1, names_of(mesh)));
    begin = end + 1;
  }
  return {particles.begin(), particles.end()};
}

void require_anatomy(const TrunkMesh& mesh) {
  const auto require = [](bool good, const std::string& text) {
    if (!good) throw InputError(text);
  };
  const auto& lines = mesh.muscle_lines;
  require(lines.size() >= 3, fmt::format("the trunk has {} muscle lines, expected 3 or more", lines.size()));
  const std::size_t length = lines.front().size(), top = mesh.apposition_top_row();
  require(
      top >= 1 && top + 1 < length,
      "no muscle line passes the top of the zone of apposition (landmark apposition_top) between its ends");
  for (const auto& line : lines) {
    require(
        line.size() == length,
        fmt::format("a muscle line has {} particles and another {}, expected as many", line.size(), length));
    for (int i : line)
      require(i >= 0 && static_cast<std::size_t>(i) < mesh.rest.size(),
              fmt::format("a muscle line refers to particle {}, which does not exist", i));
  }
  for (const char* name : {"apposition_middle", "apposition_top", "dome_top_right", "dome_top_left"})
    require(!mesh.named(name).empty(), fmt::format("the trunk has no landmark '{}'", name));
}

}  // namespace trunk
