#pragma once

#include <map>
#include <numbers>

#include "anatomy/template_mesh.hpp"
#include "registration/register_trunk.hpp"
#include "registration/trunk_parts.hpp"
#include "support/random.hpp"
#include "support/trunks.hpp"

namespace trunk::test {

/// A known subject: a trunk deformed by a smooth map, with the true place of each particle.
struct KnownSubject {
  TrunkMesh trunk;            // the template, to be registered
  std::vector<Vec3d> truth;   // [particles] m
  MeasuredSurface diaphragm;  // without noise, every triangle cut into `parts` squared
};

struct SubjectOptions {
  int resolution = 1;
  double scale = 1.0, turn_degrees = 0.0;
  int parts = 6;
};

/// Returns the place of a point after the map: wider, flatter, higher on the right, bent by up to about 15
/// mm.
inline Vec3d bent(const Vec3d& p) {
  const double right = dot(p - Vec3d{0.07, 0.0, 0.42}, p - Vec3d{0.07, 0.0, 0.42}) / (0.06 * 0.06);
  return {1.03 * p.x() + 0.005 * std::sin(p.z() / 0.08), 0.96 * p.y() + 0.004 * std::cos(p.x() / 0.06),
          1.02 * p.z() + 0.008 * std::exp(-right)};
}

inline MeasuredSurface refined(std::span<const Vec3d> points, std::span<const Triangle> triangles,
                               int parts) {
  MeasuredSurface surface{"subject", {}, {}};
  std::map<std::array<long, 3>, int> known;
  const auto point = [&](const Vec3d& p) {
    const auto key = [](double x) { return std::lround(x * 1e7); };
    const auto [at, added] =
        known.try_emplace({key(p.x()), key(p.y()), key(p.z())}, static_cast<int>(surface.points.size()));
    if (added) surface.points.push_back(p);
    return at->second;
  };
  for (const Triangle& t : triangles) {
    const auto corner = [&](std::size_t k) { return points[static_cast<std::size_t>(t[k])]; };
    const auto inner = [&](int i, int j) {
      const double u = static_cast<double>(i) / parts, v = static_cast<double>(j) / parts;
      return point((1.0 - u - v) * corner(0) + u * corner(1) + v * corner(2));
    };
    for (int i = 0; i < parts; ++i)
      for (int j = 0; i + j < parts; ++j) {
        surface.triangles.push_back({inner(i, j), inner(i + 1, j), inner(i, j + 1)});
        if (i + j + 1 < parts)
          surface.triangles.push_back({inner(i + 1, j), inner(i + 1, j + 1), inner(i, j + 1)});
      }
  }
  return surface;
}

inline KnownSubject known_subject(const SubjectOptions& options) {
  TrunkGeometry geometry;
  geometry.resolution = options.resolution;
  KnownSubject subject{make_template_mesh(geometry), {}, {}};
  const Vec3d oblique{0.5, -0.3, 0.8};
  const Rotation<double> turned =
      rotation_about((1.0 / norm(oblique)) * oblique, options.turn_degrees * std::numbers::pi / 180.0);
  const Vec3d centre{0.0, 0.0, 0.3}, shift{0.12, -0.05, 0.4};
  for (const Vec3d& p : subject.trunk.rest)
    subject.truth.push_back(options.scale * turn(turned, bent(p) - centre) + shift);
  subject.diaphragm = refined(subject.truth, diaphragm_of(subject.trunk), options.parts);
  return subject;
}

/// Adds nearly normal noise with a standard deviation in m to every coordinate.
inline void add_noise(MeasuredSurface& surface, double deviation) {
  Random random(7);
  for (Vec3d& p : surface.points)
    for (int sum = 0; sum < 4; ++sum) p += random.vector(0.5 * std::sqrt(3.0) * deviation);
}

/// Keeps the triangles whose middle is wanted, and returns the share of dropped triangles.
template <class Wanted>
double keep(MeasuredSurface& surface, Wanted&& wanted) {
  std::vector<Triangle> kept;
  for (const Triangle& t : surface.triangles) {
    Vec3d middle;
    for (int i : t) middle += (1.0 / 3.0) * surface.points[static_cast<std::size_t>(i)];
    if (wanted(middle)) kept.push_back(t);
  }
  const double missing =
      1.0 - static_cast<double>(kept.size()) / static_cast<double>(surface.triangles.size());
  surface.triangles = std::move(kept);
  return missing;
}

inline Registration registered(const KnownSubject& subject, SubjectMeasurements targets = {}) {
  if (!targets.diaphragm) targets.diaphragm = subject.diaphragm;
  return register_trunk(subject.trunk, targets, [](int, int) {});
}

/// Distances of the diaphragm's particles from their true places and from the true surface, m.
struct PointErrors {
  Distances point, surface;
};

inline PointErrors errors_of(const KnownSubject& subject, const Registration& found) {
  const std::vector<Triangle> diaphragm = diaphragm_of(subject.trunk);
  const ClosestPoints truth(subject.truth, diaphragm);
  std::vector<double> point, surface;
  for (const char* region : {"costal_insertion", "zone_of_apposition", "muscular_dome", "central_tendon"})
    for (int i : subject.trunk.named(region)) {
      const auto at = static_cast<std::size_t>(i);
      point.push_back(norm(found.mesh.rest[at] - subject.truth[at]));
      surface.push_back(truth(found.mesh.rest[at]).distance);
    }
  return {statistics_of(point), statistics_of(surface)};
}

}  // namespace trunk::test
