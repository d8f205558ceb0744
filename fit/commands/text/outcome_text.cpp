#include "commands/text/outcome_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "commands/text/output.hpp"
#include "commands/text/structure_text.hpp"
#include "math/units.hpp"
#include "subject/fit_summary.hpp"
#include "subject/record.hpp"

namespace trunk {
namespace {

std::string predicted_text(const PredictionSummary& p, const char* name) {
  const Predicted& n = p[name];
  const std::string unit = n.unit == "percent" ? "%" : n.unit;
  if (!std::isfinite(n.lower95)) return fmt::format("{} {}", shown(n.value, "{:.4g}"), unit);
  return fmt::format("{:.4g} ({:.4g} to {:.4g}) {}", n.value, n.lower95, n.upper95, unit);
}

/// Returns how far numbers may be off by choices of the model, or "".
std::string structural_text(const PredictionSummary& p) {
  if (p.structure.empty()) return "";
  const auto range = [&](const char* name) {
    const Predicted& n = p[name];
    return shown(n.structural_lower95, "{:.4g}") + " to " + shown(n.structural_upper95, "{:.4g}");
  };
  return fmt::format(
      "    over choices of the model: {} % of its own; the domes {} mm right and {} mm left; shortening {} "
      "mm\n",
      range("ratio_percent"), range("excursion_right_mm"), range("excursion_left_mm"), range("delta_l_mm"));
}

}  // namespace

std::string breaths_table(const std::vector<BreathRefit>& breaths) {
  if (breaths.empty()) return "";
  std::string text =
      "  breath   onset s  tidal ml  k_muscle N/m         95 % interval  residual %  evaluations    ms\n";
  for (const BreathRefit& b : breaths)
    text +=
        fmt::format("  {:>6} {:>9.2f} {:>9.0f}  {:>12}  {:>20}  {:>10}  {:>11}  {:>4.0f}{}\n", b.number,
                    b.onset_s, ml_per_m3 * b.tidal_volume_m3, shown(b.muscle.value, "{:.4g}"),
                    shown(b.muscle.lower95, "{:.4g}") + " to " + shown(b.muscle.upper95, "{:.4g}"),
                    shown(100.0 * b.nrmse, "{:.2f}"), b.evaluations, 1e3 * b.latency_s,
                    b.status == "converged" ? "" : "  " + b.status + (b.error.empty() ? "" : ": " + b.error));
  const auto good =
      std::count_if(breaths.begin(), breaths.end(), [](const auto& b) { return b.status == "converged"; });
  return text + fmt::format("  {} of {} breaths converged, {:.0f} ms each (median)\n", good, breaths.size(),
                            1e3 * median_latency_s(breaths));
}

std::string predictions_table(const std::vector<Prediction>& predictions, bool detailed) {
  std::string text;
  for (const Prediction& prediction : predictions) {
    const PredictionSummary p = summary_of(prediction);
    text += fmt::format(
        "  in {}: {}, {} of its own{}\n", p.name, predicted_text(p, "delta_v_ml"),
        predicted_text(p, "ratio_percent"),
        p.failed == 0 ? "" : fmt::format("; {} of {} draws FAILED and are left out", p.failed, p.draws));
    text += fmt::format("    the domes descend {} right and {} left; the zone of apposition shortens by {}\n",
                        predicted_text(p, "excursion_right_mm"), predicted_text(p, "excursion_left_mm"),
                        predicted_text(p, "delta_l_mm"));
    text += fmt::format("    where they are most risen: {} right and {} left\n",
                        predicted_text(p, "excursion_right_most_risen_mm"),
                        predicted_text(p, "excursion_left_most_risen_mm"));
    text += structural_text(p);
    if (detailed)
      text += structure_table(p.structure,
                              {"ratio_percent", "excursion_right_mm", "excursion_left_mm", "delta_l_mm"});
  }
  return text;
}

}  // namespace trunk
