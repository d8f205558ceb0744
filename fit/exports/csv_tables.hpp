#pragma once

#include <vector>

#include "exports/named_text.hpp"
#include "results/records.hpp"

namespace trunk {

/// A run as tables: curves, frames, positions, particles, triangles, fibres, measures, parameters; those of
/// the trajectory only where there is one. Headers carry units (time_s, dV_model_ml), numbers all their
/// digits, what is not known is an empty cell.
std::vector<NamedText> csv_tables(const RunRecord& run);

/// Those of its trajectory alone.
std::vector<NamedText> csv_trajectory_tables(const RunRecord& run);

/// A fit as tables: parameters, statistics, breath, evaluations, and as there are starts, profiles, surface,
/// breaths, predictions; those of its best run as above.
std::vector<NamedText> csv_tables(const FitRecord& fit);

}  // namespace trunk
