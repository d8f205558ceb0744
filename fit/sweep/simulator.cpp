#include "sweep/simulator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "dynamics/stability.hpp"
#include "errors/input_error.hpp"
#include "recording/run_record.hpp"

namespace trunk {
namespace {

struct TimedOut {};

double now_s() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// The curve every curve_step_s: the nearest later sample, so that resuming from files loses no bit.
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

SweepRow row_of(std::size_t run, const BreathSummary& breath, double dt_s, bool with_curve) {
  SweepRow row{run,   status_word(breath.summary.status), "", now_s(),
               false, numbers_of(measures_of(breath)),    {}};
  if (!breath.summary.completed()) row.error = breath.summary.message;
  if (with_curve)
    row.curve = thinned(breath.delta_v, 1e6, [&](std::size_t i) { return static_cast<double>(i) * dt_s; });
  return row;
}

SweepRow failed(std::size_t run, const std::string& status, const std::string& error) {
  return {run, status, error, now_s(), false, {}, {}};
}

/// A run, ready to be simulated.
struct Prepared {
  std::size_t run;
  ScenarioFile file;
};

Trial<double> trial_of(const Prepared& p) {
  return {p.file.scenario.parameters, p.file.scenario.activation};
}

/// At least as stiff and as little damped as any of the runs: where the reaction is the gradient of an
/// energy, its highest frequency is not below theirs.
Parameters<double> stiffest(const std::vector<Prepared>& runs) {
  Parameters<double> all = runs.front().file.scenario.parameters;
  for (const Prepared& p : runs) {
    const Parameters<double>& one = p.file.scenario.parameters;
    all.elasticity = std::max(all.elasticity, one.elasticity);
    all.muscle = std::max(all.muscle, one.muscle);
    all.damping = std::min(all.damping, one.damping);
    all.abdomen_factor = std::max(all.abdomen_factor, one.abdomen_factor);
  }
  return all;
}

/// One call of the simulator.
class Batch {
 public:
  using Limits = SweepSimulator::Limits;
  Batch(const SweepDesign& design, const Provenance& provenance, const Limits& limits, const Trunk& trunk)
      : design_(design), provenance_(provenance), limits_(limits), trunk_(trunk) {}

  /// Fails what is unstable, simulates the others.
  std::vector<FinishedRun> simulate(std::vector<Prepared> runs) {
    if (!surely_stable(runs)) std::erase_if(runs, [&](const Prepared& p) { return fails_as_unstable(p); });
    while (!runs.empty()) {  // those of one time grid at once
      const TimeGrid grid = runs.front().file.scenario.time;
      const auto others = std::stable_partition(runs.begin(), runs.end(), [&](const Prepared& p) {
        const TimeGrid& own = p.file.scenario.time;
        return own.dt_s == grid.dt_s && own.duration_s == grid.duration_s;
      });
      const auto count = static_cast<std::size_t>(others - runs.begin());
      if (design_.store == SweepDesign::Store::full)
        for (const Prepared& p : std::span(runs).first(count)) simulate_in_full(p);
      else
        summarise(std::span(runs).first(count), grid);
      runs.erase(runs.begin(), others);
    }
    return std::move(done_);
  }

 private:
  bool surely_stable(const std::vector<Prepared>& runs) const {
    constexpr double margin = 1.25;  // for what power iteration leaves open
    if (runs.empty() || runs.front().file.scenario.reaction != Reaction::variational) return false;
    Scenario worst = runs.front().file.scenario;
    worst.parameters = stiffest(runs);
    for (const Prepared& p : runs)
      worst.time.dt_s = std::max(worst.time.dt_s, margin * p.file.scenario.time.dt_s);
    try {
      require_stable(worst, trunk_);
      return true;
    } catch (const InputError&) {
      return false;
    }
  }

  bool fails_as_unstable(const Prepared& p) {
    try {
      require_stable(p.file, trunk_);
      return false;
    } catch (const InputError& error) {
      done_.push_back({failed(p.run, "invalid", error.what()), std::nullopt});
      return true;
    }
  }

  WhileSimulated watchdog() const {
    using Clock = std::chrono::steady_clock;
    return [this, start = Clock::now()] {
      const double spent_s = std::chrono::duration<double>(Clock::now() - start).count();
      if (limits_.timeout_s > 0.0 && spent_s > limits_.timeout_s) throw TimedOut();
      if (spent_s > 1.0 && limits_.cancelled && limits_.cancelled()) throw Cancelled();
    };
  }

