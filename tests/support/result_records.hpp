#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "results/records.hpp"
#include "support/temporary_folder.hpp"

/// Records with something in every member, and files as bytes.
namespace trunk::test {

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

inline void put(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// The message of the error that `action` throws, one line; "" when there is none.
template <typename Exception, typename Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const Exception& error) {
    const std::string text = error.what();
    return text.find('\n') == std::string::npos ? text : "more than one line: " + text;
  }
  return "";
}

inline Provenance sample_provenance() {
  return {"0.1.0",
          "abc123",
          true,
          "g++ 12",
          "Release",
          "trunk simulate",
          7,
          {{"a.toml", "00ff"}},
          {{"NLopt", "2.7.1"}}};
}

inline RunRecord sample_run() {
  RunRecord run;
  run.title = "healthy";
  run.status = "done";
  run.message = "70 frames";
  run.scenario_toml = "[model]\nname = \"sain ΔV\"\n";
  run.trunk_pml = "<physicalModel/>";
  run.parameters = {{"k_muscle", "N m-1", 30.7}, {"k_elasticity", "N m-1", 4000}};
  run.measures = {{"delta_v", "ml", 466.125}, {"delta_l", "mm", 9.13}, {"wall_s", "s", 0.25}};
  run.intervals = {{"delta_v_lower95", "ml", 450.5}, {"delta_v_upper95", "ml", 480.25}};
  run.structure = {{{"wall", "parameters.abdomen_stiffness_factor", "1", "our choice", 0.5, 0.8, 1.25},
                    {"mesh", "geometry.resolution", "1", "the next one", 1, 1, 2}},
                   {"delta_v", "delta_l"},
                   {std::nan(""), std::nan(""), 0.25, 0.75},
                   {"dome_height is left out, because the trunk comes from a file"}};
  Trajectory& trajectory = run.trajectory;
  trajectory.particles = 3;
  for (int frame = 0; frame < 70; ++frame) {
    trajectory.step.push_back(5 * frame);
    trajectory.time_s.push_back(0.01 * frame);
    for (int i = 0; i < 9; ++i) trajectory.position_m.push_back(std::sin(0.1 * frame + i));
  }
  for (const double x : trajectory.position_m) trajectory.velocity_m_s.push_back(2 * x + 1);
  trajectory.mass_kg = {0.2, 0.2, 0.2};
  trajectory.region = {0, 1, 1};
  trajectory.region_names = {"lung", "central tendon"};
  trajectory.triangles = {{0, 1, 2}};
  trajectory.triangle_component = {0};
  trajectory.component_names = {"skin"};
  trajectory.fibres = {{0, 1}, {1, 2}};
  trajectory.muscle_lines = {{0, 1, 2}, {2, 1, 0}};
  Series volume{"dV_model", "ml", "volume change", {}};
  for (int step = 0; step <= 350; ++step) {
    run.curve_time_s.push_back(0.002 * step);
    volume.values.push_back(466 * std::sin(0.002 * step));
  }
  run.curves = {volume};
  trajectory.fibre_activity = {1, 0};
  trajectory.contact.assign(70 * 3, 0);
  trajectory.contact[4] = 2;
  trajectory.contact_names = {"none", "slides", "sticks"};
  run.frame_series = {{"dV", "ml", "volume change", std::vector<double>(70, 1.5)}};
  run.provenance = sample_provenance();
  return run;
}

