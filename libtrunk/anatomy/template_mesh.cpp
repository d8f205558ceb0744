#include "anatomy/template_mesh.hpp"

#include <fmt/format.h>
#include <gsl/gsl_interp.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "errors/input_error.hpp"
#include "mesh/volume.hpp"

namespace trunk {
namespace {

// Profile of the diaphragm above the zone of apposition, as fractions of the trunk's half-axes and of the
// dome height: steep muscular flanks up to the border of the central tendon, flat above it, a slight saddle
// between the domes where the heart lies (our choice).
constexpr double tendon_border_size = 0.79, tendon_border_height = 0.75;
constexpr double dome_top_size = 0.62, saddle_height = 0.95;

/// A ring of particles around the trunk, or one particle on its axis. Angles run from 0 at the subject's
/// right
/// (+x), counter-clockwise seen from above.
struct Level {
  std::vector<int> particles;
  std::vector<double> angles;  // rad, one a particle
};

/// Where the profile passes at resolution 1: the size scales the trunk's ellipse; height + tilt cos(angle).
struct Station {
  std::string region;  // of its own particles
  std::string above;   // of those between it and the next
  int count;           // particles around
  double size, height, tilt;
};

/// Joins two rings, `upper` above or inside `lower`, by triangles that face outward or up. Of the two
/// possible diagonals the one that spans the smaller angle; ties alternate by quadrant, so that the mesh
/// mirrors.
void stitch(const Level& lower, const Level& upper, std::vector<Triangle>& triangles) {
  const std::size_t lower_count = lower.angles.size(), upper_count = upper.angles.size();
  const auto angle = [](const Level& level, std::size_t k) {
    const std::size_t turns = k / level.angles.size();
    return level.angles[k % level.angles.size()] + 2.0 * std::numbers::pi * static_cast<double>(turns);
  };
  const auto particle = [](const Level& level, std::size_t k) {
    return level.particles[k % level.particles.size()];
  };
  for (std::size_t i = 0, j = 0; i < lower_count || j < upper_count;) {
    const double along_lower = angle(lower, i + 1) - angle(upper, j);
    const double along_upper = angle(upper, j + 1) - angle(lower, i);
    const bool tie = std::abs(along_lower - along_upper) < 1e-9;
    const double middle = 0.5 * (angle(lower, i) + angle(lower, i + 1));
    const bool advance_lower = tie ? std::sin(2.0 * middle) > 0.0 : along_lower < along_upper;
    if (j == upper_count || (i < lower_count && advance_lower)) {
      triangles.push_back({particle(lower, i), particle(lower, i + 1), particle(upper, j)});
      ++i;
    } else {
      triangles.push_back({particle(lower, i), particle(upper, j + 1), particle(upper, j)});
      ++j;
    }
  }
}

/// Closes a ring by a fan to a point above it.
void cap(const Level& ring, const Level& tip, std::vector<Triangle>& triangles) {
  const std::size_t count = ring.particles.size();
  for (std::size_t k = 0; k < count; ++k)
    triangles.push_back({ring.particles[k], ring.particles[(k + 1) % count], tip.particles[0]});
}

void join(const std::vector<Level>& levels, std::vector<Triangle>& triangles) {
  for (std::size_t k = 0; k + 1 < levels.size(); ++k)
    if (levels[k + 1].particles.size() == 1)
      cap(levels[k], levels[k + 1], triangles);
    else
      stitch(levels[k], levels[k + 1], triangles);
}

void turn_over(std::span<Triangle> triangles) {
  for (Triangle& t : triangles) std::swap(t[1], t[2]);
}

/// A quantity along the profile: through its values at the stations, monotone between them (Steffen's
/// method), so that nothing bulges that does not at the stations.
class AlongProfile {
 public:
  template <class Value>
  AlongProfile(const std::vector<Station>& stations, Value value) {
    for (const Station& s : stations) {
      at_.push_back(static_cast<double>(at_.size()));
      value_.push_back(value(s));
    }
    interpolation_.reset(gsl_interp_alloc(gsl_interp_steffen, at_.size()));
    gsl_interp_init(interpolation_.get(), at_.data(), value_.data(), at_.size());
  }
  double operator()(double station) const {
    return gsl_interp_eval(interpolation_.get(), at_.data(), value_.data(), station, nullptr);
  }

 private:
  struct Free {
    void operator()(gsl_interp* interpolation) const { gsl_interp_free(interpolation); }
  };
  std::vector<double> at_, value_;
  std::unique_ptr<gsl_interp, Free> interpolation_;
};

/// Adds particles to a mesh, level by level.
class Builder {
 public:
  Builder(const TrunkGeometry& geometry, TrunkMesh& mesh) : geometry_(geometry), mesh_(mesh) {}

