#include "clinic/lung_mechanics.hpp"

#include <Eigen/Dense>
#include <algorithm>

namespace trunk {
namespace {

constexpr double longest_before_s = 1, most_of_expiration = 0.5, shortest_effort_s = 0.06;
constexpr double still_goes_on = 0.5;  // of the slope: an effort, unlike an expiration, does not end here
constexpr double clear_corner = 0.5;   // of the variance without a corner
constexpr Eigen::Index fewest_on_a_line = 4;

struct Lines {
  double squares = 0, fall = 0;
};

// Fits two lines that meet at t[corner]. Returns what the second one adds up to at the end.
Lines two_lines(const Eigen::VectorXd& t, const Eigen::VectorXd& p, Eigen::Index corner) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < t.size(); ++i) {
    const double s = t[i] - t[corner];
    const Eigen::Vector3d row(1, std::min(s, 0.0), std::max(s, 0.0));
    normal += row * row.transpose();
    right += p[i] * row;
  }
  const Eigen::Vector3d found = normal.inverse() * right;
  return {std::max(p.squaredNorm() - found.dot(right), 0.0), found[2] * (t[t.size() - 1] - t[corner])};
}

double slope_of(const Eigen::VectorXd& t, const Eigen::VectorXd& p) {
  const Eigen::VectorXd x = t.array() - t.mean();
  return x.dot(p) / x.squaredNorm();
}

double squares_about_line(const Eigen::VectorXd& t, const Eigen::VectorXd& p) {
  const Eigen::VectorXd x = t.array() - t.mean(), y = p.array() - p.mean();
  return y.squaredNorm() - x.dot(y) * x.dot(y) / x.squaredNorm();
}

}  // namespace

LungMechanics lung_mechanics(const BreathLoop& loop) {
  const auto as_vector = [](const std::vector<double>& values) {
    return Eigen::VectorXd(Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size())));
  };
  const auto centred = [](const Eigen::VectorXd& v) { return Eigen::VectorXd(v.array() - v.mean()); };
  const Eigen::VectorXd v = centred(as_vector(loop.volume_m3)), q = centred(as_vector(loop.flow_m3_s)),
                        p = centred(as_vector(loop.transpulmonary_Pa()));
  Eigen::Matrix2d normal;
  normal << v.dot(v), v.dot(q), v.dot(q), q.dot(q);
  const Eigen::Vector2d right(v.dot(p), q.dot(p)), found = normal.inverse() * right;
  LungMechanics result{found[0], found[1], 0, 0};
  const double all = p.squaredNorm();
  result.explained = all > 0 ? found.dot(right) / all : 0;
  const double volume = loop.tidal_volume_m3();
  result.rise_Pa = found[0] * volume + found[1] * volume / loop.inspiration_s;
  return result;
}

double change_before_flow(const BreathLoop& loop, const std::vector<double>& pressure, double sign) {
  const double begin = loop.flow_begins_s;
  const double window =
      std::min(longest_before_s, most_of_expiration * (loop.duration_s - loop.inspiration_s));
  const auto place = [&](double t) {
    return std::lower_bound(loop.time_s.begin(), loop.time_s.end(), t) - loop.time_s.begin();
  };
  const auto first = place(begin - window), count = place(begin) + 1 - first;
  if (count < 2 * fewest_on_a_line) return 0;
  const auto at = static_cast<std::size_t>(first);
  const Eigen::VectorXd t = Eigen::VectorXd::Map(&loop.time_s[at], count),
                        p = Eigen::VectorXd::Map(&pressure[at], count);
  const double straight = squares_about_line(t, p);
  Lines best{straight, 0};
  Eigen::Index at_best = 0;
  for (Eigen::Index corner = fewest_on_a_line - 1; corner + fewest_on_a_line <= count; ++corner) {
    if (t[count - 1] - t[corner] < shortest_effort_s) break;
    const Lines lines = two_lines(t, p, corner);
    if (lines.squares < best.squares) best = lines, at_best = corner;
  }
  if (!(best.squares < clear_corner * straight) || sign * best.fall <= 0) return 0;
  const Eigen::Index last = std::max<Eigen::Index>((count - at_best) / 2, fewest_on_a_line);
  const double goes_on = slope_of(t.tail(last), p.tail(last)) * (t[count - 1] - t[at_best]);
  return sign * goes_on >= still_goes_on * sign * best.fall ? best.fall : 0;
}

}  // namespace trunk
