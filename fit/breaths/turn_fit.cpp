#include "breaths/turn_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace trunk {
namespace {

constexpr std::size_t most_samples = 400;

using Samples = std::span<const double>;

// Returns means over groups of neighbours: the cost grows with the square of the number of samples.
std::vector<double> thinned(Samples samples) {
  const std::size_t group = (samples.size() - 1) / most_samples + 1;
  std::vector<double> means;
  for (std::size_t i = 0; i < samples.size(); i += group) {
    const std::size_t count = std::min(group, samples.size() - i);
    means.push_back(std::accumulate(&samples[i], &samples[i] + count, 0.0) / static_cast<double>(count));
  }
  return means;
}

// Sums of one side's column of the least-squares problem: of its values, or of its steps.
struct Side {
  double column = 0, squares = 0, product = 0;  // sums of c, c^2, c v
};

// Samples around a turn, less their mean, which avoids cancellation.
struct Centred {
  std::vector<double> time, level;
  double mean = 0, count = 0, squares = 0;
  NoiseKind noise;

  Centred(Samples all_times, Samples volume, NoiseKind of)
      : time(thinned(all_times)), level(thinned(volume)), noise(of) {
    count = static_cast<double>(time.size());
    mean = std::accumulate(level.begin(), level.end(), 0.0) / count;
    for (double& v : level) v -= mean;
    for (std::size_t i = 0; i < level.size(); ++i) {
      const double v = noise == NoiseKind::white ? level[i] : i > 0 ? level[i] - level[i - 1] : 0;
      squares += v * v;
    }
  }

  // Adds the column's value at sample i, and its value at the neighbour that comes next. => side
  void add(Side& side, std::size_t i, double c, std::size_t next, double c_next) const {
    side.column += c;
    const double step = noise == NoiseKind::white ? c : c - c_next;
    const double v = noise == NoiseKind::white ? level[i] : level[i] - level[next];
    side.squares += step * step;
    side.product += step * v;
  }
};

Side side_before(const Centred& s, double t0, double lag) {
  Side side;
  const std::size_t n = s.time.size();
  double c = n > 0 && s.time[0] < t0 ? volume_from_turn(t0 - s.time[0], lag) : 0;
  for (std::size_t i = 0; i < n && s.time[i] < t0; ++i) {
    const std::size_t next = std::min(i + 1, n - 1);
    const double c_next = s.time[next] < t0 ? volume_from_turn(t0 - s.time[next], lag) : 0;
    s.add(side, i, c, next, c_next);
    c = c_next;
  }
  return side;
}

Side side_after(const Centred& s, double t0, double lag) {
  Side side;
  const std::size_t n = s.time.size();
  double c = s.time[n - 1] > t0 ? volume_from_turn(s.time[n - 1] - t0, lag) : 0;
  for (std::size_t i = n; i-- > 0 && s.time[i] > t0;) {
    const std::size_t next = i > 0 ? i - 1 : 0;
    const double c_next = s.time[next] > t0 ? volume_from_turn(s.time[next] - t0, lag) : 0;
    s.add(side, i, c, next, c_next);
    c = c_next;
  }
  return side;
}

struct Solution {
  double level = 0, misfit = HUGE_VAL;
  double slope_before = 0, slope_after = 0;
};

// At each time at most one of the two columns is above zero, so the normal equations have a closed solution.
// Steps do not show the level.
Solution solved(const Centred& s, const Side& before, const Side& after) {
  const bool white = s.noise == NoiseKind::white;
  double weight = s.count, product = 0;
  for (const Side* side : {&before, &after}) {
    if (side->squares <= 0) continue;
    if (white) weight -= side->column * side->column / side->squares;
    product -= side->column * side->product / side->squares;
  }
  if (weight <= 1e-9 * s.count) return {};
  const double level = product / weight;
  double residual = s.squares, slopes[2] = {0, 0};
  for (const bool second : {false, true}) {
    const Side& side = second ? after : before;
    if (side.squares <= 0) continue;
    const double of_level = white ? level * side.column : 0;
    slopes[second] = (side.product - of_level) / side.squares;
    if (slopes[second] < 0) return {};
    residual -= slopes[second] * side.product;
  }
  return {level, std::max(residual, 0.0) / s.count, slopes[0], slopes[1]};
}

struct Ends {
  double begin, end;
};

// Tries all pairs of sample times.
Ends best_pair(const Centred& s, const std::vector<Side>& before, const std::vector<Side>& after,
               TurnSides sides) {
  const std::size_t n = s.time.size(), last_begin = sides.before ? n - 1 : 0;
  Ends best{s.time.front(), s.time.back()};
  double least = HUGE_VAL;
  for (std::size_t i = 0; i <= last_begin; ++i)
    for (std::size_t k = sides.after ? i : n - 1; k < n; ++k)
      if (const double misfit = solved(s, before[i], after[k]).misfit; misfit < least)
        least = misfit, best = {s.time[i], s.time[k]};
  return best;
}

// Returns the mean of the samples near a turn, less its sides: far from it a walk has strayed.
double level_near(const Centred& c, const Ends& e, TurnShape shape, const Solution& s) {
  constexpr double near = 0.1;  // of the window
  const double reach = near * (c.time.back() - c.time.front());
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < c.time.size(); ++i) {
    const double t = c.time[i];
    if (t < e.begin - reach || t > e.end + reach) continue;
    sum += c.level[i], ++count;
    if (t < e.begin) sum -= s.slope_before * volume_from_turn(e.begin - t, shape.before_s);
    if (t > e.end) sum -= s.slope_after * volume_from_turn(t - e.end, shape.after_s);
  }
  return count > 0 ? sum / count : s.level;
}

// Returns the best turn near begin and end, by steps that halve each round.
Turn nearest(const Centred& c, Ends best, TurnShape shape, TurnSides sides, double step) {
  const auto at = [&](const Ends& e) {
    return solved(c, side_before(c, e.begin, shape.before_s), side_after(c, e.end, shape.after_s));
  };
  Solution found = at(best);
  for (int round = 0; round < 6; ++round, step /= 2)
    for (const auto& [begin, end] :
         {Ends{-1, 0}, Ends{1, 0}, Ends{0, -1}, Ends{0, 1}, Ends{-1, -1}, Ends{1, 1}}) {
      const Ends next{best.begin + (sides.before ? begin * step : 0),
                      best.end + (sides.after ? end * step : 0)};
      if (next.begin > next.end || next.begin < c.time.front() || next.end > c.time.back()) continue;
      if (const Solution tried = at(next); tried.misfit < found.misfit) found = tried, best = next;
    }
  const double level = c.noise == NoiseKind::white ? found.level : level_near(c, best, shape, found);
  return {best.begin, best.end, c.mean + level, found.misfit};
}

}  // namespace

double volume_from_turn(double s, double lag_s) {
  if (lag_s == 0) return s;
  return s < 1e-3 * lag_s ? s * s : 2 * lag_s * (s + lag_s * std::expm1(-s / lag_s));  // s^2 to third order
}

Turn fit_turn(Samples time, Samples volume, TurnShape shape, TurnSides sides, NoiseKind noise) {
  const Centred c(time, volume, noise);
  std::vector<Side> before, after;
  for (const double t0 : c.time) {
    before.push_back(side_before(c, t0, shape.before_s));
    after.push_back(side_after(c, t0, shape.after_s));
  }
  const std::size_t n = c.time.size();
  const double step = n > 1 ? 0.5 * (c.time.back() - c.time.front()) / static_cast<double>(n - 1) : 0;
  return nearest(c, best_pair(c, before, after, sides), shape, sides, step);
}

}  // namespace trunk
