#include "surface/sheets.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>
#include <unsupported/Eigen/BVH>

#include "math/median.hpp"

namespace trunk {
namespace {

constexpr double thickest = 0.05, least_share = 0.7;

struct Facet {
  std::array<Vec3d, 3> corner;
  Vec3d centre, normal;  // of unit length, 0 where degenerate
  double area;
};

std::vector<Facet> facets_of(const MeasuredSurface& s) {
  std::vector<Facet> facets;
  for (const Triangle& t : s.triangles) {
    Facet f;
    for (std::size_t i = 0; i < 3; ++i) f.corner[i] = s.points[static_cast<std::size_t>(t[i])];
    const Vec3d twice = cross(f.corner[1] - f.corner[0], f.corner[2] - f.corner[0]);
    f.area = 0.5 * norm(twice);
    f.normal = f.area > 0.0 ? (0.5 / f.area) * twice : Vec3d();
    f.centre = (1.0 / 3.0) * (f.corner[0] + f.corner[1] + f.corner[2]);
    facets.push_back(f);
  }
  return facets;
}

using FacetBox = Eigen::AlignedBox3d;

FacetBox box_around(std::initializer_list<Vec3d> points) {
  FacetBox box;
  for (const Vec3d& p : points) box.extend(Eigen::Vector3d(p.x(), p.y(), p.z()));
  return box;
}

/// Searches along the normal of a facet, both ways, for the nearest facet that is about parallel and shares
/// no corner with it.
struct Look {
  const std::vector<Facet>& facets;
  const std::vector<Triangle>& triangles;
  int from;
  double reach;
  const Facet& self = facets[static_cast<std::size_t>(from)];
  FacetBox path = box_around({self.centre - reach * self.normal, self.centre + reach* self.normal});
  int found = -1;
  double along = HUGE_VAL;  // distance to it, positive if the facet faces it

  bool intersectVolume(const FacetBox& box) const { return path.intersects(box); }

  bool intersectObject(int other) {
    const Facet& f = facets[static_cast<std::size_t>(other)];
    const double slope = dot(self.normal, f.normal);
    if (std::abs(slope) < 0.5 || shares_corner(other)) return false;
    const double t = dot(f.corner[0] - self.centre, f.normal) / slope;
    if (std::abs(t) > std::min(reach, std::abs(along)) || !contains(f, self.centre + t * self.normal))
      return false;
    along = t;
    found = other;
    return false;
  }

  bool shares_corner(int other) const {
    const Triangle &a = triangles[static_cast<std::size_t>(from)],
                   &b = triangles[static_cast<std::size_t>(other)];
    return std::any_of(a.begin(), a.end(),
                       [&](int i) { return std::find(b.begin(), b.end(), i) != b.end(); });
  }

  static bool contains(const Facet& f, const Vec3d& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d& a = f.corner[i];
      if (dot(cross(f.corner[(i + 1) % 3] - a, p - a), f.normal) < -1e-9 * f.area) return false;
    }
    return true;
  }
};

struct Partner {
  int facet = -1;
  double along = 0.0;
};

std::vector<Partner> partners_of(const std::vector<Facet>& facets, const std::vector<Triangle>& triangles,
                                 double reach) {
  std::vector<int> indices;
  std::vector<FacetBox> boxes;
  for (const Facet& f : facets) {
    indices.push_back(static_cast<int>(indices.size()));
    boxes.push_back(box_around({f.corner[0], f.corner[1], f.corner[2]}));
  }
  const Eigen::KdBVH<double, 3, int> tree(indices.begin(), indices.end(), boxes.begin(), boxes.end());
  std::vector<Partner> partners(facets.size());
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (facets[i].area == 0.0) continue;
    Look look{facets, triangles, static_cast<int>(i), reach};
    Eigen::BVIntersect(tree, look);
    if (look.found >= 0) partners[i] = {look.found, look.along};
  }
  return partners;
}

