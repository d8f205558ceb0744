#include "registration/lungs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "errors/input_error.hpp"
#include "math/units.hpp"
#include "mesh/volume.hpp"
#include "registration/lung_bodies.hpp"
#include "registration/surface_samples.hpp"

namespace trunk {
namespace {

// m, between the lungs: in one row at most, and where there is one lung only
constexpr double widest_gap = 0.11, usual_gap = 0.06;
// The lean that says a side; lungs of our own of several shapes lean by 0.55 to 0.65.
constexpr double least_lean = 0.1;

/// Fills each row along x between the first body and the second, unless they are farther apart than any
/// heart is wide. Returns the narrowest gap, m.
double fill_gap(const Bodies& bodies, Voxels& filled) {
  double narrowest = HUGE_VAL;
  const auto [nx, ny, nz] = filled.size();
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j) {
      int left = -1, right = nx;
      for (int i = 0; i < nx; ++i) {
        const int body = bodies.body[filled.index(i, j, k)];
        if (body == 0) left = i;
        if (body == 1) right = std::min(right, i);
      }
      const double apart = filled.edge() * static_cast<double>(right - left - 1);
      if (left < 0 || right == nx || apart <= 0.0 || apart > widest_gap) continue;
      narrowest = std::min(narrowest, apart);
      for (int i = left + 1; i < right; ++i) filled[filled.index(i, j, k)] = 1;
    }
  return narrowest < HUGE_VAL ? narrowest : 0.0;
}

/// Fills each row along x between one lung and the plane half-way to the other one, as far as a gap may be
/// wide.
void fill_to_middle(const Bodies& bodies, double inward, double middle, Voxels& filled) {
  const auto [nx, ny, nz] = filled.size();
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j) {
      int inner = -1;
      for (int i = 0; i < nx; ++i)
        if (bodies.body[filled.index(i, j, k)] >= 0 && (inner < 0 || inward > 0.0)) inner = i;
      if (inner < 0) continue;
      const double apart = inward * (middle - filled.centre(filled.index(inner, j, k)).x());
      if (apart <= 0.0 || apart > 0.5 * widest_gap) continue;
      const int step = inward > 0.0 ? 1 : -1, cells = static_cast<int>(apart / filled.edge());
      for (int i = 1; i <= cells && inner + step * i >= 0 && inner + step * i < nx; ++i)
        filled[filled.index(inner + step * i, j, k)] = 1;
    }
}

/// Returns below 0 if a lung's inner side is to the left, above 0 if it is to the right, in units of its
/// width: the top leans inward, and the middle of the volume is nearer to the flat inner side (our choice).
double inward_lean(const Voxels& solid) {
  constexpr double top_share = 0.15;
  Vec3d low(HUGE_VAL, HUGE_VAL, HUGE_VAL), high = -1.0 * low;
  std::vector<Vec3d> places;
  for (std::size_t c = 0; c < solid.count(); ++c) {
    if (solid[c] == 0) continue;
    const Vec3d p = solid.centre(c);
    places.push_back(p);
    low = {std::min(low.x(), p.x()), 0.0, std::min(low.z(), p.z())};
    high = {std::max(high.x(), p.x()), 0.0, std::max(high.z(), p.z())};
  }
  const double between = 0.5 * (low.x() + high.x()), top = high.z() - top_share * (high.z() - low.z());
  double all = 0.0, of_top = 0.0, count_of_top = 0.0;
  for (const Vec3d& p : places) {
    all += (p.x() - between) / static_cast<double>(places.size());
    if (p.z() < top) continue;
    of_top += p.x() - between;
    count_of_top += 1.0;
  }
  return (of_top / count_of_top + 2.0 * all) / (high.x() - low.x());
}

/// Returns whether nearly all of the area lies across one axis or another, as the sides of voxels do.
bool is_staircase(const MeasuredSurface& s) {
  constexpr double across = 0.999, nearly_all = 0.9;
  double area = 0.0, sides = 0.0;
  for (const Triangle& t : s.triangles) {
    const double a = surface_area(s.points, std::span(&t, 1));
    const Vec3d n = unit_normal(s.points, t);
    area += a;
    sides += std::max({std::abs(n.x()), std::abs(n.y()), std::abs(n.z())}) > across ? a : 0.0;
  }
  return sides > nearly_all * area;
}

/// Smoothes a surface without shrinking it (Taubin 1995).
void smooth(MeasuredSurface& s) {
  constexpr int rounds = 8;
  std::vector<Vec3d> sum(s.points.size());
  std::vector<double> count(s.points.size());
  for (int round = 0; round < 2 * rounds; ++round) {
    std::fill(sum.begin(), sum.end(), Vec3d());
    std::fill(count.begin(), count.end(), 0.0);
    for (const Triangle& t : s.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(t[k]);
        for (const int other : {t[(k + 1) % 3], t[(k + 2) % 3]})
          sum[at] += s.points[static_cast<std::size_t>(other)];
        count[at] += 2.0;
      }
    const double share = round % 2 == 0 ? 0.5 : -0.53;
    for (std::size_t i = 0; i < s.points.size(); ++i)
      if (count[i] > 0.0) s.points[i] += share * ((1.0 / count[i]) * sum[i] - s.points[i]);
  }
}

