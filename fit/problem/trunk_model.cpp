#include "problem/trunk_model.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <thread>

#include "parallel/workers.hpp"
#include "search/least_squares.hpp"

namespace trunk {
namespace {

/// Returns the grid of 1 ms on which a failed simulation is tried again; none if it did not fail, or if its
/// time step was not longer.
std::optional<TimeGrid> finer(const TimeGrid& grid, const Ending& ending) {
  constexpr double fine_s = 1e-3;
  if (ending.completed() || grid.dt_s <= fine_s) return std::nullopt;
  TimeGrid again = grid;
  again.dt_s = fine_s;
  return again;
}

}  // namespace

std::string ledger_key(const Candidate& c) {
  Candidate copy = c;
  std::string bytes;
  for (const double* number : numbers(copy)) {
    char eight[sizeof(double)];
    std::memcpy(eight, number, sizeof eight);
    bytes.append(eight, sizeof eight);
  }
  return bytes;
}

TrunkModel::TrunkModel(const Trunk& trunk, const TimeGrid& grid, const MeasuredCurve& measured,
                       Ledger& ledger, const Execution& execution)
    : trunk_(trunk),
      grid_(grid),
      curve_(measured),
      values_(static_cast<std::size_t>(values_of(measured).size())),
      ledger_(ledger),
      execution_(execution) {}

/// Returns what is measured of a candidate's curves.
Eigen::VectorXd TrunkModel::observed(const Candidate& candidate, const BreathCurves& curves,
                                     double dt_s) const {
  if (curve_.is_tidal_volume()) return as_measured(curve_, curves.delta_v, dt_s);
  SeenBreath breath = seen(curve_, curves, dt_s);
  breath.activation = activation_at(curve_, candidate.activation, grid_);
  return as_measured(curve_, breath, breath);
}

/// Returns the derivative of what is measured along a direction, along which the curves have derivatives.
Eigen::VectorXd TrunkModel::observed(const Candidate& candidate, const BreathCurves& curves,
                                     const Candidate& direction, const BreathCurves& derivatives,
                                     double dt_s) const {
  if (curve_.is_tidal_volume()) return as_measured(curve_, curves.delta_v, derivatives.delta_v, dt_s);
  constexpr double step = 1e-6;  // the activation is straight between its corners
  const auto aside = [&](double by) {
    Candidate moved = candidate, along = direction;
    for (std::size_t n = 0; n < numbers(moved).size(); ++n) *numbers(moved)[n] += by * *numbers(along)[n];
    return activation_at(curve_, moved.activation, grid_);
  };
  SeenBreath change = seen(curve_, derivatives, dt_s);
  change.activation = (aside(step) - aside(-step)) / (2.0 * step);
  return as_measured(curve_, seen(curve_, curves, dt_s), change);
}

std::vector<LedgerEntry> TrunkModel::simulate(const std::vector<Candidate>& candidates) const {
  const auto start = std::chrono::steady_clock::now();
  std::vector<LedgerEntry> entries;
  for (VolumeCurve& curve : simulate_volumes(trunk_, candidates, grid_)) {
    const auto again = finer(grid_, curve.ending);
    if (again) curve = simulate_volumes(trunk_, {&candidates[entries.size()], 1}, *again).front();
    entries.push_back({static_cast<std::int32_t>(curve.ending.status), curve.ending.time_s, 0.0, {}});
    if (!curve.ending.completed()) continue;
    const Eigen::VectorXd model = observed(candidates[entries.size() - 1], curve, again.value_or(grid_).dt_s);
    entries.back().values.assign(model.data(), model.data() + model.size());
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  for (LedgerEntry& entry : entries) entry.wall_s = wall.count() / static_cast<double>(entries.size());
  return entries;
}

LedgerEntry TrunkModel::simulate_slopes(const Candidate& candidate,
                                        const std::vector<Candidate>& directions) const {
  const auto start = std::chrono::steady_clock::now();
  TimeGrid grid = grid_;
  VolumeDerivatives found = simulate_volume_derivatives(trunk_, candidate, directions, grid);
  if (const auto again = finer(grid, found.curve.ending)) {
    grid = *again;
    found = simulate_volume_derivatives(trunk_, candidate, directions, grid);
  }
  const VolumeCurve& curve = found.curve;
  LedgerEntry entry{static_cast<std::int32_t>(curve.ending.status), curve.ending.time_s, 0.0, {}};
  if (curve.ending.completed())
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Eigen::VectorXd along = observed(candidate, curve, directions[i], found.along[i], grid.dt_s);
      entry.values.insert(entry.values.end(), along.data(), along.data() + along.size());
    }
  entry.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return entry;
}

/// The ledger may be damaged like any file, so every entry is checked before it is used.
bool TrunkModel::usable(const LedgerEntry* entry, std::size_t count) const {
  if (entry == nullptr) return false;
  const auto completed = static_cast<std::int32_t>(Ending::Status::completed);
  if (entry->status != completed)
    return entry->values.empty() && entry->status > completed &&
           entry->status <= static_cast<std::int32_t>(Ending::Status::volume_lost) && finite(entry->lasted_s);
  return entry->values.size() == count &&
         std::all_of(entry->values.begin(), entry->values.end(), [](double v) { return finite(v); });
}

void TrunkModel::simulate_missing(const std::vector<Candidate>& candidates,
                                  const std::vector<std::string>& keys) {
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (!usable(ledger_.find(keys[i]), values_) &&
        std::find(keys.begin(), keys.begin() + static_cast<std::ptrdiff_t>(i), keys[i]) ==
            keys.begin() + static_cast<std::ptrdiff_t>(i))
      missing.push_back(i);
  const auto cancelled = [&] { return execution_.cancelled && execution_.cancelled(); };
  if (cancelled()) throw Cancelled();
  // One simulation per lane, but fewer at once if a thread would otherwise have nothing to do.
  const std::size_t threads =
      execution_.threads > 0 ? execution_.threads : std::max(1u, std::thread::hardware_concurrency());
  const std::size_t share = (missing.size() + threads - 1) / threads;
  const std::size_t width = std::clamp<std::size_t>(share, 1, batch_lanes());
  std::vector<std::size_t> firsts;
  for (std::size_t i = 0; i < missing.size(); i += width) firsts.push_back(i);
  using Results = std::pair<std::size_t, std::vector<LedgerEntry>>;
  work_off<Results>(
      firsts, static_cast<unsigned>(std::min(threads, firsts.size())), cancelled,
      [&](std::size_t first) {
        std::vector<Candidate> together;
        for (std::size_t i = first; i < std::min(first + width, missing.size()); ++i)
          together.push_back(candidates[missing[i]]);
        return Results(first, simulate(together));
      },
      [&](Results results) {
        for (std::size_t i = 0; i < results.second.size(); ++i)
          ledger_.add(keys[missing[results.first + i]], std::move(results.second[i]));
        count(results.second.size());
      });
  if (cancelled()) throw Cancelled();
}

void TrunkModel::count(std::size_t simulations) {
  simulated_ += simulations;
  if (execution_.progress) execution_.progress(simulated_);
}

std::vector<LedgerEntry> TrunkModel::at(const std::vector<Candidate>& candidates) {
  std::vector<std::string> keys;
  for (const Candidate& c : candidates) keys.push_back(ledger_key(c));
  simulate_missing(candidates, keys);
  std::vector<LedgerEntry> found;
  for (const std::string& key : keys) found.push_back(*ledger_.find(key));
  return found;
}

std::optional<LedgerEntry> TrunkModel::slopes(const Candidate& candidate,
                                              const std::vector<Candidate>& directions) {
  std::string key = ledger_key(candidate) + "slopes";
  for (const Candidate& d : directions) key += ledger_key(d);
  if (!usable(ledger_.find(key), values_ * directions.size())) {
    ledger_.add(key, simulate_slopes(candidate, directions));
    count(1);
  }
  return *ledger_.find(key);
}

}  // namespace trunk
