#include "commands/text/fit_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "commands/text/clinic_table.hpp"
#include "commands/text/outcome_text.hpp"
#include "commands/text/output.hpp"
#include "commands/text/result_text.hpp"
#include "math/units.hpp"
#include "subject/observable_noise.hpp"

namespace trunk {
namespace {

std::string estimate_line(const Estimate& p, const Profile* profile) {
  const auto range = [](double low, double high) {
    const bool knows_nothing = low > 0.0 && high > 1e4 * low;
    return !knows_nothing && (std::isfinite(low) || std::isfinite(high))
               ? fmt::format("{} to {}", shown(low, "{:.4g}"), shown(high, "{:.4g}"))
               : std::string("not known");
  };
  std::string text = fmt::format("  {:<26} {:>10}  {:>10}  {:>20}  {:>20}", p.name, shown(p.value, "{:.5g}"),
                                 shown(p.stderr_, "{:.3g}"), range(p.lower95, p.upper95),
                                 range(p.naive95.lower, p.naive95.upper));
  if (profile != nullptr)
    text += fmt::format("  {:>20}", range(profile->interval95.lower, profile->interval95.upper));
  return text + " " + (p.unit == "1" ? "" : p.unit) + (p.at_bound ? "  AT BOUND" : "") + "\n";
}

std::string estimates_table(const Estimation& e, bool withheld) {
  if (!e.uncertainty) return "";
  std::string text = fmt::format("  {:<26} {:>10}  {:>10}  {:>20}  {:>20}", "parameter", "estimate",
                                 "std error", "95 % interval", "(if independent)");
  const bool profiled = !e.profiles.empty() && !withheld;
  text += !profiled ? "\n" : fmt::format("  {:>20}\n", "(by profile)");
  for (std::size_t i = 0; i < e.uncertainty->parameters.size(); ++i)
    text += estimate_line(e.uncertainty->parameters[i], profiled ? &e.profiles[i] : nullptr);
  if (!e.uncertainty->ratio.name.empty()) text += estimate_line(e.uncertainty->ratio, nullptr);
  return text;
}

std::string origin_of(const SubjectFit& fit) {
  switch (fit.plan().timing) {
    case Timing::joint:
      return "estimated along with the parameters";
    case Timing::trace:
      return "from the trace";
    case Timing::scenario:
      break;
  }
  return "from the scenario";
}

/// Returns what was measured and how exactly, the priors on forces, and what each result rests on.
std::string scale_lines(const SubjectFit& fit, const FitOutcome& outcome) {
  if (fit.scale().empty()) return "";
  std::string text;
  for (const ObservableNoise& o : observable_noises(fit.measured_curve(), outcome.estimation))
    text += fmt::format("  {}: noise {:.2g} {}, as {:.0f} independent samples\n", o.name, o.noise,
                        o.unit == "1" ? "of full activation" : o.unit, o.effective_samples);
  for (const ScalePrior& p : fit.scale())
    text += fmt::format("  prior of {}: {:.3g} {}, factor {:.3g}; {}\n", p.name, p.mean,
                        p.unit == "1" ? "" : p.unit, p.factor, p.source);
  for (const FitResult& r : outcome.results.results)
    if (!r.shares.empty())
      text += fmt::format("  {} {} rests on: {}\n", title_of(r.name), interval_text(r), text_of(r.shares));
  return text;
}

/// Returns parameters, activation, joint region, bootstrap and search.
std::string details(const SubjectFit& fit, const FitOutcome& outcome) {
  const Estimation& e = outcome.estimation;
  const bool withheld = !outcome.results.gates.empty();
  std::string text = estimates_table(e, withheld);
  text += fmt::format(
      "  residual {:.2f} % of tidal volume (one-compartment model: {:.2f} %), tidal volume {:+.1f} ml, peak "
      "{:+.3f} s\n",
      100.0 * e.quality.nrmse, 100.0 * e.quality.baseline_nrmse, ml_per_m3 * e.quality.tidal_volume_error_m3,
      e.quality.peak_time_error_s);
  const auto& a = e.best.activation;
  text += fmt::format(
      "  activation: onset {:.2f} s, rise {:.2f} s, fast fall {:.2f} s to {:.2g}, slow fall {:.2f} s ({})\n",
      a.onset_s, a.rise_s, a.fast_fall_s, a.fast_fall_level, a.slow_fall_s, origin_of(fit));
  if (e.surface && !withheld)
    text += fmt::format("  joint 95 % region: {} {:.4g} to {:.4g}, {} {:.4g} to {:.4g}{}\n",
                        e.surface->names[0], e.surface->region95[0].lower, e.surface->region95[0].upper,
                        e.surface->names[1], e.surface->region95[1].lower, e.surface->region95[1].upper,
                        e.surface->closed ? "" : " (reaches the edge of the grid)");
  if (e.bootstrap && !withheld) {
    text += fmt::format("  95 % by {} bootstrap repeats (blocks of {} samples):", e.bootstrap->repeats,
                        e.bootstrap->block);
    for (std::size_t i = 0; i < e.bootstrap->interval95.size(); ++i)
      text += fmt::format("{} {} {:.4g} to {:.4g}", i > 0 ? "," : "", e.uncertainty->parameters[i].name,
                          e.bootstrap->interval95[i].lower, e.bootstrap->interval95[i].upper);
    text += "\n";
  }
  text += scale_lines(fit, outcome);
  if (e.cross_check)
    text +=
        fmt::format("  {} and {} {} ({:.2g} % apart)\n", e.cross_check->first, e.cross_check->second,
                    e.cross_check->agree ? "agree" : "DISAGREE", 100.0 * e.cross_check->largest_difference());
  return text + fmt::format("  {} simulations of the trunk{}, {} failed; {}\n", e.simulations,
                            outcome.replayed > 0 ? fmt::format(" ({} found from an interrupted run)",
                                                               e.evaluations.size() - e.simulated)
                                                 : "",
                            e.failures, e.search.stop_reason);
}

}  // namespace

std::string fit_table(const SubjectFit& fit, const FitOutcome& outcome, bool detailed) {
  const FitResults& results = outcome.results;
  std::string text;
  if (const auto& breath = fit.measurement().breath)
    text += fmt::format("{} breaths used, {} rejected; tidal volume {:.0f} ml, {:.2f} s a breath\n",
                        breath->breaths_used, breath->breaths_rejected, ml_per_m3 * breath->tidal_volume_m3,
                        breath->duration_s);
  text += results_table(results);
  text += clinic_lines(outcome.clinic);
  if (detailed) text += details(fit, outcome);
  return text + breaths_table(outcome.breaths) + predictions_table(outcome.predictions, detailed) +
         verdict_text(results);
}

}  // namespace trunk
