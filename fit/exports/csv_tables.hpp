#pragma once

#include <vector>

#include "exports/named_text.hpp"
#include "results/records.hpp"

namespace trunk {

/// Returns a run as tables: curves, measures, parameters, and, if there are any, intervals of the measures;
/// and if there is a trajectory, frames, positions, particles, triangles and fibres. Headers carry units
/// (time_s, dV_model_ml), and numbers have all their digits. An unknown number is an empty cell.
std::vector<NamedText> csv_tables(const RunRecord& run);

/// Returns the tables of the trajectory alone; none if there is no trajectory.
std::vector<NamedText> csv_trajectory_tables(const RunRecord& run);

/// Returns a fit as tables: parameters, statistics, breath, evaluations, the measures, curves and trajectory
/// of its best run, and, if the fit has them, starts, profiles, surface, breaths and predictions.
std::vector<NamedText> csv_tables(const FitRecord& fit);

}  // namespace trunk
