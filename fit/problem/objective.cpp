#include "problem/objective.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <thread>

#include "errors/input_error.hpp"
#include "parallel/workers.hpp"

namespace trunk {
namespace {

/// Returns the grid of 1 ms on which a failed simulation is tried again; none if it did not fail, or if its
/// time step was not longer.
std::optional<TimeGrid> finer(const TimeGrid& grid, const Ending& ending) {
  constexpr double fine_s = 1e-3;
  if (ending.completed() || grid.dt_s <= fine_s) return std::nullopt;
  TimeGrid fine = grid;
  fine.dt_s = fine_s;
  return fine;
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

Objective::Objective(const Trunk& trunk, const TimeGrid& grid, const SearchSpace& space,
                     const MeasuredCurve& measured, Ledger& ledger, const Execution& execution)
    : trunk_(trunk), grid_(grid), space_(space), curve_(measured), ledger_(ledger), execution_(execution) {
  if (!measured.is_tidal_volume() &&
      (measured.time_s.empty() || measured.time_s.size() != measured.delta_v.size()))
    throw InputError({}, "the measured curve has no samples", "a volume at each time");
  if (!measured.time_s.empty() && measured.time_s.back() > grid.duration_s + grid.dt_s)
    throw InputError({},
                     fmt::format("the measured curve lasts {:.3f} s, the simulation {:.3f} s",
                                 measured.time_s.back(), grid.duration_s),
                     "a simulation as long as the curve");
  measured_ =
      Eigen::VectorXd::Map(measured.delta_v.data(), static_cast<Eigen::Index>(measured.delta_v.size()));
  deviation_ = sample_deviation(measured);
}

LeastSquares Objective::problem() {
  return {[this](const std::vector<Eigen::VectorXd>& some) { return outcomes(some); }, space_.lower(),
          space_.upper(), [this](const Eigen::VectorXd& x) { return slopes(x); }};
}

void Objective::use_loss(Loss loss, double scale) {
  loss_ = loss;
  loss_scale_ = scale;
}

std::vector<LedgerEntry> Objective::simulate(const std::vector<Candidate>& candidates) const {
  const auto start = std::chrono::steady_clock::now();
  std::vector<LedgerEntry> entries;
  for (VolumeCurve& curve : simulate_volumes(trunk_, candidates, grid_)) {
    const auto again = finer(grid_, curve.ending);
    if (again) curve = simulate_volumes(trunk_, {&candidates[entries.size()], 1}, *again).front();
    entries.push_back({static_cast<std::int32_t>(curve.ending.status), curve.ending.time_s, 0.0, {}});
    if (!curve.ending.completed()) continue;
    const Eigen::VectorXd model = as_measured(curve_, curve.delta_v, again.value_or(grid_).dt_s);
    entries.back().values.assign(model.data(), model.data() + model.size());
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  for (LedgerEntry& entry : entries) entry.wall_s = wall.count() / static_cast<double>(entries.size());
  return entries;
}

/// Returns the derivative of the model at the measured samples, one coordinate after the other.
LedgerEntry Objective::simulate_slopes(const Eigen::VectorXd& x, const Candidate& candidate) const {
  const auto start = std::chrono::steady_clock::now();
  TimeGrid grid = grid_;
  VolumeDerivatives found = simulate_volume_derivatives(trunk_, candidate, space_.directions(x), grid);
  if (const auto again = finer(grid, found.curve.ending)) {
    grid = *again;
    found = simulate_volume_derivatives(trunk_, candidate, space_.directions(x), grid);
  }
  const auto& [curve, along, above_relaxation] = found;
  LedgerEntry entry{static_cast<std::int32_t>(curve.ending.status), curve.ending.time_s, 0.0, {}};
  if (curve.ending.completed())
    for (const std::vector<double>& derivative : along) {
      const Eigen::VectorXd seen = as_measured(curve_, curve.delta_v, derivative, grid.dt_s);
      entry.values.insert(entry.values.end(), seen.data(), seen.data() + seen.size());
    }
  entry.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return entry;
}

/// The ledger may be damaged like any file, so every entry is checked before it is used.
bool Objective::usable(const LedgerEntry* entry, std::size_t count) const {
  if (entry == nullptr) return false;
  const auto completed = static_cast<std::int32_t>(Ending::Status::completed);
  if (entry->status != completed)
    return entry->values.empty() && entry->status > completed &&
           entry->status <= static_cast<std::int32_t>(Ending::Status::volume_lost) && finite(entry->lasted_s);
  return entry->values.size() == count &&
         std::all_of(entry->values.begin(), entry->values.end(), [](double v) { return finite(v); });
}

void Objective::simulate_missing(const std::vector<Candidate>& candidates,
                                 const std::vector<std::string>& keys) {
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (!usable(ledger_.find(keys[i]), static_cast<std::size_t>(samples())) &&
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
        simulated_ += results.second.size();
        if (execution_.progress) execution_.progress(simulated_);
      });
  if (cancelled()) throw Cancelled();
}

std::vector<const LedgerEntry*> Objective::entries(const std::vector<Candidate>& candidates) {
  std::vector<std::string> keys;
  for (const Candidate& c : candidates) keys.push_back(ledger_key(c));
  simulate_missing(candidates, keys);
  std::vector<const LedgerEntry*> found;
  for (const std::string& key : keys) found.push_back(ledger_.find(key));
  return found;
}

Outcome Objective::judged(const Eigen::VectorXd& x, const LedgerEntry& entry) const {
  if (entry.values.empty()) {
    const double energy = measured_.cwiseQuotient(deviation_).squaredNorm();
    const double lasted = std::clamp(entry.lasted_s / grid_.duration_s, 0.0, 1.0);
    return {std::nullopt, 100.0 * energy * (2.0 - lasted)};
  }
  const Eigen::VectorXd model = Eigen::VectorXd::Map(entry.values.data(), samples());
  const Eigen::VectorXd curve =
      robust_residuals((model - measured_).cwiseQuotient(deviation_), loss_, loss_scale_);
  const Eigen::VectorXd known = space_.prior_residuals(x);
  Eigen::VectorXd all(curve.size() + known.size());
  all << curve, known;
  return {all, all.squaredNorm()};
}

std::vector<Outcome> Objective::outcomes(const std::vector<Eigen::VectorXd>& some) {
  std::vector<Candidate> candidates;
  for (const Eigen::VectorXd& x : some) candidates.push_back(space_.decode(x));
  const std::vector<const LedgerEntry*> found = entries(candidates);
  std::vector<Outcome> result;
  for (std::size_t i = 0; i < some.size(); ++i) {
    result.push_back(judged(some[i], *found[i]));
    if (asked_.emplace(ledger_key(candidates[i]), true).second)
      evaluations_.push_back({candidates[i], result.back().objective,
                              static_cast<Ending::Status>(found[i]->status), found[i]->wall_s});
  }
  return result;
}

Slopes Objective::slopes(const Eigen::VectorXd& x) {
  const Outcome here = outcomes({x}).front();
  if (!here.residuals) return std::nullopt;
  const Candidate candidate = space_.decode(x);
  const std::string key = ledger_key(candidate) + "slopes";
  const Eigen::Index coordinates = x.size();
  if (!usable(ledger_.find(key), static_cast<std::size_t>(samples() * coordinates))) {
    ledger_.add(key, simulate_slopes(x, candidate));
    ++simulated_;
    if (execution_.progress) execution_.progress(simulated_);
  }
  const LedgerEntry& entry = *ledger_.find(key);
  if (!usable(&entry, static_cast<std::size_t>(samples() * coordinates))) return std::nullopt;

  const Eigen::VectorXd known = space_.prior_residuals(x);
  const Eigen::VectorXd deviations = (*model(x) - measured_).cwiseQuotient(deviation_);
  const Eigen::VectorXd weight = robust_slopes(deviations, loss_, loss_scale_).cwiseQuotient(deviation_);
  Eigen::MatrixXd all(samples() + known.size(), coordinates);
  all.topRows(samples()) =
      weight.asDiagonal() * Eigen::MatrixXd::Map(entry.values.data(), samples(), coordinates);
  for (Eigen::Index i = 0; i < coordinates; ++i)  // priors are linear, so a difference is exact
    all.col(i).tail(known.size()) = space_.prior_residuals(x + Eigen::VectorXd::Unit(coordinates, i)) - known;
  return all;
}

std::optional<Eigen::VectorXd> Objective::model(const Eigen::VectorXd& x) {
  return models({x}).front();
}

std::vector<std::optional<Eigen::VectorXd>> Objective::models(const std::vector<Eigen::VectorXd>& some) {
  outcomes(some);  // enters the simulations in evaluations_
  std::vector<Candidate> candidates;
  for (const Eigen::VectorXd& x : some) candidates.push_back(space_.decode(x));
  std::vector<std::optional<Eigen::VectorXd>> result;
  for (const LedgerEntry* entry : entries(candidates))
    if (entry->values.empty())
      result.emplace_back();
    else
      result.emplace_back(Eigen::VectorXd::Map(entry->values.data(), samples()));
  return result;
}

int Objective::failures() const noexcept {
  return static_cast<int>(std::count_if(evaluations_.begin(), evaluations_.end(), [](const Evaluation& e) {
    return e.status != Ending::Status::completed;
  }));
}

}  // namespace trunk
