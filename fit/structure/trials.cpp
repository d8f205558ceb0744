#include "structure/trials.hpp"

#include <cmath>
#include <numeric>
#include <stdexcept>

#include "math/units.hpp"
#include "parallel/workers.hpp"
#include "records/run_record.hpp"
#include "structure/coarse_breath.hpp"

namespace trunk {
namespace {

Scenario moved(Scenario scenario, const Placed& placed) {
  for (const auto& [choice, place] : placed.choices) make_choice(*choice, place, scenario);
  return scenario;
}

BreathSummary completed(BreathSummary breath) {
  if (!breath.ending.completed()) throw std::runtime_error(breath.ending.message);
  return breath;
}

}  // namespace

Trials::Trials(const Scenario& own, const std::vector<Scenario>& others) : own_(own), others_(others) {
  const double k_muscle = own.parameters.muscle;
  try {
    own_recoil_ = recoil_for_choices(own);
    for (const Scenario& other : others) recoils_.push_back(recoil_for_choices(other));
    tidal_volume_m3_ = completed(CoarseTrunk(own, own_recoil_).breath(k_muscle)).measures.delta_v;
    unchanged_ = one({{}, k_muscle});
  } catch (const std::exception& error) {
    unchanged_.error = error.what();
  }
}

double Trials::refitted_muscle(const Placed& placed) const {
  if (placed.choices.empty() || own_.parameters.muscle == 0.0) return own_.parameters.muscle;
  const double found =
      muscle_for(CoarseTrunk(moved(own_, placed), own_recoil_), tidal_volume_m3_, placed.muscle_guess);
  if (!std::isfinite(found)) throw std::runtime_error("no strength of the muscle keeps the tidal volume");
  return found;
}

Tried Trials::one(const Placed& placed) const try {
  Tried tried{refitted_muscle(placed), {}, ""};
  for (std::size_t k = 0; k < others_.size(); ++k) {
    const CoarseTrunk trunk(moved(others_[k], placed), recoils_[k]);
    const BreathSummary breath = completed(trunk.breath(tried.k_muscle));
    std::vector<double>& numbers = tried.numbers.emplace_back();
    for (const NamedValue& v : measures_of(breath)) numbers.push_back(v.value);
    numbers.push_back(ml_per_m3 * tidal_volume_m3_);
    numbers.push_back(100.0 * breath.measures.delta_v / tidal_volume_m3_);
  }
  return tried;
} catch (const std::exception& error) {
  return {0.0, {}, error.what()};
}

std::vector<Tried> Trials::tried(const std::vector<Placed>& all, const Execution& execution) const {
  std::vector<std::size_t> items(all.size());
  std::iota(items.begin(), items.end(), std::size_t{0});
  std::vector<Tried> results(all.size());
  const auto cancelled = [&] { return execution.cancelled && execution.cancelled(); };
  using Part = std::pair<std::size_t, Tried>;
  work_off<Part>(
      items, execution.threads, cancelled,
      [&](std::size_t i) {
        return Part{i, one(all[i])};
      },
      [&](Part part) { results[part.first] = std::move(part.second); });
  if (cancelled()) throw Cancelled();
  return results;
}

}  // namespace trunk
