#include "compartment/compartment_breath.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace trunk {
namespace {

struct Knot {
  double time_s, height;
};
constexpr std::size_t knot_count = ShapeKnots::count + 4;
using Knots = std::array<Knot, knot_count>;

/// Returns the corners of the activation, at times from its onset.
Knots knots_of(const BreathActivation<double>& a) {
  Knots knots{};
  std::size_t k = 0;
  const double* shape = a.shape.data();
  const auto phase = [&](double start, double length, double first, double last, std::size_t inner) {
    knots[k++] = {start, first};
    for (std::size_t i = 1; i <= inner; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(inner + 1);
      knots[k++] = {start + part * length, *shape++ * (first + part * (last - first))};
    }
  };
  phase(0.0, a.rise_s, 0.0, 1.0, ShapeKnots::rise);
  phase(a.rise_s, a.fast_fall_s, 1.0, a.fast_fall_level, ShapeKnots::fast_fall);
  phase(a.rise_s + a.fast_fall_s, a.slow_fall_s, a.fast_fall_level, 0.0, ShapeKnots::slow_fall);
  knots[k] = {a.rise_s + a.fast_fall_s + a.slow_fall_s, 0.0};
  return knots;
}

/// A piece of the activation within the breath; it is straight from `from` to `to`.
struct Piece {
  double start_s, end_s, from, to;
};

/// Adds the part of a line that lies within `low` to `high`.
void add_clipped(double t0, double t1, double a0, double a1, double low, double high,
                 std::vector<Piece>& pieces) {
  const double start = std::max(t0, low), end = std::min(t1, high);
  if (!(end > start)) return;
  const double slope = (a1 - a0) / (t1 - t0);
  pieces.push_back({start, end, a0 + slope * (start - t0), a0 + slope * (end - t0)});
}

/// Returns the activation within 0 to `duration_s` as pieces in order. Each onset cuts the breath before.
std::vector<Piece> pieces_of(const BreathActivation<double>& a, double duration_s, bool periodic) {
  const Knots knots = knots_of(a);
  std::vector<Piece> pieces;
  const auto add_breath = [&](double onset_s, double low, double high) {
    for (std::size_t k = 0; k + 1 < knot_count; ++k)
      add_clipped(onset_s + knots[k].time_s, onset_s + knots[k + 1].time_s, knots[k].height,
                  knots[k + 1].height, low, high, pieces);
  };
  if (!periodic) {
    add_breath(a.onset_s, 0.0, duration_s);
    return pieces;
  }
  const double first = a.onset_s - duration_s * std::ceil(a.onset_s / duration_s);  // in (-duration, 0]
  for (const double onset : {first, first + duration_s})  // the breath that begins before, and the next one
    add_breath(onset, std::max(onset, 0.0), std::min(onset + duration_s, duration_s));
  return pieces;
}

/// Follows the compartment for unit gain through pieces of the activation.
class Course {
 public:
  Course(double tau_s, const std::vector<Piece>& pieces) : tau_(tau_s), pieces_(pieces) {}

  double at(double time_s) {
    while (now_ < time_s) {
      while (piece_ < pieces_.size() && pieces_[piece_].end_s <= now_) ++piece_;
      if (piece_ == pieces_.size() || pieces_[piece_].start_s > now_) {  // the muscle rests
        const double until = piece_ < pieces_.size() ? std::min(time_s, pieces_[piece_].start_s) : time_s;
        volume_ *= decay(until - now_);
        now_ = until;
        continue;
      }
      const Piece& p = pieces_[piece_];
      const double until = std::min(time_s, p.end_s);
      const double slope = (p.to - p.from) / (p.end_s - p.start_s);
      const double begin = p.from + slope * (now_ - p.start_s), end = p.from + slope * (until - p.start_s);
      // For A = a + s t the solution is a - s tau + s t, and what differs from it decays.
      volume_ = end - slope * tau_ + (volume_ - begin + slope * tau_) * decay(until - now_);
      now_ = until;
    }
    return volume_;
  }

 private:
  double decay(double step_s) const { return std::exp(-step_s / tau_); }

  double tau_;
  const std::vector<Piece>& pieces_;
  std::size_t piece_ = 0;
  double now_ = 0.0, volume_ = 0.0;
};

/// Returns the breath of a compartment that follows pieces, in order.
CompartmentBreath followed(const Compartment& c, const std::vector<Piece>& pieces, const TimeGrid& grid,
                           std::span<const double> time_s) {
  const bool periodic = grid.start == Start::periodic;
  Course course(c.time_constant_s, pieces);
  CompartmentBreath breath;
  breath.delta_v.reserve(time_s.size());
  for (const double t : time_s) breath.delta_v.push_back(course.at(std::min(t, grid.duration_s)));
  const double end = course.at(grid.duration_s);
  // The volume V0 that every breath begins with decays to V0 exp(-T/tau), and one breath from rest adds
  // `end`.
  const double start = periodic ? end / -std::expm1(-grid.duration_s / c.time_constant_s) : 0.0;
  for (std::size_t i = 0; i < time_s.size(); ++i)
    breath.delta_v[i] = c.gain_m3 * (breath.delta_v[i] + start * std::expm1(-time_s[i] / c.time_constant_s));
  breath.above_relaxation_m3 = c.gain_m3 * start;
  return breath;
}

}  // namespace

CompartmentBreath compartment_breath(const Compartment& compartment,
                                     const BreathActivation<double>& activation, const TimeGrid& grid,
                                     std::span<const double> time_s) {
  const bool periodic = grid.start == Start::periodic;
  return followed(compartment, pieces_of(activation, grid.duration_s, periodic), grid, time_s);
}

CompartmentBreath driven_breath(double time_constant_s, const std::vector<double>& held, const TimeGrid& grid,
                                std::span<const double> time_s) {
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i + 1 < time_s.size(); ++i)
    pieces.push_back({time_s[i], time_s[i + 1], held[i], held[i + 1]});
  return followed({time_constant_s, 1.0}, pieces, grid, time_s);
}

}  // namespace trunk
