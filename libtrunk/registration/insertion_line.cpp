#include "registration/insertion_line.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace trunk {
namespace {

constexpr std::size_t sector_count = 72;
constexpr double gap = 4.0;  // times the scatter: no longer on the curve
constexpr Eigen::Index coefficients = 6;

using Row = Eigen::Matrix<double, coefficients, 1>;

/// A plane, a sag at both sides, and two rises in front, a wide and a narrow one: what the ribs' margin does
/// and a gap elsewhere does not.
Row basis_at(double turns, bool rising) {
  const double angle = 2.0 * std::numbers::pi * turns, front = rising ? 0.5 * (1.0 + std::sin(angle)) : 0.0;
  Row row;
  row << 1.0, std::cos(angle), std::sin(angle), std::cos(2.0 * angle), std::pow(front, 4.0),
      std::pow(front, 12.0);
  return row;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

InsertionLine::InsertionLine(std::span<const Vec3d> points, const Vec3d& centre, double half_width,
                             double half_depth, double highest_rise)
    : centre_(centre), half_width_(half_width), half_depth_(half_depth), lowest_(sector_count) {
  for (const Vec3d& p : points) {
    auto& lowest = lowest_[std::min(static_cast<std::size_t>(turns(p) * sector_count), sector_count - 1)];
    if (!lowest || p.z() < lowest->z()) lowest = p;
  }
  std::vector<double> residual = fit(true);
  if (curve_[4] + curve_[5] > highest_rise) residual = fit(false);
  auto at = residual.begin();
  for (auto& p : lowest_)
    if (p && *at++ > gap) p.reset();
}

double InsertionLine::turns(const Vec3d& p) const {
  const double angle = std::atan2((p.y() - centre_.y()) / half_depth_, (p.x() - centre_.x()) / half_width_);
  return angle / (2.0 * std::numbers::pi) + (angle < 0.0 ? 1.0 : 0.0);
}

/// Least squares with the weights of Geman and McClure, whose reach shrinks to twice the scatter. A gap in
/// the data only raises their lowest points: what lies below the curve keeps its weight.
std::vector<double> InsertionLine::fit(bool rising) {
  constexpr int rounds = 40;
  constexpr double least_scatter = 4e-3, most_scatter = 8e-3, first_reach = 0.1, shrink = 0.85,
                   flatness = 0.01;
  rising_ = rising;
  std::vector<Row> rows;
  std::vector<double> heights;
  for (const auto& p : lowest_)
    if (p) {
      rows.push_back(basis_at(turns(*p), rising));
      heights.push_back(p->z());
    }
  std::vector<double> weight(rows.size(), 1.0), off(rows.size(), 0.0);
  double scatter = least_scatter, reach = first_reach;
  for (int round = 0; round < rounds; ++round, reach *= shrink) {
    Eigen::Matrix<double, coefficients, coefficients> normal = flatness * decltype(normal)::Identity();
    normal(0, 0) = 0.0;  // the height itself is free
    Row right = Row::Zero();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      normal += weight[i] * rows[i] * rows[i].transpose();
      right += weight[i] * heights[i] * rows[i];
    }
    const Row curve = normal.ldlt().solve(right);
    curve_.assign(curve.begin(), curve.end());
    for (std::size_t i = 0; i < rows.size(); ++i) off[i] = std::abs(heights[i] - rows[i].dot(curve));
    scatter = std::clamp(1.4826 * median(off), least_scatter, most_scatter);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double above = std::max(0.0, heights[i] - rows[i].dot(curve));
      const double scaled = above / std::max(2.0 * scatter, reach);
      weight[i] = 1.0 / ((1.0 + scaled * scaled) * (1.0 + scaled * scaled));
    }
  }
  for (double& distance : off) distance /= scatter;
  return off;
}

std::optional<Vec3d> InsertionLine::beside(const Vec3d& particle) const {
  const double at = turns(particle) * sector_count - 0.5 + sector_count;
  const auto below = static_cast<std::size_t>(at);
  const auto &a = lowest_[below % sector_count], &b = lowest_[(below + 1) % sector_count];
  if (!a || !b) return std::nullopt;
  const double share = at - static_cast<double>(below);
  return (1.0 - share) * *a + share * *b;
}

double InsertionLine::height_beside(const Vec3d& particle) const {
  return Eigen::Map<const Row>(curve_.data()).dot(basis_at(turns(particle), rising_));
}

double InsertionLine::covered() const {
  const auto there =
      std::count_if(lowest_.begin(), lowest_.end(), [](const auto& p) { return p.has_value(); });
  return static_cast<double>(there) / sector_count;
}

double InsertionLine::mean_height() const {
  double sum = 0.0, count = 0.0;
  for (const auto& p : lowest_)
    if (p) {
      sum += p->z();
      ++count;
    }
  return count > 0.0 ? sum / count : 0.0;
}

}  // namespace trunk