  /// A ring of `count` particles, or one on the axis.
  Level level(const std::string& region, int count, double size, double height, double tilt) {
    Level level;
    for (int k = 0; k < count; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / count;
      // Exact zeros on the midline keep left and right mirror images of each other.
      const double x = count == 1 || 4 * k == count || 4 * k == 3 * count ? 0.0 : std::cos(angle);
      const double y = k == 0 || 2 * k == count ? 0.0 : std::sin(angle);
      level.particles.push_back(static_cast<int>(mesh_.rest.size()));
      level.angles.push_back(angle);
      mesh_.rest.push_back(
          {size * geometry_.half_width * x, size * geometry_.half_depth * y, height + tilt * x});
    }
    auto& particles = mesh_.regions[region];
    particles.insert(particles.end(), level.particles.begin(), level.particles.end());
    return level;
  }

  /// The levels of a profile at the geometry's resolution, those of the stations among them.
  std::vector<Level> levels(const std::vector<Station>& stations) {
    const int r = geometry_.resolution;
    const AlongProfile size(stations, [](const Station& s) { return s.size; });
    const AlongProfile height(stations, [](const Station& s) { return s.height; });
    const AlongProfile tilt(stations, [](const Station& s) { return s.tilt; });
    const auto around = [&](std::size_t k) { return stations[k].size == 0.0 ? 0 : r * stations[k].count; };
    std::vector<Level> result;
    for (std::size_t k = 0; k < stations.size(); ++k)
      for (int part = 0; part < (k + 1 < stations.size() ? r : 1); ++part) {
        const double at = static_cast<double>(k) + static_cast<double>(part) / r;
        const int next = part > 0 ? around(k + 1) : around(k);
        const int count = std::max(1, around(k) + (next - around(k)) * part / r);
        result.push_back(
            level(part == 0 ? stations[k].region : stations[k].above, count, size(at), height(at), tilt(at)));
      }
    return result;
  }

 private:
  const TrunkGeometry& geometry_;
  TrunkMesh& mesh_;
};

/// The stations of the abdominal compartment from the pelvis up.
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
          dome("central_tendon", "central_tendon", 12, tendon_border_size, tendon_border_height),
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
  // Measured at the same places whatever the resolution.
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

/// The pelvic floor, outermost ring first; the ring of the pelvis itself closes it.
std::vector<Level> build_floor(const TrunkGeometry& g, Builder& build) {
  std::vector<Level> inward;
  for (int ring = 0; ring < g.resolution; ++ring)
    inward.insert(inward.begin(), build.level("pelvis", std::max(1, 12 * ring),
                                              static_cast<double>(ring) / g.resolution, 0.0, 0.0));
  return inward;
}

/// The lung's wall above the zone of apposition, at heights that are fractions of the lung's.
struct LungWall {
  std::vector<Level> levels;
  std::vector<double> height;  // [levels] fraction
};

LungWall build_lung_wall(const TrunkGeometry& g, double base_z, Builder& build) {
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

/// The volume of the lung is linear in its height.
void size_lung(const TrunkGeometry& geometry, const LungWall& wall, double base_z, TrunkMesh& m) {
  const auto volume_at = [&](double height) {
    place_lung(wall, base_z, height, m);
    return enclosed_volume<double>(m.lung, m.rest);
  };
  const double at_zero = volume_at(0.0);
  const double height = (geometry.end_expiratory_volume - at_zero) / (volume_at(1.0) - at_zero);
  const double domes = std::max(geometry.dome_height_right, geometry.dome_height_left);
  if (!(0.5 * height > domes))
    throw InputError(fmt::format(
        "an end-expiratory lung volume of {:.0f} ml leaves a lung {:.0f} mm high over domes of {:.0f} mm on "
        "this cross-section; expected at least twice the dome height: raise the volume or lower the domes",
        1e6 * geometry.end_expiratory_volume, 1e3 * height, 1e3 * domes));
  place_lung(wall, base_z, height, m);
}

void require_possible(const TrunkGeometry& g) {
  for (const double length : {g.half_width, g.half_depth, g.abdomen_height, g.apposition_length,
                              g.dome_height_right, g.dome_height_left, g.end_expiratory_volume})
    if (!std::isfinite(length) || length <= 0.0)
      throw InputError(
          fmt::format("a length or volume of the trunk is {}, expected a finite number above 0", length));
  if (g.resolution < 1 || g.resolution > 16)
    throw InputError(fmt::format("the mesh resolution is {}, expected 1 to 16", g.resolution));
}

}  // namespace

TrunkMesh make_template_mesh(const TrunkGeometry& g) {
  require_possible(g);
  TrunkMesh m;
  m.fineness = g.resolution;
  Builder build(g, m);
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