bool has_branching_edges(const MeasuredSurface& s) {
  std::map<std::pair<int, int>, int> edges;
  for (const Triangle& t : s.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (++edges[std::minmax(t[k], t[(k + 1) % 3])] > 2) return true;
  return false;
}

/// Returns the volume of the cubes; those that the surface cuts count half.
double volume_of(const Voxels& solid) {
  const Voxels inner = solid.shrunk(1);
  double count = 0.0;
  for (std::size_t c = 0; c < solid.count(); ++c) count += 0.5 * ((solid[c] != 0) + (inner[c] != 0));
  return count * std::pow(solid.edge(), 3.0);
}

/// Returns whether a triangle faces the middle of the body, to the side of x that `inward` says, and is not
/// part of the lower side.
bool faces_inward(const Vec3d& normal, double inward) {
  constexpr double steep = 0.5;
  return inward * normal.x() > steep && normal.z() > -steep;
}

}  // namespace

MeasuredSurface joined(const std::vector<MeasuredSurface>& surfaces) {
  MeasuredSurface all{"lungs", {}, {}};
  for (const MeasuredSurface& s : surfaces) {
    const int before = static_cast<int>(all.points.size());
    all.points.insert(all.points.end(), s.points.begin(), s.points.end());
    for (const Triangle& t : s.triangles)
      all.triangles.push_back({t[0] + before, t[1] + before, t[2] + before});
  }
  return all;
}

LungSurface outer_lungs(const MeasuredSurface& measured, std::optional<LungSide> given) {
  LungSurface result;
  MeasuredSurface lungs = measured;
  if (is_staircase(lungs)) {
    smooth(lungs);
    result.notes.emplace_back("the surface is a staircase of voxels: it is smoothed");
  }
  const Bodies bodies = bodies_of(lungs);
  const Voxels& solid = bodies.solid;
  result.two_bodies = bodies.count == 2;
  const bool branching = has_branching_edges(lungs);
  result.volume = branching || bodies.dropped > 0 ? volume_of(solid)
                                                  : enclosed_volume<double>(lungs.triangles, lungs.points);

  double inward[2] = {0.0, 0.0};  // of each body
  Voxels filled = solid;
  if (result.two_bodies) {
    inward[0] = 1.0;
    inward[1] = -1.0;
    result.gap = fill_gap(bodies, filled);
  } else {
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    for (const Triangle& t : lungs.triangles)
      for (const int i : t) {
        const Vec3d& p = lungs.points[static_cast<std::size_t>(i)];
        low[0] = std::min(low[0], p.x());
        high[0] = std::max(high[0], p.x());
        low[1] = std::min(low[1], p.y());
        high[1] = std::max(high[1], p.y());
      }
    const bool narrow = high[0] - low[0] < high[1] - low[1];
    if (given ? *given != LungSide::both : narrow) {
      const double lean = inward_lean(solid);
      if (!given && std::abs(lean) < least_lean)
        throw InputError({}, "one lung is given, and its shape does not say which one",
                         "the right or the left lung", "give --lung-side, or both lungs");
      result.side = given ? *given : lean < 0.0 ? LungSide::right : LungSide::left;
      inward[0] = result.side == LungSide::right ? -1.0 : 1.0;
      result.middle = (inward[0] < 0.0 ? low[0] : high[0]) + 0.5 * usual_gap * inward[0];
      fill_to_middle(bodies, inward[0], result.middle, filled);
      if (!given)
        result.notes.push_back(
            fmt::format("this is one lung, taken as the {} one, since its top and its flat side lie towards "
                        "the {}; the other "
                        "half of the trunk is extrapolated, as its mirror image; --lung-side overrides this",
                        result.side == LungSide::right ? "right" : "left",
                        result.side == LungSide::right ? "left" : "right"));
    }
  }

  const Voxels near_outside = filled.opposite().grown(2);
  result.outer = {lungs.name, lungs.points, {}};
  std::size_t inner = 0, facing = 0;
  for (const Triangle& t : lungs.triangles) {
    const auto at = [&](std::size_t k) { return lungs.points[static_cast<std::size_t>(t[k])]; };
    const std::size_t cell = solid.index((1.0 / 3.0) * (at(0) + at(1) + at(2)));
    const int body = bodies.body[cell];
    if (near_outside[cell] == 0 || (body < 0 && result.two_bodies)) {
      ++inner;
    } else if (faces_inward(unit_normal(lungs.points, t), inward[std::max(body, 0)])) {
      ++facing;
    } else {
      result.outer.triangles.push_back(t);
    }
  }
  if (inner + facing > 0)
    result.notes.push_back(fmt::format(
        "of {} triangles, {} that face the heart or the other lung are left out, and {} of the windpipe, of "
        "fissures or between the lungs",
        lungs.triangles.size(), facing, inner));
  if (result.two_bodies)
    result.notes.push_back(fmt::format(
        "two lungs at least {:.0f} mm apart; what lies between them is extrapolated", mm_per_m * result.gap));
  return result;
}

}  // namespace trunk
