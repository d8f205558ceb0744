#include "commands/options/fit_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <limits>

#include "commands/options/breath_options.hpp"
#include "commands/options/shipped_files.hpp"
#include "errors/input_error.hpp"

namespace trunk {
namespace {

/// --prior name=MEAN:FACTOR (or MEAN:SD for what is searched for by amounts), name=:FACTOR, name=none.
Prior prior_of(const std::string& text) {
  const std::string expected =
      "expected name=MEAN:FACTOR, as in --prior k_elasticity=4000:1.5, name=:FACTOR around the start, or "
      "name=none";
  const auto equals = text.find('=');
  if (equals == std::string::npos) throw InputError("--prior " + text + ": " + expected);
  const FreeParameter& p = free_parameter(text.substr(0, equals));
  const std::string value = text.substr(equals + 1);
  if (value == "none") return {std::string(p.name), {}, 0.0};
  const auto colon = value.find(':');
  const auto number = [&](std::string_view part) {
    double n = 0.0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), n);
    if (error != std::errc() || end != part.data() + part.size() || !std::isfinite(n))
      throw InputError("--prior " + text + ": " + expected);
    return n;
  };
  if (colon == std::string::npos) throw InputError("--prior " + text + ": " + expected);
  Prior prior{std::string(p.name), {}, number(std::string_view(value).substr(colon + 1))};
  if (colon > 0) prior.mean = number(std::string_view(value).substr(0, colon));
  const bool factor = p.scale == FreeParameter::Scale::factor;
  if (!(prior.deviation > (factor ? 1.0 : 0.0) && prior.deviation <= 1000.0))
    throw InputError(fmt::format("--prior {}: expected {}", text,
                                 factor ? "a factor above 1, at most 1000" : "a standard deviation above 0"));
  if (factor) prior.deviation = std::log(prior.deviation);
  return prior;
}

bool names_scenario(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".toml";
}

/// A setting that the trace would overwrite is a contradiction, not a wish.
void require_no_timing(const FitRequest& request) {
  static constexpr std::string_view timed[] = {"activation.onset_s",     "activation.rise_s",
                                               "activation.fast_fall_s", "activation.slow_fall_s",
                                               "activation.period_s",    "time.duration_s"};
  for (const std::string& text : request.settings)
    for (std::string_view key : timed)
      if (setting_of(text).key == key)
        throw InputError(fmt::format(
            "--set {}: the timing is taken from the trace, expected --timing scenario beside it", text));
}

}  // namespace

FitPlan plan_of(const FitRequest& request) {
  FitPlan plan = request.plan;
  for (const std::string& text : request.priors) plan.priors.push_back(prior_of(text));
  if (request.keep_timing || request.timing == "scenario")
    plan.timing = Timing::scenario;
  else
    plan.timing = request.timing == "trace" ? Timing::trace : Timing::joint;
  if (!request.trace.empty() && plan.timing != Timing::scenario) require_no_timing(request);
  plan.weighted = request.weights == "sigma";
  plan.estimation.loss = request.loss == "huber"     ? Loss::huber
                         : request.loss == "student" ? Loss::student
                                                     : Loss::squares;
  if (!plan.estimation.search.algorithm.empty()) require_algorithm(plan.estimation.search.algorithm);
  if (request.surface >= 0) plan.estimation.surface_points = request.surface;
  if (request.surface == 1 || request.surface == 2)
    throw InputError("--surface: expected 0 (none) or 3 to 200 points along each parameter");
  if (request.surface > 0 || request.force_profiles)
    plan.estimation.budget_s = std::numeric_limits<double>::infinity();
  return plan;
}

void add_scenario_option(CLI::App& command, FitRequest& request) {
  command.add_option(
      "SCENARIO", request.scenario,
      "scenario file, which ends in .toml [healthy.toml, which comes with trunk]; any other file "
      "is taken as the trace");
}

std::vector<std::string> settle_files(FitRequest& request) {
  if (!request.scenario.empty() && !names_scenario(request.scenario)) {
    const Place file{request.scenario};
    const std::string found = "is taken as a trace, because its name does not end in .toml";
    if (!request.trace.empty())
      throw InputError(file, found + ", and --trace names another: " + request.trace, "one trace");
    if (!request.cohort.empty())
      throw InputError(file, found + ", and --cohort names a list of traces: " + request.cohort,
                       "one of the two");
    request.trace = std::move(request.scenario);
    request.scenario.clear();
  }
  if (!request.scenario.empty()) return {};
  request.scenario = shipped_file("scenarios/healthy.toml", "SCENARIO").string();
  return {"no scenario is named, so trunk takes " + request.scenario};
}

void add_subject_options(CLI::App& command, FitRequest& r) {
  SearchOptions& search = r.plan.estimation.search;
  command.add_option("--trace", r.trace, "trace of volume, flow or belt (text table, MATLAB, EDF, BDF)");
  add_signal_options(command, r.signal);
  add_breath_options(command, r.selection);
  command.add_option("--tidal-volume-ml", r.tidal_volume_ml,
                     "fit k_muscle to this one number instead of a trace");
  command.add_option(
      "--breath", r.breath,
      "mean; each (the mean, then k_muscle breath by breath); the number of one breath [mean]");
  command
      .add_option("--predict,--scenario", r.predict,
                  "another scenario: predicts the subject's tidal volume there; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
  command.add_option("--draws", r.draws, "of the parameters, for the interval of a prediction; 0: none [64]")
      ->check(CLI::Range(0, 100000));
  command
      .add_option(
          "--free", r.plan.free,
          "parameters to fit, comma separated; timing and shape stand for several [k_elasticity,k_muscle]")
      ->delimiter(',');
  command.add_option("--fix", r.plan.fixed, "name=value or name=@fit.h5; may be repeated")->take_all();
  command
      .add_option("--prior", r.priors,
                  "name=MEAN:FACTOR, what is known beforehand (one standard deviation); may be repeated")
      ->take_all();
  command.add_option("--set", r.settings, "key=value, over the scenario; may be repeated")->take_all();
  command
      .add_option(
          "--timing", r.timing,
          "of the activation: joint (estimated along with the parameters), trace (taken from it and held) "
          "or scenario [joint]")
      ->check(CLI::IsMember({"joint", "trace", "scenario"}));
  command.add_flag("--keep-timing", r.keep_timing, "the same as --timing scenario");
  command.add_option("--weights", r.weights, "uniform, or sigma: by the deviation of each sample [uniform]")
      ->check(CLI::IsMember({"uniform", "sigma"}));
  command
      .add_option("--loss", r.loss, "squares, or huber or student where outliers must count less [squares]")
      ->check(CLI::IsMember({"squares", "huber", "student"}));
  command.add_option("--algorithm", search.algorithm,
                     algorithm_names() + " [bobyqa; lm for more than 4 parameters]");
  command.add_option("--max-evaluations", search.max_evaluations, "simulations at most in each search [600]")
      ->check(CLI::Range(1, 1000000));
  command
      .add_option("--starts", r.plan.estimation.starts,
                  "searches from this many places, spread by --seed [1]")
      ->check(CLI::Range(1, 10000));
  command.add_option("--seed", search.seed, "of all that is random [1]");
  command
      .add_option("--surface", r.surface,
                  "points along each of two parameters; 0: none [11, where it takes less than 10 s]")
      ->check(CLI::Range(0, 200));
  command.add_flag("--profiles", r.force_profiles, "profiles, however long they take");
  command.add_option("--bootstrap", r.plan.estimation.bootstrap, "repeats of a block bootstrap [0]")
      ->check(CLI::Range(0, 100000));
}

}  // namespace trunk
