#include "commands/text/outcome_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "subject/record.hpp"

namespace trunk {
namespace {

Json predicted_json(const Predicted& p, double scale) {
  return {{"value", json_number(scale * p.value)},
          {"median", json_number(scale * p.median)},
          {"lower95", json_number(scale * p.lower95)},
          {"upper95", json_number(scale * p.upper95)}};
}

std::string predicted_text(const Predicted& p, double scale, const char* unit) {
  if (p.draws.empty()) return fmt::format("{} {}", shown(scale * p.value, "{:.4g}"), unit);
  return fmt::format("{} ({} to {}) {}", shown(scale * p.value, "{:.4g}"), shown(scale * p.lower95, "{:.4g}"),
                     shown(scale * p.upper95, "{:.4g}"), unit);
}

}  // namespace

Json breaths_json(const std::vector<BreathRefit>& breaths) {
  Json list = Json::array();
  for (const BreathRefit& b : breaths) {
    Json row{{"number", b.number},
             {"onset_s", b.onset_s},
             {"tidal_volume_ml", 1e6 * b.tidal_volume_m3},
             {"status", b.status},
             {"k_muscle",
              {{"value", json_number(b.muscle.value)},
               {"unit", b.muscle.unit},
               {"stderr", json_number(b.muscle.stderr_)},
               {"lower95", json_number(b.muscle.lower95)},
               {"upper95", json_number(b.muscle.upper95)}}},
             {"nrmse_percent", json_number(100.0 * b.nrmse)},
             {"evaluations", b.evaluations},
             {"latency_ms", 1e3 * b.latency_s}};
    if (!b.error.empty()) row["error"] = b.error;
    list.push_back(std::move(row));
  }
  return list;
}

Json predictions_json(const std::vector<Prediction>& predictions) {
  Json list = Json::array();
  for (const Prediction& p : predictions)
    list.push_back({{"name", short_name(p.scenario)},
                    {"scenario", p.scenario},
                    {"delta_v_ml", predicted_json(p.delta_v_m3, 1e6)},
                    {"own_delta_v_ml", predicted_json(p.own_m3, 1e6)},
                    {"ratio_percent", predicted_json(p.ratio, 100.0)},
                    {"draws", p.ratio.draws.size()},
                    {"failed", p.failed}});
  return list;
}

std::string breaths_table(const std::vector<BreathRefit>& breaths) {
  if (breaths.empty()) return "";
  std::string text =
      "  breath   onset s  tidal ml  k_muscle N/m         95 % interval  residual %  evaluations    ms\n";
  for (const BreathRefit& b : breaths)
    text +=
        fmt::format("  {:>6} {:>9.2f} {:>9.0f}  {:>12}  {:>20}  {:>10}  {:>11}  {:>4.0f}{}\n", b.number,
                    b.onset_s, 1e6 * b.tidal_volume_m3, shown(b.muscle.value, "{:.4g}"),
                    shown(b.muscle.lower95, "{:.4g}") + " to " + shown(b.muscle.upper95, "{:.4g}"),
                    shown(100.0 * b.nrmse, "{:.2f}"), b.evaluations, 1e3 * b.latency_s,
                    b.status == "converged" ? "" : "  " + b.status + (b.error.empty() ? "" : ": " + b.error));
  const auto good =
      std::count_if(breaths.begin(), breaths.end(), [](const auto& b) { return b.status == "converged"; });
  return text + fmt::format("  {} of {} breaths converged, {:.0f} ms each (median)\n", good, breaths.size(),
                            1e3 * median_latency_s(breaths));
}

std::string predictions_table(const std::vector<Prediction>& predictions) {
  std::string text;
  for (const Prediction& p : predictions)
    text += fmt::format("  in {}: {}, {} of its own{}\n", short_name(p.scenario),
                        predicted_text(p.delta_v_m3, 1e6, "ml"), predicted_text(p.ratio, 100.0, "%"),
                        p.failed == 0 ? ""
                                      : fmt::format("; {} of {} draws FAILED and are left out", p.failed,
                                                    p.ratio.draws.size()));
  return text;
}

}  // namespace trunk
