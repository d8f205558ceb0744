#include "anatomy/template_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "errors/input_error.hpp"
#include "mesh/volume.hpp"

namespace trunk {
namespace {

constexpr int around = 12;  // particles in a full ring

// Profile of the diaphragm above the zone of apposition, as fractions of the trunk's half-axes and of the
// dome height: steep muscular flanks up to the border of the central tendon, flat above it, a slight saddle
// between the domes where the heart lies (our choice).
constexpr double tendon_border_size = 0.79, tendon_border_height = 0.75;
constexpr double dome_top_size = 0.62, saddle_height = 0.95;

/// Adds particles to the mesh, level by level.
struct Builder {
  const TrunkGeometry& geometry;
  TemplateMesh& mesh;

  Level point(const std::string& region, double z) {
    mesh.rest.push_back({0.0, 0.0, z});
    return {region, {static_cast<int>(mesh.rest.size()) - 1}, {}};
  }

  /// `size` scales the trunk's ellipse; z(cos angle) gives the height.
  template <class Height>
  Level ring(const std::string& region, int count, double size, Height z) {
    Level level{region, {}, {}};
    for (int k = 0; k < count; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / count;
      // Exact zeros on the midline keep left and right mirror images of each other.
      const double x = 4 * k == count || 4 * k == 3 * count ? 0.0 : std::cos(angle);
      const double y = k == 0 || 2 * k == count ? 0.0 : std::sin(angle);
      mesh.rest.push_back({size * geometry.half_width * x, size * geometry.half_depth * y, z(x)});
      level.particles.push_back(static_cast<int>(mesh.rest.size()) - 1);
      level.angles.push_back(angle);
    }
    return level;
  }
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

void turn_over(std::span<Triangle> triangles) {
  for (Triangle& t : triangles) std::swap(t[1], t[2]);
}

void connect_abdomen(TemplateMesh& m) {
  auto& triangles = m.abdomen;
  cap(m.pelvis, m.pelvic_floor, triangles);
  turn_over(triangles);  // the floor faces down
  const Level* wall[] = {&m.pelvis,
                         &m.abdominal_wall_low,
                         &m.abdominal_wall_high,
                         &m.costal_insertion,
                         &m.apposition_middle,
                         &m.apposition_top,
                         &m.tendon_border,
                         &m.dome_top};
  for (std::size_t k = 0; k + 1 < std::size(wall); ++k) stitch(*wall[k], *wall[k + 1], triangles);
  cap(m.dome_top, m.dome_saddle, triangles);
}

void connect_lung(TemplateMesh& m) {
  auto& triangles = m.lung;
  stitch(m.apposition_top, m.tendon_border, triangles);
  stitch(m.tendon_border, m.dome_top, triangles);
  cap(m.dome_top, m.dome_saddle, triangles);
  turn_over(triangles);  // seen from the lung, the diaphragm faces down
  stitch(m.apposition_top, m.lung_base, triangles);
  stitch(m.lung_base, m.lung_upper, triangles);
  cap(m.lung_upper, m.lung_top, triangles);
}

void place_lung(const TemplateMesh& m, double base_z, double height, std::vector<Vec3d>& rest) {
  const auto set_height = [&](const Level& level, double fraction) {
    for (int i : level.particles) {
      Vec3d& p = rest[static_cast<std::size_t>(i)];
      p = {p.x(), p.y(), base_z + fraction * height};
    }
  };
  set_height(m.lung_base, 0.5);
  set_height(m.lung_upper, 0.85);
  set_height(m.lung_top, 1.0);
}

/// The volume of the lung is linear in its height.
void size_lung(const TrunkGeometry& geometry, double base_z, TemplateMesh& m) {
  const auto volume_at = [&](double height) {
    place_lung(m, base_z, height, m.rest);
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
  place_lung(m, base_z, height, m.rest);
}

}  // namespace

std::size_t TemplateMesh::distinct_triangles() const {
  std::set<Triangle> distinct;
  for (const auto* surface : {&abdomen, &lung})
    for (Triangle t : *surface) {
      std::sort(t.begin(), t.end());
      distinct.insert(t);
    }
  return distinct.size();
}

TemplateMesh make_template_mesh(const TrunkGeometry& g) {
  TemplateMesh m;
  Builder build{g, m};
  const auto at = [](double z) { return [z](double) { return z; }; };
  const double costal_z = g.abdomen_height, top_z = costal_z + g.apposition_length;
  const double middle_dome = 0.5 * (g.dome_height_right + g.dome_height_left);
  const double half_difference = 0.5 * (g.dome_height_right - g.dome_height_left);
  const auto dome = [&](double fraction) {
    return [=](double x) { return top_z + fraction * (middle_dome + half_difference * x); };
  };

  m.pelvic_floor = build.point("pelvis", 0.0);
  m.pelvis = build.ring("pelvis", around, 1.0, at(0.0));
  m.abdominal_wall_low = build.ring("abdominal_wall", around, 1.0, at(costal_z / 3.0));
  m.abdominal_wall_high = build.ring("abdominal_wall", around, 1.0, at(2.0 * costal_z / 3.0));
  m.costal_insertion = build.ring("costal_insertion", around, 1.0, at(costal_z));
  m.apposition_middle = build.ring("zone_of_apposition", around, 1.0, at(0.5 * (costal_z + top_z)));
  m.apposition_top = build.ring("zone_of_apposition", around, 1.0, at(top_z));
  m.tendon_border = build.ring("central_tendon", around, tendon_border_size, dome(tendon_border_height));
  m.dome_top = build.ring("central_tendon", around / 2, dome_top_size, dome(1.0));
  m.dome_saddle = build.point("central_tendon", dome(saddle_height)(0.0));
  m.lung_base = build.ring("lung_wall", around, 1.0, at(top_z));
  m.lung_upper = build.ring("lung_wall", 2 * around / 3, 0.65, at(top_z));
  m.lung_top = build.point("lung_top", top_z);

  connect_abdomen(m);
  connect_lung(m);
  size_lung(g, top_z, m);
  return m;
}

}  // namespace trunk
