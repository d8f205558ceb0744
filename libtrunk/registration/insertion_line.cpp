#include "registration/insertion_line.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "errors/input_error.hpp"
#include "math/median.hpp"

namespace trunk {
namespace {

constexpr std::size_t sector_count = 72, widest_bridge = 9;
constexpr double gap = 4.0;  // times the scatter: points farther off are not on the curve
constexpr Eigen::Index coefficients = 6;

using Row = Eigen::Matrix<double, coefficients, 1>;

/// Returns the basis of the curve: a plane, a sag at both sides, and a wide and a narrow rise in front. The
/// margin of the ribs has these; a gap in another place has not.
Row basis_at(double turns, bool rising) {
  const double angle = 2.0 * std::numbers::pi * turns, front = rising ? 0.5 * (1.0 + std::sin(angle)) : 0.0;
  Row row;
  row << 1.0, std::cos(angle), std::sin(angle), std::cos(2.0 * angle), std::pow(front, 4.0),
      std::pow(front, 12.0);
  return row;
}

/// A lowest point and its angle.
struct Low {
  double turns, height;  // 0 to 1; m
};

struct Curve {
  Row coefficients = Row::Zero();
  std::vector<double> off;  // [points] distance over the scatter

  std::vector<double> near() const {
    std::vector<double> is_near;
    for (const double distance : off) is_near.push_back(distance <= gap ? 1.0 : 0.0);
    return is_near;
  }
  double rise() const { return coefficients[4] + coefficients[5]; }
  double tilt() const { return std::abs(coefficients[1]); }
};

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Returns the curve by least squares with Tukey's weights, whose reach shrinks to four times the scatter.
/// Points below the curve keep their weight, since a gap in the data can only raise the lowest points.
Curve fitted_curve(const std::vector<Low>& points, std::vector<double> weight, bool rising) {
  constexpr int rounds = 40;
  constexpr double least_scatter = 4e-3, most_scatter = 8e-3, widest_reach = 0.06, shrink = 0.9,
                   flatness = 0.01;
  Curve curve;
  curve.off.resize(points.size());
  double scatter = least_scatter, reach = widest_reach;
  for (int round = 0; round < rounds; ++round, reach *= shrink) {
    Eigen::Matrix<double, coefficients, coefficients> normal = flatness * decltype(normal)::Identity();
    normal(0, 0) = 0.0;  // the height itself is free
    Row right = Row::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Row row = basis_at(points[i].turns, rising);
      normal += weight[i] * row * row.transpose();
      right += weight[i] * points[i].height * row;
    }
    curve.coefficients = normal.ldlt().solve(right);
    std::vector<double> above;
    for (std::size_t i = 0; i < points.size(); ++i) {
      above.push_back(points[i].height - basis_at(points[i].turns, rising).dot(curve.coefficients));
      curve.off[i] = std::abs(above[i]);
    }
    scatter = std::clamp(1.4826 * upper_median(curve.off), least_scatter, most_scatter);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double scaled = std::clamp(above[i] / std::max(gap * scatter, reach), 0.0, 1.0);
      weight[i] = (1.0 - scaled * scaled) * (1.0 - scaled * scaled);
    }
  }
  for (double& distance : curve.off) distance /= scatter;
  return curve;
}

/// Returns the curve of the margin. The first fit has no rise and begins with the lower half of the points.
/// The second has a rise and begins with the points on the first curve and all points in front. The second
/// one counts if its rise is possible and more points lie on it.
Curve margin_of(const std::vector<Low>& points, double highest_rise) {
  std::vector<double> heights, weight;
  for (const Low& p : points) heights.push_back(p.height);
  const double middle = upper_median(heights);
  for (const Low& p : points) weight.push_back(p.height <= middle ? 1.0 : 0.0);
  Curve level = fitted_curve(points, weight, false);
  weight = level.near();
  for (std::size_t i = 0; i < points.size(); ++i)
    if (std::sin(2.0 * std::numbers::pi * points[i].turns) > 0.2) weight[i] = 1.0;
  Curve rising = fitted_curve(points, weight, true);
  constexpr double most_tilt = 15e-3;  // m, to one side
  const bool possible = rising.rise() > 0.0 && rising.rise() <= highest_rise && rising.tilt() <= most_tilt;
  return possible && sum(rising.near()) > sum(level.near()) ? rising : level;
}

}  // namespace

InsertionLine::InsertionLine(std::span<const Vec3d> points, const Vec3d& centre, double half_width,
                             double half_depth, double highest_rise)
    : centre_(centre), half_width_(half_width), half_depth_(half_depth), lowest_(sector_count) {
  for (const Vec3d& p : points) {
    auto& lowest = lowest_[std::min(static_cast<std::size_t>(turns(p) * sector_count), sector_count - 1)];
    if (!lowest || p.z() < lowest->z()) lowest = p;
  }
  std::vector<Low> there;
  for (const auto& p : lowest_)
    if (p) there.push_back({turns(*p), p->z()});
  if (there.empty()) throw InputError({}, "a surface without points has no lower border");
  const Curve curve = margin_of(there, highest_rise);
  curve_.assign(curve.coefficients.begin(), curve.coefficients.end());
  auto off = curve.off.begin();
  for (auto& p : lowest_)
    if (p && *off++ > gap) p.reset();
}

double InsertionLine::turns(const Vec3d& p) const {
  const double angle = std::atan2((p.y() - centre_.y()) / half_depth_, (p.x() - centre_.x()) / half_width_);
  return angle / (2.0 * std::numbers::pi) + (angle < 0.0 ? 1.0 : 0.0);
}

std::optional<std::size_t> InsertionLine::measured_within_gap(std::size_t sector, bool forward) const {
  for (std::size_t away = 0; away <= widest_bridge; ++away)
    if (lowest_[(sector + (forward ? away : sector_count - away)) % sector_count]) return away;
  return std::nullopt;
}

std::optional<InsertionLine::LinePoint> InsertionLine::beside(const Vec3d& particle) const {
  const double at = turns(particle) * sector_count - 0.5 + sector_count;
  const auto below = static_cast<std::size_t>(at);
  const auto back = measured_within_gap(below, false), ahead = measured_within_gap(below + 1, true);
  if (!back || !ahead || *back + *ahead > widest_bridge) return std::nullopt;
  const Vec3d &a = *lowest_[(below + sector_count - *back) % sector_count],
              &b = *lowest_[(below + 1 + *ahead) % sector_count];
  const double share = (at - static_cast<double>(below) + static_cast<double>(*back)) /
                       static_cast<double>(*back + 1 + *ahead);
  const Vec3d way = b - a, up{0.0, 0.0, 1.0};
  const Vec3d upward = dot(way, way) * up - way.z() * way, outward = cross(way, upward);
  return LinePoint{a + share * way, (1.0 / norm(upward)) * upward, (1.0 / norm(outward)) * outward};
}

double InsertionLine::height_beside(const Vec3d& particle) const {
  return Eigen::Map<const Row>(curve_.data()).dot(basis_at(turns(particle), true));
}

double InsertionLine::covered() const {
  const auto there =
      std::count_if(lowest_.begin(), lowest_.end(), [](const auto& p) { return p.has_value(); });
  return static_cast<double>(there) / sector_count;
}

double InsertionLine::low_height() const {
  std::vector<double> heights;
  for (const auto& p : lowest_)
    if (p) heights.push_back(p->z());
  if (heights.empty()) return 0.0;
  const auto quarter = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 4);
  std::nth_element(heights.begin(), quarter, heights.end());
  return *quarter;
}

}  // namespace trunk
