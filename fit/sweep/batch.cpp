#include "sweep/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "anatomy/breath_run.hpp"
#include "errors/input_error.hpp"
#include "math/units.hpp"
#include "records/run_record.hpp"
#include "scenarios/build_trunk.hpp"

namespace trunk {
namespace {

struct TimedOut {};

double now_s() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// Returns the first sample at or after each multiple of curve_step_s. No interpolation: a sweep that resumes
/// from files has the same bits.
template <class TimeOf>
std::vector<double> thinned(const std::vector<double>& values, double factor, const TimeOf& time_of) {
  std::vector<double> curve;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (time_of(i) >= static_cast<double>(curve.size()) * curve_step_s - 1e-9)
      curve.push_back(factor * values[i]);
  return curve;
}

std::vector<double> numbers_of(const std::vector<NamedValue>& values) {
  std::vector<double> numbers;
  for (const NamedValue& v : values) numbers.push_back(v.value);
  return numbers;
}

/// Returns those of a file's measures that a row has, in its order: a file may hold more.
std::vector<double> measures_of_row(const std::vector<NamedValue>& stored) {
  const auto find = [&](const std::string& name) {
    return std::find_if(stored.begin(), stored.end(), [&](const NamedValue& v) { return v.name == name; });
  };
  BreathSummary breath;
  if (find("pleural_swing_cmH2O") != stored.end()) breath.swings.emplace();
  std::vector<double> numbers;
  for (const NamedValue& m : measures_of(breath))
    numbers.push_back(find(m.name) == stored.end() ? m.value : find(m.name)->value);
  return numbers;
}

/// Returns the intervals of a run's measures. `draws` are the breaths of the subject's draws.
std::vector<NamedValue> intervals_of(const BreathSummary& breath, std::span<const BreathSummary> draws) {
  if (draws.empty()) return {};
  std::vector<std::vector<NamedValue>> rows = {measures_of(breath)};
  for (const BreathSummary& draw : draws) rows.push_back(measures_of(draw));
  const auto failed =
      std::count_if(draws.begin(), draws.end(), [](const auto& draw) { return !draw.ending.completed(); });
  return trunk::intervals_of(predicted_measures(rows), static_cast<int>(failed));
}

SweepRow row_of(std::size_t run, const BreathSummary& breath, double dt_s, bool with_curve) {
  SweepRow row{run,   status_word(breath.ending.status), "", now_s(),
               false, numbers_of(measures_of(breath)),   {}};
  if (!breath.ending.completed()) row.error = breath.ending.message;
  if (with_curve)
    row.curve =
        thinned(breath.delta_v, ml_per_m3, [&](std::size_t i) { return static_cast<double>(i) * dt_s; });
  return row;
}

Trial<double> trial_of(const PreparedRun& p) {
  return {p.file.scenario.parameters, p.file.scenario.activation};
}

/// Simulates a batch and collects its outcomes.
class Running {
 public:
  explicit Running(const SweepBatch& batch) : batch_(batch) {}

  /// Adds a failed row for each run that is unstable or cannot repeat, and simulates the others.
  std::vector<FinishedRun> simulate(std::vector<PreparedRun> runs) {
    const bool stable = surely_stable(runs);
    std::erase_if(runs, [&](const PreparedRun& p) { return is_refused(p, stable); });
    while (!runs.empty()) {  // each pass takes the runs of one time grid
      const TimeGrid grid = runs.front().file.scenario.time;
      const auto others = std::stable_partition(
          runs.begin(), runs.end(), [&](const PreparedRun& p) { return p.file.scenario.time == grid; });
      const auto count = static_cast<std::size_t>(others - runs.begin());
      if (batch_.design.store == SweepDesign::Store::full)
        for (const PreparedRun& p : std::span(runs).first(count)) simulate_in_full(p);
      else
        summarise(std::span(runs).first(count), grid);
      runs.erase(runs.begin(), others);
    }
    return std::move(done_);
  }

 private:
  bool surely_stable(const std::vector<PreparedRun>& runs) const {
    std::vector<const Scenario*> scenarios;
    for (const PreparedRun& p : runs) scenarios.push_back(&p.file.scenario);
    return batch_.stable.holds(batch_.trunk, scenarios);
  }

