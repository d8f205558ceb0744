#include "uncertainty/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "uncertainty/uncertainty.hpp"

namespace trunk {
namespace {

/// Returns "k = 4000 N/m within 3 %", or the interval if it is wider than a percentage can tell. At a bound,
/// and if the profile is open, the interval of the linear model means nothing and is left out.
std::string with_interval(const Estimate& e) {
  const std::string unit = e.unit == "1" ? "" : " " + e.unit;
  if (e.at_bound) return fmt::format("{} (stopped at its bound, {:.3g}{})", e.name, e.value, unit);
  if (e.open_profile) {
    const auto& [low, high] = *e.open_profile;
    if (std::isfinite(low))
      return fmt::format("{} (at least {:.3g}{}, no upper limit found)", e.name, low, unit);
    if (std::isfinite(high))
      return fmt::format("{} (at most {:.3g}{}, no lower limit found)", e.name, high, unit);
    return e.name + " (no limit found on either side)";
  }
  const double percent = 100.0 * (e.upper95 / e.value - 1.0);
  if (!(e.lower95 > 0.0))
    return fmt::format("{} = {:.3g}{} within {:.2g}", e.name, e.value, unit, e.upper95 - e.value);
  if (percent < 50.0) return fmt::format("{} = {:.4g}{} within {:.2g} %", e.name, e.value, unit, percent);
  if (percent < 1000.0)
    return fmt::format("{} = {:.3g}{}, anywhere from {:.2g} to {:.2g}", e.name, e.value, unit, e.lower95,
                       e.upper95);
  return fmt::format("{} (uncertain by more than a factor of {})", e.name,
                     e.upper95 / e.value > 1000.0 ? "1000" : "10");
}

bool is_knot(const Estimate& e) {
  return e.name.starts_with("shape_");
}

/// Returns a product of powers, "k_elasticity^-0.52 damping", without powers near 0.
std::string product(const Combination& c, const std::vector<Estimate>& parameters) {
  std::string text;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (std::abs(c.powers[i]) < 0.05) continue;
    text += text.empty() ? "" : " ";
    text += parameters[i].name;
    if (std::abs(c.powers[i] - 1.0) > 0.05) text += fmt::format("^{:.2g}", c.powers[i]);
  }
  return text;
}

struct Sentences {
  std::string determined, open;
  int knots = 0, known_knots = 0;

  static void add(std::string& list, const std::string& item) { list += (list.empty() ? "" : "; ") + item; }
};

Sentences sorted(const Uncertainty& u, bool ratio_matters) {
  Sentences s;
  if (ratio_matters) Sentences::add(s.determined, with_interval(u.ratio));
  for (const Estimate& e : u.parameters) {
    if (is_knot(e)) {
      ++s.knots;
      s.known_knots += e.identifiable ? 1 : 0;
      continue;
    }
    const std::string text = with_interval(e);
    if (e.identifiable)
      Sentences::add(s.determined, text);
    else if (!(ratio_matters && e.name == "k_muscle"))
      Sentences::add(s.open, text);
  }
  if (s.known_knots > 0)
    Sentences::add(s.determined,
                   fmt::format("{} of {} heights of the activation's shape", s.known_knots, s.knots));
  if (s.known_knots < s.knots)
    Sentences::add(s.open,
                   fmt::format("{} of {} heights of the activation's shape, which follow their neighbours",
                               s.knots - s.known_knots, s.knots));
  return s;
}

/// Returns a sentence that names parameters known mostly from their prior, not from the trace (our choice:
/// the interval is more than half as wide as the prior).
std::string note_on_priors(const Uncertainty& u) {
  std::string names;
  for (const Estimate& e : u.parameters) {
    const double spread = std::log(e.upper95 / e.lower95) / (2.0 * 1.96);
    if (e.prior > 0.0 && e.lower95 > 0.0 && spread > 0.5 * e.prior)
      names += (names.empty() ? "" : ", ") + e.name;
  }
  return names.empty() ? ""
                       : " Most of what is known about " + names + " comes from --prior, not from the trace.";
}

std::string advice(const Uncertainty& u) {
  const bool recoil = std::any_of(u.parameters.begin(), u.parameters.end(), [](const Estimate& e) {
    return !e.identifiable && (e.name == "k_elasticity" || e.name == "damping");
  });
  return recoil
             ? " A longer undisturbed expiration, a deeper and a shallower breath, or a measured motion of "
               "the dome or the chest wall would help."
             : " More breaths, quieter breaths or fewer free parameters would help.";
}

}  // namespace

std::string verdict_of(const Uncertainty& u) {
  const bool ratio_matters = !u.identifiable && u.ratio.identifiable;
  const Sentences s = sorted(u, ratio_matters);
  const bool damping_free = std::any_of(u.parameters.begin(), u.parameters.end(),
                                        [](const Estimate& e) { return e.name == "damping"; });
  const bool given =
      std::any_of(u.parameters.begin(), u.parameters.end(), [](const Estimate& e) { return e.prior > 0.0; });
  if (s.open.empty())
    return fmt::format("This trace {}determines{}: {}.{}", given ? "with the given priors " : "",
                       damping_free ? "" : ", if the damping is as assumed", s.determined, note_on_priors(u));
  std::string text;
  if (ratio_matters)
    text = (u.parameters.size() == 2 ? "This trace determines only the ratio: " : "This trace determines: ") +
           s.determined + ". ";
  else if (!s.determined.empty())
    text = "This trace determines: " + s.determined + ". ";
  else if (!u.combinations.empty() && u.parameters.size() > 1 && u.combinations.front().relative_stderr < 0.5)
    text = fmt::format("This trace determines only a combination: {} to {:.2g} %. ",
                       product(u.combinations.front(), u.parameters),
                       100.0 * u.combinations.front().relative_stderr);
  return text + (text.empty() ? "This trace does not determine: " : "It does not determine: ") + s.open +
         "." + advice(u);
}

}  // namespace trunk
