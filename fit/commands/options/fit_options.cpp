#include "commands/options/fit_options.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>

#include "commands/commands.hpp"
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

void add_measurement_options(CLI::App& command, FitRequest& r) {
  constexpr const char* group = "What is measured";
  command
      .add_option("--trace", r.trace,
                  "Fits this recording of volume, flow or a belt: a text table, MATLAB, EDF or BDF.")
      ->type_name("FILE")
      ->group(group);
  command
      .add_option("--tidal-volume-ml", r.tidal_volume_ml,
                  "Fits k_muscle to this tidal volume in ml instead of a trace.")
      ->type_name("ML")
      ->group(group)
      ->check(within(10.0, 10000.0));
  command
      .add_option(
          "--breath", r.breath,
          "Says what is fitted: the mean breath (mean), the mean breath and then k_muscle of every breath "
          "(each), or the breath with this number. [mean]")
      ->type_name("mean|each|N")
      ->group(group);
  command
      .add_option(
          "--weights", r.weights,
          "Weights all samples alike (uniform), or by the column of their deviations (sigma). [uniform]")
      ->type_name("NAME")
      ->group(group)
      ->check(one_of({"uniform", "sigma"}));
}

void add_parameter_options(CLI::App& command, FitRequest& r) {
  constexpr const char* group = "What is fitted";
  command
      .add_option("--free", r.plan.free,
                  "Fits these parameters. Separate them by commas; timing and shape each stand for several. "
                  "[k_elasticity,k_muscle]")
      ->type_name("NAMES")
      ->group(group)
      ->delimiter(',');
  command
      .add_option("--fix", r.plan.fixed,
                  "Holds a parameter at a value, or at its value in the result of a fit. You can repeat it.")
      ->type_name("NAME=VALUE|NAME=@FILE")
      ->group(group)
      ->take_all();
  command
      .add_option("--prior", r.priors,
                  "Says what is known of a parameter beforehand: its mean, and the factor that is one "
                  "standard deviation. "
                  "You can repeat it.")
      ->type_name("NAME=MEAN:FACTOR")
      ->group(group)
      ->take_all();
  command
      .add_option("--set", r.settings,
                  "Sets a key of the scenario. You can repeat it. `trunk check --keys` lists the keys.")
      ->type_name("KEY=VALUE")
      ->group(group)
      ->take_all();
  command
      .add_option(
          "--timing", r.timing,
          "Estimates the timing of the activation along with the parameters (joint), takes it from the trace "
          "and holds it (trace), or takes it from the scenario (scenario). [joint]")
      ->type_name("NAME")
      ->group(group)
      ->check(one_of({"joint", "trace", "scenario"}));
  command
      .add_option("--assume", r.assume,
                  "Gives intervals that hold only if the activation is made of straight lines "
                  "(straight-activation).")
      ->type_name("NAME")
      ->group(group)
      ->check(one_of({"straight-activation"}));
  command.add_flag("--keep-timing", r.keep_timing, "Does the same as --timing scenario.")->group(group);
}

void add_search_options(CLI::App& command, FitRequest& r) {
  constexpr const char* group = "How to search";
  SearchOptions& search = r.plan.estimation.search;
  command
      .add_option("--loss", r.loss,
                  "Charges residuals by their squares (squares), or charges outliers less (huber, student). "
                  "[squares]")
      ->type_name("NAME")
      ->group(group)
      ->check(one_of({"squares", "huber", "student"}));
  command
      .add_option(
          "--algorithm", search.algorithm,
          "Searches by this method: " + algorithm_names() + ". [bobyqa; lm for more than 4 parameters]")
      ->type_name("NAME")
      ->group(group);
  command
      .add_option("--max-evaluations", search.max_evaluations,
                  "Ends a search after this many simulations. [600]")
      ->type_name("N")
      ->group(group)
      ->check(whole_number(1, 1000000));
  command
      .add_option("--starts", r.plan.starts,
                  "Lets one compartment search from this many places, which --seed spreads. [12]")
      ->type_name("N")
      ->group(group)
      ->check(whole_number(1, 10000));
  command.add_option("--seed", search.seed, "Starts all random numbers from this seed. [1]")
      ->type_name("N")
      ->group(group)
      ->check(whole_number(0, std::numeric_limits<std::int64_t>::max()));
}

void add_interval_options(CLI::App& command, FitRequest& r) {
  constexpr const char* group = "Intervals";
  command
      .add_option("--surface", r.surface,
                  "Computes the likelihood of two parameters at this many points along each. 0 computes "
                  "none. [21]")
      ->type_name("N")
      ->group(group)
      ->check(whole_number(0, 200));
  command
      .add_option("--bootstrap", r.plan.estimation.bootstrap,
                  "Fits this many resampled traces (block bootstrap). 0 resamples none. [0]")
      ->type_name("N")
      ->group(group)
      ->check(whole_number(0, 100000));
}

void add_prediction_options(CLI::App& command, FitRequest& r) {
  constexpr const char* group = "Predictions";
  command
      .add_option("--predict,--scenario", r.predict,
                  "Predicts what the subject does in another scenario. You can repeat it.")
      ->type_name("FILE")
      ->group(group)
      ->take_all()
      ->allow_extra_args(false);
  command
      .add_option(
          "--draws", r.draws,
          "Draws this many sets of parameters for the interval of a prediction. 0 gives no interval. [64]")
      ->type_name("N")
      ->group(group)
      ->check(whole_number(0, 100000));
  command
      .add_flag(
          "--structural,!--no-structural", r.structural,
          "Gives numbers of a prediction a second interval, over choices of the model that no trace settles. "
          "--no-structural leaves it out. [--structural]")
      ->group(group);
}

}  // namespace

void add_scenario_option(CLI::App& command, FitRequest& request) {
  command.add_option("SCENARIO", request.scenario,
                     "The scenario file, whose name ends in .toml. Any other file is taken as the trace. "
                     "[healthy.toml, which comes "
                     "with trunk]");
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
  add_measurement_options(command, r);
  add_signal_options(command, r.signal);
  add_clinic_options(command, r.clinic);
  add_breath_options(command, r.selection);
  add_parameter_options(command, r);
  add_search_options(command, r);
  add_interval_options(command, r);
  add_prediction_options(command, r);
}

}  // namespace trunk
