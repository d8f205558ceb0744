#include "surface/closest_points.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <thread>
#include <unsupported/Eigen/BVH>
#include <vector>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

using Corners = std::array<Vec3d, 3>;
using Box = Eigen::AlignedBox3d;

Eigen::Vector3d to_eigen(const Vec3d& a) {
  return {a.x(), a.y(), a.z()};
}

Box box_of(const Corners& corners) {
  Box box(to_eigen(corners[0]));
  for (const Vec3d& corner : corners) box.extend(to_eigen(corner));
  return box;
}

/// The closest of the candidates so far. `distance` is squared here.
struct Closest {
  const Vec3d& p;
  const Corners& corners;
  ClosestPoints::Hit hit{{}, -1, {}, HUGE_VAL};

  void consider(const std::array<double, 3>& weight) {
    const Vec3d point = weight[0] * corners[0] + weight[1] * corners[1] + weight[2] * corners[2];
    const double squared = dot(p - point, p - point);
    if (squared < hit.distance) hit = {point, hit.triangle, weight, squared};
  }
};

/// Returns the closest point of the three edges and, if the point lies over the inside, of the plane. The
/// edges count even then, since the plane of a sliver is mostly round-off.
ClosestPoints::Hit closest_on(const Corners& corners, const Vec3d& p) {
  Closest closest{p, corners};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const Vec3d edge = corners[j] - corners[i];
    const double length2 = dot(edge, edge);
    const double along = length2 > 0.0 ? std::clamp(dot(p - corners[i], edge) / length2, 0.0, 1.0) : 0.0;
    std::array<double, 3> weight{};
    weight[i] = 1.0 - along;
    weight[j] = along;
    closest.consider(weight);
  }
  const Vec3d a = corners[1] - corners[0], b = corners[2] - corners[0], q = p - corners[0];
  const Vec3d normal = cross(a, b);
  if (const double area2 = dot(normal, normal); area2 > 0.0) {
    const double v = dot(cross(q, b), normal) / area2, w = dot(cross(a, q), normal) / area2;
    if (v >= 0.0 && w >= 0.0 && v + w <= 1.0) closest.consider({1.0 - v - w, v, w});
  }
  return closest.hit;
}

using Boxes = Eigen::KdBVH<double, 3, int>;

/// Goes down the tree, the nearer box first, and skips boxes that are farther than the closest point so far.
struct Search {
  const Boxes& boxes;
  const std::vector<Corners>& triangles;
  Vec3d p;
  Eigen::Vector3d at = to_eigen(p);
  ClosestPoints::Hit hit{{}, -1, {}, HUGE_VAL};  // `distance` is squared here

  double squared_distance(int box) const { return boxes.getVolume(box).squaredExteriorDistance(at); }

  void below(int box) {
    Boxes::VolumeIterator inner = nullptr, inner_end = nullptr;
    Boxes::ObjectIterator triangle = nullptr, triangle_end = nullptr;
    boxes.getChildren(box, inner, inner_end, triangle, triangle_end);
    for (; triangle != triangle_end; ++triangle) consider(*triangle);
    if (inner == inner_end) return;
    int near = *inner, far = *(inner_end - 1);
    double to_near = squared_distance(near), to_far = squared_distance(far);
    if (to_far < to_near) {
      std::swap(near, far);
      std::swap(to_near, to_far);
    }
    if (to_near < hit.distance) below(near);
    if (far != near && to_far < hit.distance) below(far);
  }

  void consider(int triangle) {
    const Corners& corners = triangles[static_cast<std::size_t>(triangle)];
    if (box_of(corners).squaredExteriorDistance(at) >= hit.distance) return;
    const ClosestPoints::Hit found = closest_on(corners, p);
    if (found.distance < hit.distance) {
      hit = found;
      hit.triangle = triangle;
    }
  }
};

}  // namespace

struct ClosestPoints::Tree {
  std::vector<Corners> triangles;
  Boxes boxes;
};

ClosestPoints::ClosestPoints(std::span<const Vec3d> points, std::span<const Triangle> triangles) {
  if (triangles.empty()) throw InputError({}, "a surface without triangles has no closest point");
  auto tree = std::make_unique<Tree>();
  std::vector<int> indices;
  std::vector<Box> boxes;
  for (const Triangle& triangle : triangles) {
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto point = static_cast<std::size_t>(triangle[i]);
      if (triangle[i] < 0 || point >= points.size())
        throw InputError({}, fmt::format("a triangle has corner {}", triangle[i]),
                         points.empty() ? "points" : fmt::format("a point 0 to {}", points.size() - 1));
      corners[i] = points[point];
    }
    indices.push_back(static_cast<int>(indices.size()));
    boxes.push_back(box_of(corners));
    tree->triangles.push_back(corners);
  }
  tree->boxes.init(indices.begin(), indices.end(), boxes.begin(), boxes.end());
  tree_ = std::move(tree);
}

ClosestPoints::~ClosestPoints() = default;
ClosestPoints::ClosestPoints(ClosestPoints&&) noexcept = default;
ClosestPoints& ClosestPoints::operator=(ClosestPoints&&) noexcept = default;

ClosestPoints::Hit ClosestPoints::operator()(const Vec3d& p) const {
  Search search{tree_->boxes, tree_->triangles, p};
  search.below(tree_->boxes.getRootIndex());
  search.hit.distance = std::sqrt(search.hit.distance);
  return search.hit;
}

std::vector<ClosestPoints::Hit> ClosestPoints::operator()(std::span<const Vec3d> points) const {
  constexpr std::size_t worth_a_thread = 200;
  const std::size_t threads = std::clamp<std::size_t>(points.size() / worth_a_thread, 1,
                                                      std::max(1u, std::thread::hardware_concurrency()));
  std::vector<Hit> hits(points.size());
  const auto work = [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) hits[i] = (*this)(points[i]);
  };
  std::vector<std::jthread> others;
  for (std::size_t k = 1; k < threads; ++k)
    others.emplace_back(work, k * points.size() / threads, (k + 1) * points.size() / threads);
  work(0, points.size() / threads);
  others.clear();  // joins
  return hits;
}

}  // namespace trunk
