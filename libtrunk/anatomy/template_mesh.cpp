#include "anatomy/template_mesh.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "anatomy/template_levels.hpp"
#include "errors/input_error.hpp"
#include "math/units.hpp"
#include "mesh/volume.hpp"

namespace trunk {
namespace {

// The profile of the diaphragm above the zone of apposition, as fractions of the trunk's half-axes and of the
// dome height (our choice): steep muscular flanks up to the border of the central tendon, flat above it, with
// a slight saddle between the domes where the heart lies.
constexpr double tendon_border_height = 0.75, dome_top_size = 0.62, saddle_height = 0.95;

/// Returns the stations of the abdominal compartment from the pelvis up.
std::vector<Station> abdominal_profile(const TrunkGeometry& g) {
  const double costal = g.abdomen_height, top = costal + g.apposition_length;
  const double middle_dome = 0.5 * (g.dome_height_right + g.dome_height_left);
  const double half_difference = 0.5 * (g.dome_height_right - g.dome_height_left);
  const auto dome = [&](const char* region, const char* above, int count, double size, double fraction) {
    return Station{region, above, count, size, top + fraction * middle_dome, fraction * half_difference};
  };
  return {{"pelvis", "abdominal_wall", 12, 1.0, 0.0, 0.0},
          {"abdominal_wall", "abdominal_wall", 12, 1.0, costal / 3.0, 0.0},
          {"abdominal_wall", "abdominal_wall", 12, 1.0, 2.0 * costal / 3.0, 0.0},
          {"costal_insertion", "zone_of_apposition", 12, 1.0, costal, 0.0},
          {"zone_of_apposition", "zone_of_apposition", 12, 1.0, 0.5 * (costal + top), 0.0},
          {"zone_of_apposition", "muscular_dome", 12, 1.0, top, 0.0},
          dome("central_tendon", "central_tendon", 12, g.tendon_border_size, tendon_border_height),
          dome("central_tendon", "central_tendon", 6, dome_top_size, 1.0),
          dome("central_tendon", "", 1, 0.0, saddle_height)};
}

/// Rows of the abdominal profile at resolution 1.
enum Row : std::size_t {
  costal_row = 3,
  middle_row = 4,
  top_row = 5,
  border_row = 6,
  dome_row = 7,
  saddle_row = 8
};

void name_landmarks(const TrunkGeometry& g, const std::vector<Level>& levels, TrunkMesh& m) {
  const auto r = static_cast<std::size_t>(g.resolution);
  // Landmarks have the same places at any resolution.
  const auto coarse = [&](std::size_t row) {
    std::vector<int> particles;
    const Level& level = levels[row * r];
    for (std::size_t k = 0; k < level.particles.size(); k += r) particles.push_back(level.particles[k]);
    return particles;
  };
  const auto x = [&](int i) { return m.rest[static_cast<std::size_t>(i)].x(); };
  const auto add_half = [&](const std::string& name, const std::vector<int>& particles) {
    for (int i : particles)
      if (x(i) != 0.0) m.landmarks[name + (x(i) > 0.0 ? "_right" : "_left")].push_back(i);
  };
  m.landmarks["apposition_middle"] = coarse(middle_row);
  m.landmarks["apposition_top"] = coarse(top_row);
  m.landmarks["tendon_border"] = levels[border_row * r].particles;
  m.landmarks["dome_saddle"] = coarse(saddle_row);
  for (int i : coarse(dome_row)) m.landmarks[x(i) > 0.0 ? "dome_top_right" : "dome_top_left"].push_back(i);
  for (const char* region : {"costal_insertion", "lung_wall"}) add_half("rib_cage", m.regions[region]);
  add_half("zone_of_apposition", m.regions["zone_of_apposition"]);
  for (std::size_t row = 1; row <= costal_row * r; ++row) {  // the hindmost particle of each free ring
    const auto& ring = levels[row].particles;
    m.landmarks["spine"].push_back(*std::min_element(ring.begin(), ring.end(), [&](int a, int b) {
      return m.rest[static_cast<std::size_t>(a)].y() < m.rest[static_cast<std::size_t>(b)].y();
    }));
  }
  auto& fixed = m.landmarks["fixed"];
  for (const char* name : {"pelvis", "spine", "lung_wall", "lung_top"})
    fixed.insert(fixed.end(), m.named(name).begin(), m.named(name).end());
}

void lay_muscle_lines(const TrunkGeometry& g, const std::vector<Level>& levels, TrunkMesh& m) {
  const auto r = static_cast<std::size_t>(g.resolution);
  for (std::size_t k = 0; k < levels[costal_row * r].particles.size(); ++k) {
    m.muscle_lines.emplace_back();
    for (std::size_t row = costal_row * r; row <= border_row * r; ++row)
      m.muscle_lines.back().push_back(levels[row].particles[k]);
  }
}

/// Returns the pelvic floor, outermost ring first. The ring of the pelvis itself closes it.
std::vector<Level> build_floor(const TrunkGeometry& g, LevelBuilder& build) {
  std::vector<Level> inward;
  for (int ring = 0; ring < g.resolution; ++ring)
    inward.insert(inward.begin(), build.level("pelvis", std::max(1, 12 * ring),
                                              static_cast<double>(ring) / g.resolution, 0.0, 0.0));
  return inward;
}

/// The lung's wall above the zone of apposition. Its heights are fractions of the height of the lung.
struct LungWall {
  std::vector<Level> levels;
  std::vector<double> height;  // [levels] fraction
};

LungWall build_lung_wall(const TrunkGeometry& g, double base_z, LevelBuilder& build) {
  struct Knot {
    int count;
    double size, height;
  };
  const Knot knots[] = {{12, 1.0, 0.0}, {12, 1.0, 0.5}, {8, 0.65, 0.85}, {0, 0.0, 1.0}};
  const int r = g.resolution;
  LungWall wall;
  for (std::size_t k = 0; k + 1 < std::size(knots); ++k)
    for (int part = 1; part <= r; ++part) {
      const double at = static_cast<double>(part) / r;
      const Knot &a = knots[k], &b = knots[k + 1];
      const int count = std::max(1, r * a.count + (b.count - a.count) * part);
      wall.height.push_back(part == r ? b.height : std::lerp(a.height, b.height, at));
      wall.levels.push_back(build.level(count == 1 ? "lung_top" : "lung_wall", count,
                                        part == r ? b.size : std::lerp(a.size, b.size, at), base_z, 0.0));
    }
  return wall;
}

void place_lung(const LungWall& wall, double base_z, double height, TrunkMesh& m) {
  for (std::size_t k = 0; k < wall.levels.size(); ++k)
    for (int i : wall.levels[k].particles) {
      Vec3d& p = m.rest[static_cast<std::size_t>(i)];
      p = {p.x(), p.y(), base_z + wall.height[k] * height};
    }
}

/// Gives the lung its volume, which is linear in its height.
void size_lung(const TrunkGeometry& geometry, const LungWall& wall, double base_z, TrunkMesh& m) {
  const auto volume_at = [&](double height) {
    place_lung(wall, base_z, height, m);
    return enclosed_volume<double>(m.lung, m.rest);
  };
  const double at_zero = volume_at(0.0);
  const double height = (geometry.end_expiratory_volume - at_zero) / (volume_at(1.0) - at_zero);
  const double domes = std::max(geometry.dome_height_right, geometry.dome_height_left);
  if (!(0.5 * height > domes))
    throw InputError(
        {},
        fmt::format("an end-expiratory lung volume of {:.0f} ml makes a lung {:.0f} mm high over domes of "
                    "{:.0f} mm on this cross-section",
                    ml_per_m3 * geometry.end_expiratory_volume, mm_per_m * height, mm_per_m * domes),
        "at least twice the dome height", "raise the volume or lower the domes");
  place_lung(wall, base_z, height, m);
}

void require_possible(const TrunkGeometry& g) {
  for (const double length : {g.half_width, g.half_depth, g.abdomen_height, g.apposition_length,
                              g.dome_height_right, g.dome_height_left, g.end_expiratory_volume})
    if (!std::isfinite(length) || length <= 0.0)
      throw InputError({}, fmt::format("a length or volume of the trunk is {}", length),
                       "a finite number above 0");
  if (!(g.tendon_border_size > dome_top_size && g.tendon_border_size < 1.0))
    throw InputError({}, fmt::format("the border of the central tendon is at {:g}", g.tendon_border_size),
                     fmt::format("above {:g} and below 1", dome_top_size));
  if (g.resolution < 1 || g.resolution > 16)
    throw InputError({}, fmt::format("the mesh resolution is {}", g.resolution), "1 to 16");
}

}  // namespace

TrunkMesh make_template_mesh(const TrunkGeometry& g) {
  require_possible(g);
  TrunkMesh m;
  m.fineness = g.resolution;
  LevelBuilder build(g, m);
  const auto r = static_cast<std::size_t>(g.resolution);
  const double top_z = g.abdomen_height + g.apposition_length;

  const std::vector<Level> floor = build_floor(g, build);
  const std::vector<Level> levels = build.levels(abdominal_profile(g));
  const LungWall wall = build_lung_wall(g, top_z, build);

  std::vector<Level> floor_and_pelvis{levels.front()};
  floor_and_pelvis.insert(floor_and_pelvis.end(), floor.begin(), floor.end());
  join(floor_and_pelvis, m.abdomen);
  turn_over(m.abdomen);  // the floor faces down
  join(levels, m.abdomen);
  join({levels.begin() + static_cast<std::ptrdiff_t>(top_row * r), levels.end()}, m.lung);
  turn_over(m.lung);  // seen from the lung, the diaphragm faces down
  std::vector<Level> top_and_wall{levels[top_row * r]};
  top_and_wall.insert(top_and_wall.end(), wall.levels.begin(), wall.levels.end());
  join(top_and_wall, m.lung);

  name_landmarks(g, levels, m);
  lay_muscle_lines(g, levels, m);
  size_lung(g, wall, top_z, m);
  return m;
}

}  // namespace trunk