inline FitRecord sample_fit() {
  const double none = std::numeric_limits<double>::quiet_NaN();
  FitRecord fit;
  fit.title = "S01";
  fit.status = "converged";
  fit.scenario_toml = "x = 1\n";
  fit.verdict = "k_muscle/k_elasticity determined to 0.4 %";
  fit.input = "breath ΔV.csv";
  fit.grade = "not_determined";
  const double unlimited = std::numeric_limits<double>::infinity();
  fit.results = {
      {"recoil_time_s", "s", 0.5, 0.2, unlimited, "assumption", "the airway takes 40 %", "",
       "the time in which volume falls", 2},
      {"k_muscle", "N m-1", none, none, none, "not_determined", "", "not driven by a muscle?", "", 1},
      {"delta_h_mm", "mm", 4, 3, 5, "determined", "", "", "how much the dome flattens", 0}};
  fit.gates = {{"machine_driven", "not driven by a muscle?"}, {"wander", "its level wanders"}};
  fit.straight = {{"k_muscle", "N m-1", 480, 470, 490, "assumption", "straight lines", "", "", 0}};
  fit.straight_nrmse_percent = 2.5;
  fit.stop_reason = "XTOL_REACHED";
  fit.algorithm = "BOBYQA";
  fit.parameters = {{"k_elasticity", "N m-1", 3000, 100, 1e5, 4000, 20, 3960, 4040, false, true},
                    {"k_muscle", "N m-1", 20, 1, 500, 500, 2, 496, none, true, true},
                    {"shape", "", 1, 0, 2, 1, none, none, none, false, false}};
  fit.covariance_names = {"k_elasticity", "k_muscle"};
  fit.covariance = {1e-4, 2e-5, 2e-5, 3e-4};
  fit.measured_time_s = fit.result_time_s = {0, 1, 2};
  fit.measured_m3 = {0, 4e-4, 0};
  fit.sigma_m3 = {1e-6, 1e-6, 1e-6};
  fit.channels = {{"gastric_pressure", "cmH2O", "gastric pressure", {0, 4, 0}, {1, 1, 2}, {0.5, 3, 0}},
                  {"emg", "1", "EMG of the diaphragm", {0, 9, 1}, {2, 2, 2}, {}}};
  fit.evaluation_names = {"k_elasticity", "k_muscle"};
  fit.evaluation_x = {3000, 20, 4000, 30};
  fit.evaluation_objective = {12.5, none};
  fit.evaluation_status = {0, 2};
  fit.evaluation_wall_s = {0.1, 0.2};
  fit.dV_fit_m3 = {0, 4.1e-4, 1e-6};
  fit.residual_m3 = {0, 1e-5, 1e-6};
  fit.statistics = {{"nrmse", "percent", 1.5}};
  fit.starts = {{{3000, 20}, {4000, 30}, 12.5, true}};
  fit.profiles = {{"k_muscle", "N m-1", {490, 500, 510}, {1, 0, 1.5}, {0, 0, 1}, 495, none, 4.5}};
  fit.surface = {{"k_elasticity", "k_muscle/k_elasticity"},
                 {"N m-1", "1"},
                 {{3900, 4000}, {0.1, 0.11, 0.12}},
                 {6, 5, 4, 3, 2, none},
                 6.2,
                 {3950, 0.1},
                 {4050, 0.12},
                 true};
  fit.breaths = {{"number", "1", {1, 2}}, {"k_muscle", "N m-1", {500, none}}};
  fit.breath_status = {"converged", "not converged: why"};
  fit.predictions = {{"paralysed",
                      "paralysed.toml",
                      {{"delta_v_ml", "ml", 220}},
                      {2e-4, 2.1e-4},
                      {4e-4, 4.1e-4},
                      sample_run().structure}};
  fit.draws = {{"k_elasticity", "k_muscle"}, {3990, 499, 4010, 503}};
  fit.dV_baseline_m3 = {0, 3.9e-4, 1e-6};
  fit.bootstrap_lower95 = {3950, 480, none};
  fit.bootstrap_upper95 = {4050, 520, none};
  fit.notes = {"no profiles"};
  fit.cross_check = {"bobyqa", "lm", true};
  fit.identifiable = true;
  fit.best_run = sample_run();
  fit.best_run.provenance = sample_provenance();
  fit.provenance = sample_provenance();
  return fit;
}

inline SweepRecord sample_sweep() {
  SweepRecord sweep;
  sweep.title = "grid";
  sweep.sweep_toml = "n = 2\n";
  sweep.columns = {{"k_muscle", "N m-1", {20, 30}}, {"delta_v", "ml", {400, std::nan("")}}};
  sweep.scenario = {"healthy", "healthy"};
  sweep.status = {"done", "diverged"};
  sweep.error = {"", "step 12: no volume root"};
  sweep.run_file = {"run.h5", ""};
  sweep.curve_time_s = {0, 1, 2};
  sweep.fill_curves_ml = [](std::size_t first, std::span<double> dV_ml) {
    const std::vector<double> all = {0, 400, 0, 0, 1, 2};
    std::copy_n(all.begin() + 3 * static_cast<std::ptrdiff_t>(first), dV_ml.size(), dV_ml.begin());
  };
  sweep.provenance = sample_provenance();
  return sweep;
}

}  // namespace trunk::test
