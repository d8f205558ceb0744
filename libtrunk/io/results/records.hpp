#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// The content of results files as plain data, independent of the simulator and of HDF5.
///
/// Names become names in the file, so they are not empty, have no '/', and are unique in their group. `unit`
/// has the spelling of UDUNITS ("N m-1", "ml", "cmH2O"; "" and "1" both mean a pure number) and is written
/// unchanged. Files hold volumes in ml: members whose own name ends in `_m3` are converted, all other volumes
/// must be in ml.
namespace trunk {

struct NamedValue {
  std::string name, unit;
  double value = 0;
};

struct Series {
  std::string name, unit, meaning;
  std::vector<double> values;
};

struct NamedColumn {
  std::string name, unit;
  std::vector<double> values;
};

/// The origin of a file. Creation time, host and `argv` are left out under SOURCE_DATE_EPOCH.
struct Provenance {
  std::string version, git_sha;
  bool git_dirty = false;
  std::string compiler, build_type, argv;
  std::uint64_t seed = 0;
  std::vector<std::pair<std::string, std::string>> input_sha256;  ///< file name, hash in hexadecimal
  std::vector<std::pair<std::string, std::string>> libraries;     ///< name, version
};

/// T frames of N particles, and the connections between the particles.
struct Trajectory {
  std::size_t particles = 0;                            ///< N; 0: the file has no trajectory
  std::vector<double> time_s;                           ///< [T]
  std::vector<std::int64_t> step;                       ///< [T]
  std::vector<double> position_m;                       ///< [T*N*3]
  std::vector<double> velocity_m_s;                     ///< [T*N*3] or empty
  std::vector<double> force_N;                          ///< [T*N*3] or empty
  std::vector<double> mass_kg;                          ///< [N] or empty
  std::vector<std::int32_t> region;                     ///< [N] or empty; index in region_names
  std::vector<std::string> region_names;                //
  std::vector<std::int32_t> rigid;                      ///< [N] or empty; index in rigid_names
  std::vector<std::string> rigid_names;                 ///< the first means: no rigid component
  std::vector<std::array<std::int32_t, 3>> triangles;   ///< [M]
  std::vector<std::int32_t> triangle_component;         ///< [M] or empty; index in component_names
  std::vector<std::string> component_names;             //
  std::vector<std::array<std::int32_t, 2>> fibres;      ///< [F]
  std::vector<std::vector<std::int32_t>> muscle_lines;  ///< [L], all of one length; or empty
  std::vector<double> fibre_activity;                   ///< [F] or empty; fraction of k_muscle, 0: paralysed
  std::vector<std::int32_t> contact;                    ///< [T*N] or empty; index in contact_names
  std::vector<std::string> contact_names;               //
};

/// The choices of the model behind structural intervals, and how much of each interval a choice makes up.
struct Structure {
  /// A choice that was varied over a range. `low`, `value` and `high` are of the first of its keys.
  struct Choice {
    std::string name, keys, unit;
    std::string source;  ///< of the range
    double low = 0, value = 0, high = 0;
  };
  std::vector<Choice> choices;        ///< [C]
  std::vector<std::string> measures;  ///< [M] numbers that have a structural interval
  std::vector<double> shares;         ///< [M*C] of the variance; a row adds to 1, or is NaN: nothing changes
  std::vector<std::string> left_out;  ///< choices that were not varied, and why: one sentence each

  bool empty() const noexcept { return choices.empty() && left_out.empty(); }
};

/// One simulation. `measures` are the row of Table 1. `frame_series` have the times of the trajectory, and
/// `curves` have their own times.
struct RunRecord {
  std::string title, status, message;
  std::string scenario_toml;           ///< the unchanged text
  std::string trunk_pml;               ///< the trunk if it comes from a file; "" for the parametric one
  std::vector<NamedValue> parameters;  ///< resolved, in natural units
  std::vector<NamedValue> measures;    //
  std::vector<NamedValue> intervals;   ///< of the measures: over draws of a fit, and structural; or empty
  Structure structure;                 ///< of the structural intervals; or empty
  Trajectory trajectory;               //
  std::vector<double> curve_time_s;    ///< [Tc]
  std::vector<Series> curves;          ///< each [Tc]
  std::vector<Series> frame_series;    ///< each [T], sampled with the frames of the trajectory
  Provenance provenance;
};

/// One fit with P parameters, of which F are free, and E evaluations of the objective.
struct FitRecord {
  struct Parameter {
    std::string name, unit;
    double initial = 0, lower = 0, upper = 0, best = 0, stderr_ = 0, lower95 = 0, upper95 = 0;
    bool at_bound = false, free = true;
    bool beside = false;  // estimated together with the free parameters, though the user did not free it
    double naive_lower95 = 0, naive_upper95 = 0;  // under the assumption that all samples are independent
  };
  /// One local search of a multistart.
  struct Start {
    std::vector<double> from, to;  ///< [F], natural units
    double objective = 0;
    bool converged = false;
  };
  /// The deviance along one parameter, with the best values of all others.
  struct Profile {
    std::string name, unit;
    std::vector<double> value, deviance;  ///< [K]
    std::vector<std::int32_t> at_bound;   ///< [K] another parameter is at its bound
    double lower95 = 0, upper95 = 0;      ///< infinite if the profile interval is open
    double threshold95 = 3.84;            ///< the deviance at its ends; a file of version 1 does not hold it
  };
  /// The likelihood over a grid of two parameters; without points if it was not computed.
  struct Surface {
    std::string name[2], unit[2];
    std::vector<double> axis[2];   ///< [n]
    std::vector<double> deviance;  ///< [n*n], row-major: the second axis varies fastest
    double threshold95 = 0;
    double lower95[2] = {0, 0}, upper95[2] = {0, 0};  ///< the extent of the joint 95 % region
    bool closed = false;                              ///< the region does not reach the edge of the grid
  };
  /// A number that the fit reports.
  struct Result {
    std::string name, unit;
    double value = 0, lower95 = 0, upper95 = 0;  ///< NaN: withheld; infinite: no limit
    std::string grade;               ///< "determined", "assumption", "not_determined", "not_converged"
    std::string assumption, reason;  ///< what the interval stands on; why it is not determined; or ""
    std::string meaning;             ///< one line for a physiologist
    std::int32_t headline = 0;       ///< place among the results that are shown first, from 1; 0: it is not
    std::string rests_on{};          ///< "gastric pressure 71 %, volume 29 %"; or ""
  };
  /// Why the recording must not be fitted as it is.
  struct Gate {
    std::string name, sentence;
  };
  /// What was recorded beside the volume, over the mean breath. Pressures and the excursion are changes from
  /// end-expiration.
  struct Channel {
    std::string name, unit, meaning;  ///< "gastric_pressure", "cmH2O"
    std::vector<double> measured;     ///< [Tm]
    std::vector<double> sigma;        ///< [Tm] standard deviation over breaths
    std::vector<double> model;  ///< [Tm] with the offset, drift or gain of the fit; empty: no model of it
  };
  /// Whether a second search method finds the same result.
  struct CrossCheck {
    std::string first, second;  ///< the methods; empty if there is no second one
    bool agree = false;
  };
  /// Candidates that are as likely as the fit says: with them a prediction has an interval.
  struct Draws {
    std::vector<std::string> names;  ///< [P] parameters
    std::vector<double> values;      ///< [D*P], row-major, in the natural unit of each parameter
  };
  /// The prediction of the fit for another scenario.
  struct Prediction {
    std::string name, scenario;       ///< a short name; the file
    std::vector<NamedValue> numbers;  ///< measures and a ratio of volumes, with intervals
    std::vector<double> delta_v_m3,
        own_delta_v_m3;   ///< [D] draws of the parameters; NaN if a simulation fails
    Structure structure;  ///< of the structural intervals; or empty
  };

