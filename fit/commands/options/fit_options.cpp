#include "commands/options/fit_options.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "commands/options/breath_options.hpp"
#include "commands/options/shipped_files.hpp"
#include "commands/options/trace_options.hpp"
#include "errors/input_error.hpp"

namespace trunk {
namespace {

/// Whether the name of a file says that it is a scenario.
bool names_scenario(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".toml";
}

}  // namespace

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
  const std::string whom = request.cohort.empty() ? "" : " for every subject whose row names none";
  return {"no scenario is named, so trunk takes " + request.scenario + whom};
}

void add_subject_options(CLI::App& command, FitRequest& r) {
  SearchOptions& search = r.plan.estimation.search;
  command.add_option("--trace", r.trace, "trace of volume, flow or belt (text table, MATLAB, EDF, BDF)");
  add_signal_options(command, r.signal);
  add_breath_options(command, r.selection);
  command.add_option("--tidal-volume-ml", r.tidal_volume_ml,
                     "fit k_muscle to this one number instead of a trace");
  command.add_option("--breath", r.breath,
                     "what is fitted: mean (the mean breath), each (the mean breath, then k_muscle breath by "
                     "breath), or the "
                     "number of one breath [mean]");
  command
      .add_option("--predict,--scenario", r.predict,
                  "another scenario, in which the subject's tidal volume is predicted; may be repeated")
      ->take_all()
      ->allow_extra_args(false);
  command
      .add_option(
          "--draws", r.draws,
          "how many sets of parameters are drawn for the interval of a prediction; 0: no interval [64]")
      ->check(CLI::Range(0, 100000));
  command
      .add_option("--free", r.plan.free,
                  "parameters to fit, separated by commas; timing and shape each stand for several "
                  "[k_elasticity,k_muscle]")
      ->delimiter(',');
  command
      .add_option("--fix", r.plan.fixed,
                  "hold a parameter: name=value, or name=@fit.h5 for its value in that file; may be repeated")
      ->take_all();
  command
      .add_option("--prior", r.priors,
                  "what is known of a parameter beforehand: name=MEAN:FACTOR, one standard deviation; may be "
                  "repeated")
      ->take_all();
  command
      .add_option("--set", r.settings, "key=value, which replaces the value in the scenario; may be repeated")
      ->take_all();
  command
      .add_option("--timing", r.timing,
                  "timing of the activation: joint (it is estimated along with the parameters), trace (it is "
                  "taken from the "
                  "trace and held) or scenario (it is that of the scenario) [joint]")
      ->check(CLI::IsMember({"joint", "trace", "scenario"}));
  command.add_flag("--keep-timing", r.keep_timing, "the same as --timing scenario");
  command
      .add_option("--weights", r.weights,
                  "weights of the samples: uniform, or sigma (by the deviation of each sample) [uniform]")
      ->check(CLI::IsMember({"uniform", "sigma"}));
  command
      .add_option(
          "--loss", r.loss,
          "how residuals are charged: squares, or huber or student if outliers must count less [squares]")
      ->check(CLI::IsMember({"squares", "huber", "student"}));
  command.add_option("--algorithm", search.algorithm,
                     "search method: " + algorithm_names() + " [bobyqa; lm for more than 4 parameters]");
  command
      .add_option("--max-evaluations", search.max_evaluations,
                  "largest number of simulations in each search [600]")
      ->check(CLI::Range(1, 1000000));
  command
      .add_option("--starts", r.plan.estimation.starts,
                  "number of places from which a search starts; --seed spreads them [1]")
      ->check(CLI::Range(1, 10000));
  command.add_option("--seed", search.seed, "seed of all random numbers [1]");
  command
      .add_option("--surface", r.surface,
                  "points of the likelihood surface along each of two parameters; 0: no surface [11, if it "
                  "takes less than "
                  "10 s]")
      ->check(CLI::Range(0, 200));
  command.add_flag("--profiles", r.force_profiles, "compute profiles even if they take longer than 10 s");
  command
      .add_option("--bootstrap", r.plan.estimation.bootstrap, "number of repeats of a block bootstrap [0]")
      ->check(CLI::Range(0, 100000));
}

}  // namespace trunk
