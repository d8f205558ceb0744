#pragma once

#include <functional>
#include <optional>

#include "breaths/mean_breath.hpp"
#include "compartment/one_compartment.hpp"
#include "search/minimise.hpp"
#include "uncertainty/uncertainty.hpp"

namespace trunk {

/// How well a fitted curve meets the measured one.
struct Quality {
  double tidal_volume_m3 = 0.0;        // measured
  double nrmse = 0.0;                  // RMS residual over tidal volume
  double tidal_volume_error_m3 = 0.0;  // model minus measured
  double peak_time_error_s = 0.0;      // model minus measured
  double baseline_nrmse = 0.0;         // of the one-compartment model
};

/// The outcome of analysis by synthesis for one breath.
struct Estimation {
  SearchResult search;
  std::optional<Uncertainty> uncertainty;  // none where the search found nothing to stand on
  Candidate best;
  Eigen::VectorXd model;  // at the target's samples, m3
  Quality quality;
  std::vector<Evaluation> evaluations;
  int failures = 0;
};

/// The target a measured breath makes.
Target target_of(const MeasuredBreath& breath);

/// Times the scenario's activation after a measured breath (our choice; the paper's 2 s, 0.5 s, 2 s are one
/// subject's). The volume lags behind the muscle, so its own peak and fall are only the start: rise and falls
/// are those with which a one-compartment model follows the breath best.
void adopt_timing(const MeasuredBreath& breath, Scenario& scenario);

/// What is asked of an estimation beside the search.
struct EstimationOptions {
  SearchOptions search;
  bool timing_from_trace =
      false;  // the scenario's activation was adopted from the trace: it is uncertain too
};

/// Fits the parameters named in `space` to `target`: a start at the measured tidal volume, a search, a second
/// one from its best point with a smaller step, uncertainty, baseline. Throws InputError on a target or space
/// that make no sense; a search that fails is reported in the result.
Estimation estimate(const Trunk& trunk, const Scenario& scenario, const SearchSpace& space,
                    const Target& target, const EstimationOptions& options,
                    const std::function<bool()>& cancelled = {});

}  // namespace trunk