  std::string title, status, message;
  std::string scenario_toml;     ///< the unchanged text
  std::string input;             ///< the trace's own file name, without its folder; "" if there is no trace
  std::string grade;             ///< the worst of the results shown first; "" in a file of version 1
  std::vector<Result> results;   //
  std::vector<Gate> gates;       //
  std::vector<Result> straight;  ///< the same if the activation is made of straight lines; or empty
  double straight_nrmse_percent = 0;  ///< NaN if `straight` is empty
  std::string verdict, stop_reason, algorithm;
  std::vector<Parameter> parameters;          ///< [P]
  std::vector<std::string> covariance_names;  ///< [F]
  std::vector<double> covariance;  ///< [F*F], row-major, of the natural logarithms of the parameters

  std::vector<double> measured_time_s, measured_m3;  ///< [Tm]
  std::vector<double> sigma_m3;                      ///< [Tm] or empty; standard deviation of measured_m3
  std::vector<Channel> channels;                     ///< or empty

  std::vector<std::string> evaluation_names;    ///< [F], the parameters of the columns of evaluation_x
  std::vector<double> evaluation_x;             ///< [E*F], row-major, in the natural unit of each parameter
  std::vector<double> evaluation_objective;     ///< [E], NaN if the simulation fails
  std::vector<std::int32_t> evaluation_status;  ///< [E], 0 = simulated
  std::vector<double> evaluation_wall_s;        ///< [E]; left out under SOURCE_DATE_EPOCH

  std::vector<double> result_time_s, dV_fit_m3, residual_m3;  ///< [Tr]; residual = model - measured
  std::vector<NamedValue> statistics;                         ///< nrmse and others
  std::vector<Start> starts;                                  //
  std::vector<Profile> profiles;                              //
  Surface surface;                                            //
  std::vector<NamedColumn> breaths;                           ///< one fit per breath: columns [B]; or empty
  std::vector<std::string> breath_status;                     ///< [B]
  std::vector<Prediction> predictions;                        //
  Draws draws;                                                ///< without values if the fit has no spread
  RunRecord best_run;                                         ///< its provenance is that of the fit
  Provenance provenance;
  std::vector<double> dV_baseline_m3;                        ///< [Tr] of a one-compartment model; or empty
  std::vector<double> bootstrap_lower95, bootstrap_upper95;  ///< [P], NaN if it is not requested; or empty
  std::vector<std::string> notes;                            ///< on what was read, then on the fit
  CrossCheck cross_check;                                    //
  bool identifiable = false;                                 //
};

/// R runs in one table. A run that fails has a row too, with NaN for missing numbers.
struct SweepRecord {
  std::string title, sweep_toml;
  std::vector<NamedColumn> columns;   ///< parameters and measures, each [R]
  std::vector<std::string> scenario;  ///< [R]
  std::vector<std::string> subject;   ///< [R] or empty
  std::vector<std::string> status;    ///< [R]
  std::vector<std::string> error;     ///< [R], "" if there is none
  std::vector<std::string> run_file;  ///< [R], relative to the folder of the sweep file; "" if there is none
  std::vector<double> curve_time_s;   ///< [Tc]
  /// Fills in dV of n runs, beginning with `first`, in ml [n*Tc]. All runs together may not fit into memory.
  std::function<void(std::size_t first, std::span<double> dV_ml)> fill_curves_ml;
  Provenance provenance;
};

}  // namespace trunk
