#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "registration/lung_bodies.hpp"
#include "registration/lungs.hpp"

namespace trunk {
namespace {

using Three = std::array<double, 3>;

Three three_of(const Vec3d& p) {
  return {p.x(), p.y(), p.z()};
}

/// One lung as the places of its cubes.
struct Body {
  std::vector<Three> cells;
  Three middle{}, low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
};

Body body_of(const Bodies& bodies, int wanted) {
  Body body;
  for (std::size_t c = 0; c < bodies.body.size(); ++c)
    if (bodies.body[c] == wanted) body.cells.push_back(three_of(bodies.solid.centre(c)));
  for (const Three& p : body.cells)
    for (std::size_t k = 0; k < 3; ++k) {
      body.middle[k] += p[k] / static_cast<double>(body.cells.size());
      body.low[k] = std::min(body.low[k], p[k]);
      body.high[k] = std::max(body.high[k], p[k]);
    }
  return body;
}

/// How far the surface of a body lies behind the plane that touches it, seen along one axis from one end: one
/// depth for each column of cubes.
struct Depths {
  struct Column {
    Three place;  // of its first cube
    double depth;
  };
  std::vector<Column> columns;
};

Depths depths_of(const Body& body, double edge, std::size_t along, double from) {
  const std::size_t a = (along + 1) % 3, b = (along + 2) % 3;
  const auto number = [&](double x, double low) {
    return static_cast<std::size_t>(std::lround((x - low) / edge));
  };
  const std::size_t width = number(body.high[a], body.low[a]) + 1,
                    height = number(body.high[b], body.low[b]) + 1;
  std::vector<Depths::Column> columns(width * height, {{}, HUGE_VAL});
  for (const Three& p : body.cells) {
    const double depth = from < 0.0 ? p[along] - body.low[along] : body.high[along] - p[along];
    Depths::Column& column = columns[number(p[b], body.low[b]) * width + number(p[a], body.low[a])];
    if (depth < column.depth) column = {p, depth};
  }
  Depths depths;
  for (const Depths::Column& column : columns)
    if (column.depth < HUGE_VAL) depths.columns.push_back(column);
  return depths;
}

/// Returns how deep the middle of one end of a body lies, as a share of its length. In lungs of our own it is
/// 0.3 to 0.4 over the diaphragm and up to 0.2 at the other ends.
double hollowness(const Body& body, const Depths& depths, std::size_t along) {
  constexpr double middle = 0.15;
  double sum = 0.0, count = 0.0;
  for (const auto& [place, depth] : depths.columns) {
    double squares = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (k == along) continue;
      const double half = 0.5 * (body.high[k] - body.low[k]);
      squares += std::pow((place[k] - body.low[k]) / half - 1.0, 2.0);
    }
    if (squares > middle) continue;
    sum += depth;
    count += 1.0;
  }
  return count > 0.0 ? sum / count / (body.high[along] - body.low[along]) : 0.0;
}

/// Returns how much deeper one end of a body lies at the high third of another axis than at its low third, m.
double slope(const Body& body, const Depths& depths, std::size_t over) {
  double sum[2] = {}, count[2] = {};
  for (const auto& [place, depth] : depths.columns) {
    const double at = (place[over] - body.low[over]) / (body.high[over] - body.low[over]);
    if (at > 1.0 / 3.0 && at < 2.0 / 3.0) continue;
    sum[at > 0.5] += depth;
    count[at > 0.5] += 1.0;
  }
  return count[0] > 0.0 && count[1] > 0.0 ? sum[1] / count[1] - sum[0] / count[0] : 0.0;
}

std::string signed_name(std::size_t axis, double sign) {
  return std::string(sign < 0.0 ? "-" : "+") + "xyz"[axis];
}

std::string coordinate(std::size_t axis, double sign) {
  return std::string(sign < 0.0 ? "-" : "") + "xyz"[axis];
}

}  // namespace

std::optional<GuessedAxes> guess_axes_of_lungs(const MeasuredSurface& lungs) {
  constexpr double side_by_side = 2.0, larger = 1.01;               // our choice
  constexpr double hollow = 0.25, other_ends = 0.7, lower = 0.008;  // shares, and m
  const Bodies bodies = bodies_of(lungs);
  if (bodies.count < 2) return std::nullopt;
  const double edge = bodies.solid.edge();
  Body large = body_of(bodies, 0), small = body_of(bodies, 1);
  if (large.cells.size() < small.cells.size()) std::swap(large, small);

  Three apart;
  for (std::size_t k = 0; k < 3; ++k) apart[k] = std::abs(large.middle[k] - small.middle[k]);
  const auto lateral = static_cast<std::size_t>(std::max_element(apart.begin(), apart.end()) - apart.begin());
  std::size_t vertical = (lateral + 1) % 3, forward = (lateral + 2) % 3;
  if (apart[lateral] < side_by_side * std::max(apart[vertical], apart[forward])) return std::nullopt;

  const auto of_both = [&](auto&& measure) { return 0.5 * (measure(large) + measure(small)); };
  double deepest = 0.0, second = 0.0, up = 0.0;
  const std::size_t ends[] = {vertical, forward};
  for (const std::size_t axis : ends)
    for (const double end : {-1.0, 1.0}) {
      const double found =
          of_both([&](const Body& body) { return hollowness(body, depths_of(body, edge, axis, end), axis); });
      second = std::max(second, std::min(deepest, found));
      if (found <= deepest) continue;
      deepest = found;
      up = -end;
      vertical = axis;
    }
  if (deepest < hollow || second > other_ends * deepest) return std::nullopt;
  forward = 3 - lateral - vertical;
  const double rise =
      of_both([&](const Body& body) { return slope(body, depths_of(body, edge, vertical, -up), forward); });
  const double front = rise > 0.0 ? 1.0 : -1.0,
               right = large.middle[lateral] > small.middle[lateral] ? 1.0 : -1.0;
  // Right-handed: right = forward x up.
  const bool cyclic = (forward + 1) % 3 == vertical;
  const bool agree = right == (cyclic ? front * up : -front * up);
  if (std::abs(rise) < lower ||
      static_cast<double>(large.cells.size()) < larger * static_cast<double>(small.cells.size()) || !agree)
    return std::nullopt;

  GuessedAxes guess;
  guess.front_known = true;
  guess.axes =
      Axes(coordinate(lateral, right) + "," + coordinate(forward, front) + "," + coordinate(vertical, up));
  guess.reasons = fmt::format(
      "the lungs lie side by side along {}, their hollow side looks to {}, their lower edge is lower towards "
      "{}, as "
      "at the back, and the larger lung, as the right one, lies to {}",
      "xyz"[lateral], signed_name(vertical, -up), signed_name(forward, -front), signed_name(lateral, right));
  return guess;
}

}  // namespace trunk