/// Returns, for each facet, the number of its part of neighbouring facets that all have a partner; -1 for a
/// facet without partner.
std::vector<int> partnered_parts(const std::vector<Triangle>& triangles,
                                 const std::vector<Partner>& partners) {
  std::vector<Triangle> partnered;
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (partners[i].facet >= 0) {
      partnered.push_back(triangles[i]);
      which.push_back(i);
    }
  const Patches patches = orient_patches(partnered);
  std::vector<int> parts(triangles.size(), -1);
  for (std::size_t k = 0; k < which.size(); ++k) parts[which[k]] = patches.number[k];
  return parts;
}

Vec3d middle_of(const std::vector<Facet>& facets) {
  Vec3d sum;
  double area = 0.0;
  for (const Facet& f : facets) {
    sum += f.area * f.centre;
    area += f.area;
  }
  return (1.0 / area) * sum;
}

/// Returns whether each facet belongs to the outer side. A part does if most of it has its partner towards
/// the middle. A part that is its own partner is joined around the rim: there, each facet is decided by
/// itself.
std::vector<bool> outer_side(const std::vector<Facet>& facets, const std::vector<Partner>& partners,
                             const std::vector<int>& parts) {
  const Vec3d middle = middle_of(facets);
  struct Part {
    double area = 0.0, inward = 0.0, own = 0.0;
  };
  std::map<int, Part> all;
  const auto inward = [&](std::size_t i) {
    return partners[i].along * dot(facets[i].normal, middle - facets[i].centre) > 0.0;
  };
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (parts[i] < 0) continue;
    Part& part = all[parts[i]];
    part.area += facets[i].area;
    part.inward += inward(i) ? facets[i].area : -facets[i].area;
    part.own += parts[static_cast<std::size_t>(partners[i].facet)] == parts[i] ? facets[i].area : 0.0;
  }
  std::vector<bool> outer(facets.size());
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (parts[i] < 0) {
      outer[i] = dot(facets[i].normal, facets[i].centre - middle) > 0.0;
    } else {
      const Part& part = all[parts[i]];
      outer[i] = part.own > 0.2 * part.area ? inward(i) : part.inward > 0.0;
    }
  }
  return outer;
}

}  // namespace

void take_middle_of_sheet(MeasuredSurface& s, RepairReport& report) {
  if (s.triangles.size() < 2) return;
  const std::vector<Facet> facets = facets_of(s);
  const std::vector<Partner> partners = partners_of(facets, s.triangles, thickest * largest_extent(s));
  double area = 0.0, partnered = 0.0;
  std::vector<double> distances;
  for (std::size_t i = 0; i < facets.size(); ++i) {
    area += facets[i].area;
    if (partners[i].facet < 0) continue;
    partnered += facets[i].area;
    distances.push_back(std::abs(partners[i].along));
  }
  report.sheet_share = area > 0.0 ? partnered / area : 0.0;
  if (report.sheet_share < least_share) return;
  report.sheet_thickness = median(std::move(distances));

  const std::vector<bool> outer = outer_side(facets, partners, partnered_parts(s.triangles, partners));
  std::vector<Triangle> kept;
  std::vector<Vec3d> shift(s.points.size());
  std::vector<double> weight(s.points.size());
  for (std::size_t i = 0; i < facets.size(); ++i) {
    if (!outer[i]) continue;
    kept.push_back(s.triangles[i]);
    if (partners[i].facet < 0) continue;
    for (const int corner : s.triangles[i]) {
      shift[static_cast<std::size_t>(corner)] += 0.5 * partners[i].along * facets[i].area * facets[i].normal;
      weight[static_cast<std::size_t>(corner)] += facets[i].area;
    }
  }
  for (std::size_t i = 0; i < s.points.size(); ++i)
    if (weight[i] > 0.0) s.points[i] += (1.0 / weight[i]) * shift[i];
  report.sheet_triangles = s.triangles.size() - kept.size();
  s.triangles = std::move(kept);
}

}  // namespace trunk
