#include "anatomy/trunk_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

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

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' '), last = text.find_last_not_of(' ');
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// Adds the particles of "3" or "0-3". Returns false if the text is neither or a particle does not exist.
/// => particles
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

void require(bool good, const std::string& found, const std::string& expected = "") {
  if (!good) throw InputError({}, found, expected);
}

void require_names(const TrunkMesh& mesh) {
  for (const char* name :
       {"pelvis", "abdominal_wall", "costal_insertion", "zone_of_apposition", "central_tendon", "lung_wall",
        "fixed", "apposition_middle", "apposition_top", "dome_top_right", "dome_top_left"})
    require(!mesh.named(name).empty(), fmt::format("the trunk has no region or landmark '{}'", name));
  for (const Regions* regions : {&mesh.regions, &mesh.landmarks})
    for (const auto& [name, particles] : *regions)
      for (int i : particles)
        require(i >= 0 && static_cast<std::size_t>(i) < mesh.rest.size(),
                fmt::format("'{}' refers to particle {}, which does not exist", name, i));
}

void require_muscle_lines(const TrunkMesh& mesh) {
  const auto& lines = mesh.muscle_lines;
  require(lines.size() >= 3, fmt::format("the trunk has {} muscle lines", lines.size()), "3 or more");
  const std::size_t length = lines.front().size(), top = mesh.apposition_top_row();
  require(
      top >= 1 && top + 1 < length,
      "no muscle line passes the top of the zone of apposition (landmark apposition_top) between its ends");
  for (const auto& line : lines)
    require(line.size() == length,
            fmt::format("a muscle line has {} particles and another {}", line.size(), length),
            "the same number in all");
  std::set<int> seen;
  for (const auto& line : lines) {
    const auto place = [&](std::size_t row, const char* region) {
      require(contains(mesh.named(region), line[row]),
              fmt::format("particle {}, number {} of the muscle line from particle {}, is not in {}",
                          line[row], row + 1, line.front(), region),
              "lines from the costal insertion up the zone of apposition to the central tendon");
    };
    place(0, "costal_insertion");
    for (std::size_t row = 1; row <= top; ++row) place(row, "zone_of_apposition");
    place(length - 1, "central_tendon");
    for (int i : line) require(seen.insert(i).second, fmt::format("particle {} is on two muscle lines", i));
  }
}

Vec3d centre_of(const TrunkMesh& mesh, const std::vector<int>& particles) {
  Vec3d sum;
  for (int i : particles) sum += mesh.rest[static_cast<std::size_t>(i)];
  return (1.0 / static_cast<double>(particles.size())) * sum;
}

/// In other axes the wrong side would be paralysed, so such a trunk is refused.
void require_orientation(const TrunkMesh& mesh) {
  const auto centre = [&](const char* name) { return centre_of(mesh, mesh.named(name)); };
  const std::string axes = "x to the subject's right, y forward, z up";
  require(centre("dome_top_left").x() < centre("dome_top_right").x(),
          "the right dome is not to the right of the left one", axes);
  require(centre("pelvis").z() < centre("costal_insertion").z() &&
              centre("costal_insertion").z() < centre("apposition_top").z() &&
              centre("apposition_top").z() < centre("lung_wall").z(),
          "pelvis, costal insertion, top of the zone of apposition and lung wall are not above each other",
          axes);
  if (const auto& spine = mesh.named("spine"); !spine.empty())
    require(centre_of(mesh, spine).y() < centre("costal_insertion").y(),
            "the spine is not behind the costal insertion", axes);
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

std::vector<int> selected_particles(const TrunkMesh& mesh, const std::string& text, const Place& at) {
  std::set<int> particles;
  std::vector<int> range;
  const int count = static_cast<int>(mesh.rest.size());
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string item = trimmed(text.substr(begin, end - begin));
    range.clear();
    const bool all = item == "*";
    if (const auto& region = mesh.named(item); !all && !region.empty())
      particles.insert(region.begin(), region.end());
    else if (add_range(all ? fmt::format("0-{}", count - 1) : item, range, count))
      particles.insert(range.begin(), range.end());
    else
      throw InputError(
          at, fmt::format("there is no region or particle '{}'", item),
          fmt::format("particles 0 to {} (as in 0-3,7), * for all, or one of {}", count - 1, names_of(mesh)));
    begin = end + 1;
  }
  return {particles.begin(), particles.end()};
}

double TrunkMesh::midline() const {
  const auto& costal = named("costal_insertion");
  if (costal.empty()) return 0.0;
  const auto x = [&](int i) { return rest[static_cast<std::size_t>(i)].x(); };
  const auto [left, right] =
      std::minmax_element(costal.begin(), costal.end(), [&](int a, int b) { return x(a) < x(b); });
  return 0.5 * (x(*left) + x(*right));
}

void require_anatomy(const TrunkMesh& mesh) {
  require_names(mesh);
  require_muscle_lines(mesh);
  require_orientation(mesh);
}

}  // namespace trunk
