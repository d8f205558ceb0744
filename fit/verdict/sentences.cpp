#include "verdict/sentences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "verdict/reasons.hpp"

namespace trunk {
namespace {

struct Meaning {
  std::string_view name, text;
};

constexpr std::array meanings = {
    Meaning{"r_ei", "how strongly the muscle pulls against the recoil at the end of inspiration"},
    Meaning{"recoil_time_s", "the time in which a relaxed trunk loses 63 % of its volume"},
    Meaning{"k_muscle_over_k_elasticity", "the stiffness of a fully active fibre over that of the tissue"},
    Meaning{"k_elasticity", "the stiffness of the tissue"},
    Meaning{"k_muscle", "the stiffness of a fully active fibre"},
    Meaning{"abdominal_elastance_cmH2O_per_L", "the abdominal pressure that a litre makes"},
    Meaning{"lung_elastance_cmH2O_per_L", "the pressure with which a litre makes the lung recoil"},
    Meaning{"respiratory_elastance_cmH2O_per_L",
            "the pressure with which a litre makes lung and chest recoil"},
    Meaning{"resistance_cmH2O_s_per_L", "the pressure that a flow through airway and lung takes"},
    Meaning{"intrinsic_peep_cmH2O", "the recoil pressure that is left when the next breath begins"},
    Meaning{"gastric_swing_cmH2O", "the largest change of abdominal pressure in a breath"},
    Meaning{"pleural_swing_cmH2O", "the largest change of pleural pressure in a breath"},
    Meaning{"transdiaphragmatic_swing_cmH2O", "the largest change of the pressure across the diaphragm"},
    Meaning{"excursion_right_mm", "how far the right dome descends"},
    Meaning{"excursion_left_mm", "how far the left dome descends"},
    Meaning{"delta_l_mm", "how much the zone of apposition shortens"},
    Meaning{"delta_h_mm", "how much the dome flattens"},
    Meaning{"end_expiratory_above_relaxation_ml",
            "the volume that has not left the lung when the next breath begins"}};

/// Returns what a reader might do about a grade.
std::string advice(const FitResults& results) {
  const FitResult* recoil = results.find("recoil_time_s");
  if (!results.gates.empty() || recoil == nullptr) return "";
  if (recoil->grade == Grade::not_determined)
    return " A longer expiration, a pause before the next breath, or more breaths would help.";
  return " A measured pressure would replace the assumption.";
}

/// Returns the name of a result without its unit and in words; parameters keep their names.
std::string in_words(std::string name) {
  if (name == "excursion_right_mm") return "excursion of the right dome";
  if (name == "excursion_left_mm") return "excursion of the left dome";
  for (const std::string_view unit : {"_cmH2O_per_L", "_cmH2O_s_per_L", "_cmH2O", "_mm", "_ml", "_s"})
    if (name.ends_with(unit)) {
      name.erase(name.size() - unit.size());
      break;
    }
  if (!name.starts_with("k_")) std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

/// Returns names as a list in a sentence: a, b and c.
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

/// Returns which of the headline results the recording determines, and what the others stand on.
std::string sentence_of_forces(const FitResults& results) {
  std::vector<std::string> determined, assumed;
  for (const std::string& name : results.headline) {
    const FitResult& r = *results.find(name);
    if (r.grade == Grade::not_determined)
      return fmt::format("This recording determines nothing: {}.", r.reason);
    (r.grade == Grade::determined ? determined : assumed).push_back(in_words(name));
  }
  std::string text;
  if (!determined.empty()) text = fmt::format("This recording determines {}.", listed(determined));
  if (assumed.empty()) return text;
  return text + fmt::format("{}The intervals of {} rest on the assumptions that stand with them.",
                            text.empty() ? "" : " ", listed(assumed));
}

/// Returns assumptions, which semicolons separate, as one clause.
std::string joined_by_and(std::string assumptions) {
  for (std::size_t at; (at = assumptions.find("; ")) != std::string::npos;)
    assumptions.replace(at, 2, " and ");
  return assumptions;
}

}  // namespace

std::string meaning_of(std::string_view result) {
  for (const Meaning& m : meanings)
    if (m.name == result) return std::string(m.text);
  return "";
}

std::string value_text(const FitResult& r) {
  if (!std::isfinite(r.value)) return "withheld";
  const std::string unit = r.unit == "1" ? "" : " " + r.unit;
  if (!std::isfinite(r.lower95) && !std::isfinite(r.upper95)) return fmt::format("{:.3g}{}", r.value, unit);
  if (!std::isfinite(r.upper95))
    return fmt::format("{:.3g}{} (at least {:.3g}{})", r.value, unit, r.lower95, unit);
  return fmt::format("{:.3g}{} ({:.3g} to {:.3g})", r.value, unit, r.lower95, r.upper95);
}

std::string verdict_sentence(const FitResults& results, const FitEvidence& evidence) {
  if (!results.gates.empty()) return results.gates.front().sentence;
  if (results.grade == Grade::not_converged) {
    const bool ended = evidence.estimation.search.converged;
    return fmt::format(
        "{}, so no result can be trusted. Other starts (--starts 30) or another algorithm may help.",
        ended ? "Two methods of search find different results" : "The search did not end");
  }
  if (evidence.problem.measured.is_tidal_volume())
    return "One tidal volume gives k_muscle for a trunk and an activation as in the scenario, and it does "
           "not "
           "show how exactly. A trace would.";
  if (pressure_measured(evidence)) return sentence_of_forces(results) + caveat(evidence.estimation.quality);
  const FitResult* recoil = results.find("recoil_time_s");
  const FitResult* inspiration = results.find("r_ei");
  if (recoil == nullptr || inspiration == nullptr) return "";
  std::string text;
  if (inspiration->grade == Grade::determined)
    text = fmt::format("This trace determines the muscle against the recoil at the end of inspiration, {}.",
                       value_text(*inspiration));
  else if (inspiration->grade == Grade::not_determined)
    text = fmt::format("This trace determines nothing: {}.", inspiration->reason);
  else
    text = "A volume trace alone determines no parameter of this breath.";
  if (recoil->grade == Grade::not_determined && recoil->reason != inspiration->reason)
    text += fmt::format(" The recoil time and all that goes with it are not determined: {}.", recoil->reason);
  else if (recoil->grade == Grade::assumption)
    text +=
        fmt::format(" If {}, the recoil time is {}.", joined_by_and(recoil->assumption), value_text(*recoil));
  return text + advice(results) + caveat(evidence.estimation.quality);
}

}  // namespace trunk