  void time_out(const Prepared& p) {
    done_.push_back({failed(p.run, "timeout", fmt::format("took longer than {} s", limits_.timeout_s)), {}});
  }

  void summarise(std::span<const Prepared> runs, const TimeGrid& grid) {
    std::vector<Trial<double>> trials;
    for (const Prepared& p : runs) trials.push_back(trial_of(p));
    try {
      const std::vector<BreathSummary> breaths = summarise_breaths(trunk_, trials, grid, watchdog());
      for (std::size_t i = 0; i < runs.size(); ++i)
        done_.push_back(
            {row_of(runs[i].run, breaths[i], grid.dt_s, design_.store != SweepDesign::Store::summary),
             std::nullopt});
    } catch (const TimedOut&) {
      if (runs.size() == 1) return time_out(runs.front());
      for (std::size_t i = 0; i < runs.size(); ++i)
        summarise(runs.subspan(i, 1), grid);  // it may be a neighbour's time
    }
  }

  void simulate_in_full(const Prepared& p) {
    const Scenario& scenario = p.file.scenario;
    const auto stride = std::lround(1e-3 * design_.frame_every_ms / scenario.time.dt_s);
    try {
      const BreathRun run = run_breath(trunk_, scenario, std::max(1, static_cast<int>(stride)), watchdog());
      done_.push_back(
          {row_of(p.run, run, scenario.time.dt_s, true), run_record(p.file, trunk_, run, {}, provenance_)});
      done_.back().row.has_file = true;
    } catch (const TimedOut&) {
      time_out(p);
    }
  }

  const SweepDesign& design_;
  const Provenance& provenance_;
  const Limits& limits_;
  const Trunk& trunk_;
  std::vector<FinishedRun> done_;
};

}  // namespace

struct SweepSimulator::Ready {
  std::size_t model;
  ScenarioFile file;
  Trunk trunk;
};

SweepRow row_of(std::size_t run, const RunSummary& s) {
  return {run,
          s.status,
          s.status == "completed" ? "" : s.message,
          now_s(),
          true,
          numbers_of(s.measures),
          thinned(s.curve_dV_ml, 1.0, [&](std::size_t i) { return s.curve_time_s[i]; })};
}

SweepSimulator::SweepSimulator(const SweepDesign& design, Provenance provenance, Limits limits)
    : design_(design), provenance_(std::move(provenance)), limits_(std::move(limits)) {
  for (const auto& subject : design.subjects) subjects_.push_back(read_parameters(subject.path));
}

SweepSimulator::~SweepSimulator() = default;

std::size_t SweepSimulator::together() const noexcept {
  return design_.store == SweepDesign::Store::full ? 1 : batch_lanes;
}

std::shared_ptr<const SweepSimulator::Ready> SweepSimulator::ready_for(std::size_t run) const {
  const std::size_t model = design_.model_of(run);
  const std::lock_guard lock(mutex_);
  if (last_ && last_->model == model) return last_;
  const SweepDesign::Run r = design_.run(run);
  ScenarioFile file = read_scenario(design_.scenarios[r.scenario].path);
  apply_settings(design_.settings_of(r.values), file);
  Trunk trunk = assemble_trunk(file);
  return last_ = std::make_shared<const Ready>(Ready{model, std::move(file), std::move(trunk)});
}

std::vector<FinishedRun> SweepSimulator::operator()(std::span<const std::size_t> runs) const {
  std::vector<FinishedRun> done;
  const auto fail_run = [&](std::size_t run, const std::exception& error) {
    done.push_back({failed(run, "invalid", error.what()), std::nullopt});
  };
  try {
    const std::shared_ptr<const Ready> ready = ready_for(runs.front());
    std::vector<Prepared> prepared;
    for (const std::size_t run : runs) try {
        const SweepDesign::Run r = design_.run(run);
        ScenarioFile file = ready->file;
        if (!subjects_.empty()) adopt_parameters(subjects_[r.subject], file.scenario);
        apply_settings(design_.settings_of(r.values), file);
        prepared.push_back({run, std::move(file)});
      } catch (const std::exception& error) {
        fail_run(run, error);
      }
    for (FinishedRun& f : Batch(design_, provenance_, limits_, ready->trunk).simulate(std::move(prepared)))
      done.push_back(std::move(f));
  } catch (const Cancelled&) {
  } catch (const std::exception& error) {
    for (const std::size_t run : runs)
      if (std::none_of(done.begin(), done.end(), [&](const FinishedRun& f) { return f.row.run == run; }))
        fail_run(run, error);
  }
  return done;
}

}  // namespace trunk
