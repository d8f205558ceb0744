#include "surface/repair.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>

#include "surface/sheets.hpp"

namespace trunk {
namespace {

constexpr double merge_tolerance = 1e-5;  // of the largest extent

const Vec3d& at(const std::vector<Vec3d>& points, int i) {
  return points[static_cast<std::size_t>(i)];
}

Vec3d area_vector(const std::vector<Vec3d>& points, const Triangle& t) {
  return 0.5 * cross(at(points, t[1]) - at(points, t[0]), at(points, t[2]) - at(points, t[0]));
}

Vec3d centre_of(const std::vector<Vec3d>& points, const Triangle& t) {
  return (1.0 / 3.0) * (at(points, t[0]) + at(points, t[1]) + at(points, t[2]));
}

/// Union of sets, by halving paths.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    for (auto* p = &parent_[static_cast<std::size_t>(i)]; *p != i; p = &parent_[static_cast<std::size_t>(i)])
      i = *p = parent_[static_cast<std::size_t>(*p)];
    return i;
  }
  void join(int a, int b) { parent_[static_cast<std::size_t>(find(a))] = find(b); }

 private:
  std::vector<int> parent_;
};

/// Renumbers sets from 0 in the order in which they come.
class Numbering {
 public:
  int operator()(int set) {
    return numbers_.try_emplace(set, static_cast<int>(numbers_.size())).first->second;
  }

 private:
  std::unordered_map<int, int> numbers_;
};

/// Points in cubes of eight tolerances: a near one is in the same cube, or across the face that is near.
class NearPoints {
 public:
  explicit NearPoints(double tolerance) : tolerance_(tolerance) {}

  /// An earlier point within the tolerance, or -1; then this one is kept as `index`.
  int find_or_add(const std::vector<Vec3d>& points, int index) {
    const Vec3d& p = at(points, index);
    const double edge = 8.0 * tolerance_;
    std::array<std::array<std::int64_t, 2>, 3> cells;
    const std::array<double, 3> x{p.x() / edge, p.y() / edge, p.z() / edge};
    for (std::size_t i = 0; i < 3; ++i) {
      const double cell = std::floor(x[i]), within = x[i] - cell;
      cells[i][0] = static_cast<std::int64_t>(cell);
      cells[i][1] = cells[i][0] + (within < 0.125 ? -1 : within > 0.875 ? 1 : 0);
    }
    for (std::size_t corner = 0; corner < 8; ++corner) {
      bool repeated = false;
      std::array<std::int64_t, 3> cell;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t which = corner >> i & 1;
        repeated = repeated || (which == 1 && cells[i][1] == cells[i][0]);
        cell[i] = cells[i][which];
      }
      if (repeated) continue;
      const auto [begin, end] = cells_.equal_range(key(cell));
      for (auto known = begin; known != end; ++known)
        if (norm(at(points, known->second) - p) <= tolerance_) return known->second;
    }
    cells_.emplace(key({cells[0][0], cells[1][0], cells[2][0]}), index);
    return -1;
  }

 private:
  static std::uint64_t key(const std::array<std::int64_t, 3>& cell) {
    std::uint64_t hash = 0;
    for (const std::int64_t i : cell) hash = (hash ^ static_cast<std::uint64_t>(i)) * 0x9E3779B97F4A7C15u;
    return hash;
  }

  double tolerance_;
  std::unordered_multimap<std::uint64_t, int> cells_;
};

void drop_unused_points(MeasuredSurface& s, RepairReport& report) {
  std::vector<int> number(s.points.size(), -1);
  std::vector<Vec3d> kept;
  for (Triangle& t : s.triangles)
    for (int& corner : t) {
      int& n = number[static_cast<std::size_t>(corner)];
      if (n < 0) {
        n = static_cast<int>(kept.size());
        kept.push_back(at(s.points, corner));
      }
      corner = n;
    }
  report.isolated_points += s.points.size() - kept.size();
  s.points = std::move(kept);
}

void merge_points(MeasuredSurface& s, RepairReport& report) {
  const double extent = largest_extent(s);
  NearPoints near(std::max(merge_tolerance * extent, 1e-300));
  std::vector<int> same(s.points.size());
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    const int index = static_cast<int>(i), earlier = near.find_or_add(s.points, index);
    same[i] = earlier < 0 ? index : earlier;
    report.merged_points += earlier >= 0;
  }
  for (Triangle& t : s.triangles)
    for (int& corner : t) corner = same[static_cast<std::size_t>(corner)];
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
      longest = std::max(longest, norm(at(s.points, t[(i + 1) % 3]) - at(s.points, t[i])));
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
  report.specks = specks;
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