  bool is_refused(const PreparedRun& p, bool stable) {
    try {
      stable ? require_memory(p.file, batch_.trunk) : require_stable(p.file, batch_.trunk);
      return false;
    } catch (const InputError& error) {
      done_.push_back({invalid_row(batch_.design, p.run, error), std::nullopt});
      return true;
    }
  }

  /// Runs side by side may take as long as the same runs one after the other.
  WhileSimulated watchdog(std::size_t runs) const {
    const double limit_s = batch_.limits.timeout_s * static_cast<double>(runs);
    return [this, limit_s, start_s = batch_.limits.clock_s()] {
      const double spent_s = batch_.limits.clock_s() - start_s;
      if (limit_s > 0.0 && spent_s > limit_s) throw TimedOut();
      if (spent_s > 1.0 && batch_.limits.cancelled && batch_.limits.cancelled()) throw Cancelled();
    };
  }

  void time_out(const PreparedRun& p) {
    done_.push_back(
        {failed_row(p.run, "timeout", fmt::format("took longer than {} s", batch_.limits.timeout_s)), {}});
  }

  void summarise(std::span<const PreparedRun> runs, const TimeGrid& grid) {
    std::vector<Trial<double>> trials;
    for (const PreparedRun& p : runs) {
      trials.push_back(trial_of(p));
      trials.insert(trials.end(), p.draws.begin(), p.draws.end());
    }
    try {
      const std::vector<BreathSummary> breaths =
          summarise_breaths(batch_.trunk, trials, grid, watchdog(runs.size()));
      const bool with_curve = batch_.design.store != SweepDesign::Store::summary;
      auto breath = breaths.begin();
      for (const PreparedRun& p : runs) {
        done_.push_back({row_of(p.run, *breath, grid.dt_s, with_curve), std::nullopt});
        done_.back().row.intervals = numbers_of(intervals_of(*breath, {breath + 1, p.draws.size()}));
        breath += 1 + static_cast<std::ptrdiff_t>(p.draws.size());
      }
    } catch (const TimedOut&) {
      if (runs.size() == 1)
        time_out(runs.front());  // of several, only one may be slow: the caller tries each
    }
  }

  void simulate_in_full(const PreparedRun& p) {
    const Scenario& scenario = p.file.scenario;
    const auto stride = std::lround(s_per_ms * batch_.design.frame_every_ms / scenario.time.dt_s);
    const WhileSimulated check = watchdog(1);
    try {
      const BreathRun run = run_breath(batch_.trunk, scenario, std::max(1, static_cast<int>(stride)), check);
      const std::vector<NamedValue> intervals =
          intervals_of(run, summarise_breaths(batch_.trunk, p.draws, scenario.time, check));
      done_.push_back({row_of(p.run, run, scenario.time.dt_s, true),
                       run_record(p.file, batch_.trunk, run, {}, batch_.provenance)});
      done_.back().row.has_file = true;
      done_.back().row.intervals = numbers_of(intervals);
      done_.back().record->intervals = intervals;
    } catch (const TimedOut&) {
      time_out(p);
    }
  }

  const SweepBatch& batch_;
  std::vector<FinishedRun> done_;
};

}  // namespace

double steady_clock_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

SweepRow row_of(std::size_t run, const StoredRun& s) {
  return {run,
          s.status,
          s.status == "completed" ? "" : s.message,
          now_s(),
          true,
          measures_of_row(s.measures),
          thinned(s.curve_dV_ml, 1.0, [&](std::size_t i) { return s.curve_time_s[i]; }),
          numbers_of(s.intervals)};
}

SweepRow failed_row(std::size_t run, const std::string& status, const std::string& error) {
  return {run, status, error, now_s(), false, {}, {}};
}

SweepRow invalid_row(const SweepDesign& design, std::size_t run, const std::exception& error) {
  const auto* input = dynamic_cast<const InputError*>(&error);
  if (input == nullptr) return failed_row(run, "invalid", error.what());
  std::vector<Mistake> mistakes = input->mistakes();
  for (Mistake& mistake : mistakes) {
    mistake.at = design.seen_from_design(mistake.at);
    mistake.named_in = design.seen_from_design(mistake.named_in);
  }
  return failed_row(run, "invalid", InputErrors(std::move(mistakes)).what());
}

std::vector<FinishedRun> SweepBatch::simulate(std::vector<PreparedRun> runs) const {
  return Running(*this).simulate(std::move(runs));
}

}  // namespace trunk
