#include "surface/repair.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "surface/closest_points.hpp"
#include "surface/facets.hpp"
#include "surface/merge_points.hpp"
#include "surface/sets.hpp"
#include "surface/sheets.hpp"

namespace trunk {
namespace {

constexpr double merge_tolerance = 1e-5;  // of the largest extent

void drop_unused_points(MeasuredSurface& s, RepairReport& report) {
  std::vector<int> number(s.points.size(), -1);
  std::vector<Vec3d> kept;
  for (Triangle& t : s.triangles)
    for (int& corner : t) {
      int& n = number[static_cast<std::size_t>(corner)];
      if (n < 0) {
        n = static_cast<int>(kept.size());
        kept.push_back(point_of(s.points, corner));
      }
      corner = n;
    }
  report.isolated_points += s.points.size() - kept.size();
  s.points = std::move(kept);
}

void drop_useless_triangles(MeasuredSurface& s, RepairReport& report) {
  std::set<Triangle> seen;
  const double thin = merge_tolerance * largest_extent(s);
  std::erase_if(s.triangles, [&](const Triangle& t) {
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) return ++report.degenerate, true;
    Triangle sorted = t;
    std::sort(sorted.begin(), sorted.end());
    if (!seen.insert(sorted).second) return ++report.duplicates, true;
    double longest = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
      longest = std::max(longest, norm(point_of(s.points, t[(i + 1) % 3]) - point_of(s.points, t[i])));
    report.slivers += 2.0 * norm(area_vector(s.points, t)) < thin * longest;
    return false;
  });
}

void drop_specks(MeasuredSurface& s, RepairReport& report) {
  constexpr double speck = 0.005, most_dropped = 0.05;
  const std::vector<int> part = connected_parts(s.triangles, s.points.size());
  std::map<int, double> area;
  double total = 0.0, dropped = 0.0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const double a = norm(area_vector(s.points, s.triangles[i]));
    area[part[i]] += a;
    total += a;
  }
  std::size_t specks = 0;
  for (const auto& [number, a] : area)
    if (a < speck * total) {
      dropped += a;
      ++specks;
    }
  if (specks == 0 || dropped > most_dropped * total) return;
  std::vector<Triangle> kept;
  for (std::size_t i = 0; i < part.size(); ++i)
    if (area[part[i]] >= speck * total) kept.push_back(s.triangles[i]);
  s.triangles = std::move(kept);
  report.specks += specks;
}

/// Returns the middles of the triangles of one part.
std::vector<Vec3d> middles_of(const MeasuredSurface& s, const std::vector<int>& part, int wanted) {
  std::vector<Vec3d> middles;
  for (std::size_t i = 0; i < part.size(); ++i)
    if (part[i] == wanted) middles.push_back(centre_of(s.points, s.triangles[i]));
  return middles;
}

void drop_islands(MeasuredSurface& s, RepairReport& report) {
  constexpr double small = 0.1, far = 0.2;
  const std::vector<int> part = connected_parts(s.triangles, s.points.size());
  std::map<int, double> area;
  double total = 0.0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const double a = norm(area_vector(s.points, s.triangles[i]));
    area[part[i]] += a;
    total += a;
  }
  if (area.size() < 2) return;
  const int largest =
      std::max_element(area.begin(), area.end(), [](auto& a, auto& b) { return a.second < b.second; })->first;
  MeasuredSurface main{"", s.points, {}};
  for (std::size_t i = 0; i < part.size(); ++i)
    if (part[i] == largest) main.triangles.push_back(s.triangles[i]);
  const ClosestPoints closest(main.points, main.triangles);
  const double reach = far * largest_extent(main);
  std::set<int> dropped;
  for (const auto& [number, a] : area) {
    if (a >= small * total) continue;
    double distance = HUGE_VAL;
    for (const Vec3d& p : middles_of(s, part, number)) distance = std::min(distance, closest(p).distance);
    if (distance < reach) continue;
    report.island_distance = dropped.empty() ? distance : std::min(distance, report.island_distance);
    dropped.insert(number);
  }
  report.islands += dropped.size();
  std::vector<Triangle> kept;
  for (std::size_t i = 0; i < part.size(); ++i)
    if (!dropped.contains(part[i])) kept.push_back(s.triangles[i]);
  s.triangles = std::move(kept);
}

using EdgeCounts = std::map<std::pair<int, int>, int>;

EdgeCounts edge_counts(const std::vector<Triangle>& triangles) {
  EdgeCounts counts;
  for (const Triangle& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) ++counts[std::minmax(t[i], t[(i + 1) % 3])];
  return counts;
}

void count_features(const MeasuredSurface& s, RepairReport& report) {
  Sets loops(s.points.size());
  std::set<int> on_border, roots;
  for (const auto& [edge, count] : edge_counts(s.triangles)) {
    if (count == 1) {
      loops.join(edge.first, edge.second);
      on_border.insert(edge.first);
    }
    report.branching_edges += count > 2;
  }
  for (const int point : on_border) roots.insert(loops.find(point));
  report.borders = roots.size();
  const std::vector<int> part = connected_parts(s.triangles, s.points.size());
  report.pieces =
      part.empty() ? 0 : static_cast<std::size_t>(*std::max_element(part.begin(), part.end())) + 1;
}

}  // namespace

double largest_extent(const MeasuredSurface& s) {
  double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (const Triangle& t : s.triangles)
    for (const int corner : t) {
      const Vec3d& p = point_of(s.points, corner);
      const double x[3] = {p.x(), p.y(), p.z()};
      for (int i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], x[i]);
        high[i] = std::max(high[i], x[i]);
      }
    }
  return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2], 0.0});
}

double flatness(const MeasuredSurface& s) {
  if (s.points.empty()) return 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Vec3d& p : s.points) mean += Eigen::Vector3d(p.x(), p.y(), p.z());
  mean /= static_cast<double>(s.points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3d& p : s.points) {
    const Eigen::Vector3d d = Eigen::Vector3d(p.x(), p.y(), p.z()) - mean;
    spread += d * d.transpose();
  }
  const Eigen::Vector3d values = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvalues();
  return values[2] > 0.0 ? std::sqrt(std::max(values[0], 0.0) / values[2]) : 0.0;
}

RepairReport repair(MeasuredSurface& s) {
  RepairReport report;
  report.points_read = s.points.size();
  report.triangles_read = s.triangles.size();
  drop_unused_points(s, report);
  report.merged_points = merge_points(s, merge_tolerance * largest_extent(s));
  drop_useless_triangles(s, report);
  drop_specks(s, report);
  drop_islands(s, report);
  const Patches patches = orient_patches(s.triangles);
  report.turned = patches.turned;
  report.oriented = patches.possible;
  face_outward(s);
  take_middle_of_sheet(s, report);
  if (report.two_sided()) {
    drop_specks(s, report);
    face_outward(s);
  }
  RepairReport merged;  // not reported: points that merging and dropping left over are counted already
  drop_unused_points(s, merged);
  count_features(s, report);
  return report;
}

}  // namespace trunk