/// Positive where a patch faces away from its middle: its volume if it is closed.
struct Facing {
  Vec3d weighted_centre, net;
  double area = 0.0, away = 0.0, reach = 0.0;
};

}  // namespace

double largest_extent(const MeasuredSurface& s) {
  double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (const Triangle& t : s.triangles)
    for (const int corner : t) {
      const Vec3d& p = at(s.points, corner);
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

std::vector<int> connected_parts(std::span<const Triangle> triangles, std::size_t points) {
  Sets sets(points);
  for (const Triangle& t : triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[0], t[2]);
  }
  Numbering number;
  std::vector<int> parts;
  for (const Triangle& t : triangles) parts.push_back(number(sets.find(t[0])));
  return parts;
}

Patches orient_patches(std::vector<Triangle>& triangles) {
  std::map<std::pair<int, int>, std::vector<std::size_t>> sides;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      sides[std::minmax(triangles[i][k], triangles[i][(k + 1) % 3])].push_back(i);
  const auto runs = [](const Triangle& t, int a, int b) {
    return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
  };
  Patches patches{std::vector<int>(triangles.size(), -1), 0, true};
  int count = 0;
  for (std::size_t seed = 0; seed < triangles.size(); ++seed) {
    if (patches.number[seed] >= 0) continue;
    std::vector<std::size_t> todo{seed}, members;
    std::size_t turned = 0;
    patches.number[seed] = count;
    while (!todo.empty()) {
      const std::size_t i = todo.back();
      todo.pop_back();
      members.push_back(i);
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = triangles[i][k], b = triangles[i][(k + 1) % 3];
        const auto& pair = sides.at(std::minmax(a, b));
        if (pair.size() != 2) continue;
        const std::size_t other = pair[0] == i ? pair[1] : pair[0];
        const bool agrees = runs(triangles[other], b, a);
        if (patches.number[other] >= 0) {
          patches.possible = patches.possible && agrees;
          continue;
        }
        patches.number[other] = count;
        if (!agrees) {
          std::swap(triangles[other][1], triangles[other][2]);
          ++turned;
        }
        todo.push_back(other);
      }
    }
    patches.turned += std::min(turned, members.size() - turned);
    ++count;
  }
  return patches;
}

void face_outward(MeasuredSurface& s) {
  const Patches patches = orient_patches(s.triangles);
  std::vector<Facing> facing;
  for (std::size_t i = 0; i < s.triangles.size(); ++i) {
    const auto number = static_cast<std::size_t>(patches.number[i]);
    if (facing.size() <= number) facing.resize(number + 1);
    const Vec3d normal = area_vector(s.points, s.triangles[i]);
    facing[number].area += norm(normal);
    facing[number].net += normal;
    facing[number].weighted_centre += norm(normal) * centre_of(s.points, s.triangles[i]);
  }
  for (std::size_t i = 0; i < s.triangles.size(); ++i) {
    Facing& f = facing[static_cast<std::size_t>(patches.number[i])];
    const Vec3d normal = area_vector(s.points, s.triangles[i]);
    const Vec3d out =
        centre_of(s.points, s.triangles[i]) - (1.0 / std::max(f.area, 1e-300)) * f.weighted_centre;
    f.away += dot(normal, out);
    f.reach += norm(normal) * norm(out);
  }
  for (std::size_t i = 0; i < s.triangles.size(); ++i) {
    const Facing& f = facing[static_cast<std::size_t>(patches.number[i])];
    constexpr double flat = 0.02;
    const double out = std::abs(f.away) > flat * f.reach ? f.away : f.net.z();
    if (out < 0.0) std::swap(s.triangles[i][1], s.triangles[i][2]);
  }
}

RepairReport repair(MeasuredSurface& s) {
  RepairReport report;
  report.points_read = s.points.size();
  report.triangles_read = s.triangles.size();
  drop_unused_points(s, report);
  merge_points(s, report);
  drop_useless_triangles(s, report);
  drop_specks(s, report);
  const Patches patches = orient_patches(s.triangles);
  report.turned = patches.turned;
  report.oriented = patches.possible;
  face_outward(s);
  take_middle_of_sheet(s, report);
  if (report.two_sided()) {
    drop_specks(s, report);
    face_outward(s);
  }
  RepairReport merged;  // points that merging and dropping left over are counted already
  drop_unused_points(s, merged);
  count_features(s, report);
  return report;
}

}  // namespace trunk
