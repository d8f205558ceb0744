#include "breaths/heartbeat.hpp"

#include <algorithm>
#include <cmath>

#include "breaths/robust.hpp"

namespace trunk {
namespace {

constexpr double shortest_beat_s = 0.4, longest_beat_s = 1.5, beat_step_s = 0.02;
constexpr double least_autocorrelation = 0.3, as_good = 0.9;

using Curve = std::vector<double>;

// Returns the signal less the mean breath, evenly spaced over the breaths that count; one piece for each.
std::vector<Curve> remainders(const Segmentation& s, const Curve& signal, const MeasuredChannel& channel,
                              const MeasuredBreath& mean) {
  std::vector<Curve> pieces;
  for (const std::size_t b : channel.breaths) {
    const Breath& breath = mean.used[b];
    Curve times, piece;
    for (const double t : mean.time_s) times.push_back(time_in(breath, mean, t));
    const auto samples = static_cast<std::size_t>(breath.duration_s() / beat_step_s);
    for (std::size_t i = 0; i <= samples; ++i) {
      const double t = breath.onset_s + static_cast<double>(i) * beat_step_s;
      piece.push_back(interpolated(s.time_s, signal, t) - interpolated(times, channel.value, t));
    }
    const Curve slow = moving_average(piece, static_cast<std::size_t>(longest_beat_s / beat_step_s) | 1);
    for (std::size_t i = 0; i < piece.size(); ++i) piece[i] -= slow[i];
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

double autocorrelation(const std::vector<Curve>& pieces, std::size_t lag) {
  double product = 0, first = 0, second = 0;
  for (const Curve& piece : pieces)
    for (std::size_t i = lag; i < piece.size(); ++i) {
      product += piece[i] * piece[i - lag];
      first += piece[i] * piece[i], second += piece[i - lag] * piece[i - lag];
    }
  const double size = std::sqrt(first * second);
  return size > 0 ? product / size : 0;
}

}  // namespace

std::optional<Heartbeat> heartbeat(const Segmentation& s, const Curve& signal, const MeasuredChannel& channel,
                                   const MeasuredBreath& mean) {
  if (channel.each.size() < 2) return std::nullopt;
  const auto pieces = remainders(s, signal, channel, mean);
  const auto first = static_cast<std::size_t>(shortest_beat_s / beat_step_s),
             last = static_cast<std::size_t>(longest_beat_s / beat_step_s);
  Curve found;  // at the lags from first - 1 to last + 1
  for (std::size_t lag = first - 1; lag <= last + 1; ++lag) found.push_back(autocorrelation(pieces, lag));
  const double best = *std::max_element(found.begin() + 1, found.end() - 1);
  if (best < least_autocorrelation) return std::nullopt;
  std::size_t lag = 0;  // the first one that is as good: multiples of a period repeat too
  for (std::size_t k = 1; lag == 0 && k + 1 < found.size(); ++k)
    if (found[k] >= as_good * best && found[k] >= found[k - 1] && found[k] >= found[k + 1])
      lag = first - 1 + k;
  if (lag == 0 || autocorrelation(pieces, 2 * lag) < 0.5 * least_autocorrelation) return std::nullopt;
  double squares = 0, count = 0;
  for (const Curve& piece : pieces)
    for (const double v : piece) squares += v * v, ++count;
  return Heartbeat{beat_step_s * static_cast<double>(lag), std::sqrt(best * squares / count)};
}

}  // namespace trunk
