#include "breaths/turn_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace trunk {
namespace {

constexpr std::size_t most_samples = 400;

using Samples = std::span<const double>;

// Sums of one side's column of the least-squares problem.
struct Side {
  double column = 0, squares = 0, product = 0;  // sums of c, c^2, c v

  void add(double c, double v) {
    column += c;
    squares += c * c;
    product += c * v;
  }
};

Side side_before(Samples time, Samples volume, double t0, double lag) {
  Side side;
  for (std::size_t i = 0; i < time.size() && time[i] < t0; ++i)
    side.add(volume_from_turn(t0 - time[i], lag), volume[i]);
  return side;
}

Side side_after(Samples time, Samples volume, double t0, double lag) {
  Side side;
  for (std::size_t i = time.size(); i-- > 0 && time[i] > t0;)
    side.add(volume_from_turn(time[i] - t0, lag), volume[i]);
  return side;
}

// Sums of the volume alone, less its mean, which avoids cancellation.
struct Whole {
  double count = 0, squares = 0;
};

struct Solution {
  double level = 0, misfit = HUGE_VAL;
};

// At each time at most one of the two columns is above zero, so the normal equations have a closed solution.
Solution solved(const Whole& whole, const Side& before, const Side& after) {
  double weight = whole.count, product = 0;
  for (const Side* side : {&before, &after}) {
    if (side->squares <= 0) continue;
    weight -= side->column * side->column / side->squares;
    product -= side->column * side->product / side->squares;
  }
  if (weight <= 1e-9 * whole.count) return {};
  const double level = product / weight;
  double residual = whole.squares;
  for (const Side* side : {&before, &after}) {
    if (side->squares <= 0) continue;
    const double slope = (side->product - level * side->column) / side->squares;
    if (slope < 0) return {};
    residual -= slope * side->product;
  }
  return {level, std::max(residual, 0.0) / whole.count};
}

struct Ends {
  double begin, end;
};

// Tries all pairs of sample times.
Ends best_pair(Samples time, const Whole& whole, const std::vector<Side>& before,
               const std::vector<Side>& after, TurnSides sides) {
  const std::size_t n = time.size(), last_begin = sides.before ? n - 1 : 0;
  Ends best{time.front(), time.back()};
  double least = HUGE_VAL;
  for (std::size_t i = 0; i <= last_begin; ++i)
    for (std::size_t k = sides.after ? i : n - 1; k < n; ++k)
      if (const double misfit = solved(whole, before[i], after[k]).misfit; misfit < least)
        least = misfit, best = {time[i], time[k]};
  return best;
}

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

}  // namespace

double volume_from_turn(double s, double lag_s) {
  if (lag_s == 0) return s;
  return s < 1e-3 * lag_s ? s * s : 2 * lag_s * (s + lag_s * std::expm1(-s / lag_s));  // s^2 to third order
}

Turn fit_turn(Samples all_times, Samples volume, TurnShape shape, TurnSides sides) {
  const std::vector<double> time = thinned(all_times);
  std::vector<double> level = thinned(volume);
  const std::size_t n = time.size();
  const double mean = std::accumulate(level.begin(), level.end(), 0.0) / static_cast<double>(n);
  Whole whole{static_cast<double>(n), 0};
  for (double& v : level) v -= mean, whole.squares += v * v;

  std::vector<Side> before, after;
  for (const double t0 : time) {
    before.push_back(side_before(time, level, t0, shape.before_s));
    after.push_back(side_after(time, level, t0, shape.after_s));
  }
  Ends best = best_pair(time, whole, before, after, sides);
  const auto at = [&](const Ends& e) {
    return solved(whole, side_before(time, level, e.begin, shape.before_s),
                  side_after(time, level, e.end, shape.after_s));
  };

  // Refines between sample times by steps that halve each round.
  Solution found = at(best);
  double step = n > 1 ? 0.5 * (time.back() - time.front()) / static_cast<double>(n - 1) : 0;
  for (int round = 0; round < 6; ++round, step /= 2)
    for (const auto& [begin, end] :
         {Ends{-1, 0}, Ends{1, 0}, Ends{0, -1}, Ends{0, 1}, Ends{-1, -1}, Ends{1, 1}}) {
      const Ends next{best.begin + (sides.before ? begin * step : 0),
                      best.end + (sides.after ? end * step : 0)};
      if (next.begin > next.end || next.begin < time.front() || next.end > time.back()) continue;
      if (const Solution tried = at(next); tried.misfit < found.misfit) found = tried, best = next;
    }
  return {best.begin, best.end, mean + found.level, found.misfit};
}

}  // namespace trunk
