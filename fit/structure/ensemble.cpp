#include "structure/ensemble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "linear_algebra/decompositions.hpp"
#include "search/multistart.hpp"
#include "structure/coarse_breath.hpp"
#include "structure/mixture.hpp"
#include "structure/trials.hpp"

namespace trunk {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// A choice at both ends of its range; of one of two, only `high` is tried.
struct Ends {
  const Choice* choice;
  Tried low, high;

  /// Returns the effect on what `of` takes from a trunk.
  template <class Of>
  Effect effect(const Tried& unchanged, const Of& of) const {
    const auto change = [&](const Tried& t) { return t.error.empty() ? of(t) - of(unchanged) : unknown; };
    const bool two = choice->is_one_of_two();
    return {two ? 0.0 : change(low), change(high), two};
  }
};

/// Trunks that differ in several choices at once.
struct Combinations {
  std::vector<const Choice*> choices;
  std::vector<Eigen::VectorXd> places;  // [trunks][choices]
  std::vector<Tried> tried;             // [trunks]
};

std::vector<Ends> tried_ends(const std::vector<const Choice*>& choices, const Trials& trials,
                             double muscle_guess, const Execution& execution) {
  std::vector<Placed> placed;
  for (auto c = choices.rbegin(); c != choices.rend(); ++c) {  // the finer mesh is last, and takes longest
    placed.push_back({{{*c, 1.0}}, muscle_guess});
    if (!(*c)->is_one_of_two()) placed.push_back({{{*c, -1.0}}, muscle_guess});
  }
  std::vector<Ends> all;
  for (const Choice* c : choices) all.push_back({c, {}, {}});
  std::vector<Tried> results = trials.tried(placed, execution);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Choice* choice = placed[i].choices.front().first;
    Ends& ends = *std::find_if(all.begin(), all.end(), [&](const Ends& e) { return e.choice == choice; });
    (placed[i].choices.front().second > 0.0 ? ends.high : ends.low) = std::move(results[i]);
  }
  return all;
}

Combinations tried_combinations(const std::vector<Ends>& ends, const Trials& trials,
                                const Execution& execution) {
  constexpr unsigned seed = 2;
  Combinations c;
  std::vector<Effect> on_muscle;  // on ln k_muscle: it tells where a refit begins
  for (const Ends& e : ends) {
    if (e.choice->is_one_of_two()) continue;
    c.choices.push_back(e.choice);
    on_muscle.push_back(e.effect(trials.unchanged(), [](const Tried& t) { return std::log(t.k_muscle); }));
  }
  const std::size_t n = c.choices.size(), pairs = n * (n - 1) / 2;
  if (n < 2) return c;
  const auto size = static_cast<Eigen::Index>(n);
  const LeastSquares cube{{}, Eigen::VectorXd::Constant(size, -1.0), Eigen::VectorXd::Ones(size)};
  c.places = sobol_starts(cube, pairs + 6, seed);
  std::vector<Placed> placed;
  for (const Eigen::VectorXd& place : c.places) {
    Placed p;
    double log_muscle = std::log(trials.unchanged().k_muscle);
    for (std::size_t i = 0; i < n; ++i) {
      p.choices.emplace_back(c.choices[i], place[static_cast<Eigen::Index>(i)]);
      log_muscle += on_muscle[i].at(p.choices.back().second);
    }
    p.muscle_guess = std::exp(log_muscle);
    placed.push_back(std::move(p));
  }
  c.tried = trials.tried(placed, execution);
  return c;
}

/// One of the other scenarios: what changes its numbers.
class OtherStructure {
 public:
  OtherStructure(std::size_t number, const Scenario& scenario, const std::vector<Ends>& ends,
                 const Combinations& combinations, const Tried& unchanged)
      : number_(number), combinations_(combinations), unchanged_(unchanged) {
    for (const Ends& e : ends) {
      if (!why_left_out(*e.choice, scenario).empty()) continue;
      mine_.push_back(&e);
      structure_.choices.push_back(declared_range(*e.choice, scenario));
      for (const Tried* t : {&e.low, &e.high})
        if (!t->error.empty())
          structure_.left_out.push_back(
              fmt::format("no number has a structural interval, because a trunk with another {} could not be "
                          "simulated: {}",
                          e.choice->name, t->error));
    }
    solve_pairs();
  }

  /// Adds intervals to the numbers, and returns what they consist of. => numbers
  Structure intervals(std::vector<Predicted>& numbers) && {
    for (std::size_t m = 0; m < numbers.size(); ++m) {
      Predicted& p = numbers[m];
      const std::vector<Effect> effects = effects_on(m);
      Mixture mixture = mixture_of(effects, crossings_of(m, effects));
      // A change that is smaller than what a refit may be off says nothing of shares.
      if (!(mixture.upper95 - mixture.lower95 > 5.0 * muscle_accuracy * std::abs(p.value)))
        std::fill(mixture.shares.begin(), mixture.shares.end(), unknown);
      p.structural_lower95 = p.value + mixture.lower95;
      p.structural_upper95 = p.value + mixture.upper95;
      structure_.measures.push_back(p.name);
      structure_.shares.insert(structure_.shares.end(), mixture.shares.begin(), mixture.shares.end());
    }
    return std::move(structure_);
  }

 private:
  /// Finds the pairs of choices of this scenario, and the matrix that takes what effects alone leave over in
  /// the combinations to the bends of the pairs, by least squares.
  void solve_pairs() {
    std::vector<std::size_t> column;  // [mine_] in the combinations
    for (const Ends* e : mine_)
      column.push_back(static_cast<std::size_t>(
          std::find(combinations_.choices.begin(), combinations_.choices.end(), e->choice) -
          combinations_.choices.begin()));
    for (std::size_t i = 0; i < mine_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (!mine_[i]->choice->is_one_of_two() && !mine_[j]->choice->is_one_of_two())
          pairs_.push_back({j, i, 0.0});
    for (std::size_t t = 0; t < combinations_.tried.size(); ++t)
      if (combinations_.tried[t].error.empty()) completed_.push_back(t);
    if (const std::size_t lost = combinations_.tried.size() - completed_.size(); lost > 0 && !pairs_.empty())
      structure_.left_out.push_back(fmt::format("{} of {} combinations of choices could not be simulated",
                                                lost, combinations_.tried.size()));
    if (pairs_.empty() || completed_.size() <= pairs_.size()) return;
    const auto index = [](std::size_t i) { return static_cast<Eigen::Index>(i); };
    Eigen::MatrixXd products(index(completed_.size()), index(pairs_.size()));
    place_.resize(products.rows(), index(mine_.size()));
    for (Eigen::Index t = 0; t < place_.rows(); ++t) {
      const Eigen::VectorXd& at = combinations_.places[completed_[static_cast<std::size_t>(t)]];
      for (std::size_t i = 0; i < mine_.size(); ++i)
        place_(t, index(i)) = mine_[i]->choice->is_one_of_two() ? -1.0 : at[index(column[i])];
      for (std::size_t p = 0; p < pairs_.size(); ++p)
        products(t, index(p)) = place_(t, index(pairs_[p].first)) * place_(t, index(pairs_[p].second));
    }
    solved_ = pseudo_inverse(products);
  }

  double number(const Tried& t, std::size_t m) const { return t.numbers[number_][m]; }

  std::vector<Effect> effects_on(std::size_t m) const {
    std::vector<Effect> effects;
    for (const Ends* e : mine_)
      effects.push_back(e->effect(unchanged_, [&](const Tried& t) { return number(t, m); }));
    return effects;
  }

  std::vector<Crossing> crossings_of(std::size_t m, const std::vector<Effect>& effects) const {
    if (solved_.size() == 0) return {};
    Eigen::VectorXd left(place_.rows());
    for (Eigen::Index t = 0; t < left.size(); ++t) {
      left[t] =
          number(combinations_.tried[completed_[static_cast<std::size_t>(t)]], m) - number(unchanged_, m);
      for (std::size_t i = 0; i < effects.size(); ++i)
        left[t] -= effects[i].at(place_(t, static_cast<Eigen::Index>(i)));
    }
    std::vector<Crossing> crossings = pairs_;
    const Eigen::VectorXd bends = solved_ * left;
    for (std::size_t p = 0; p < crossings.size(); ++p)
      crossings[p].bend = bends[static_cast<Eigen::Index>(p)];
    return crossings;
  }

  std::size_t number_;
  const Combinations& combinations_;
  const Tried& unchanged_;
  std::vector<const Ends*> mine_;
  std::vector<Crossing> pairs_;         // without bends
  std::vector<std::size_t> completed_;  // combinations
  Eigen::MatrixXd place_;               // [completed][mine]
  Eigen::MatrixXd solved_;              // [pairs][completed]; empty if there are too few combinations
  Structure structure_;
};

}  // namespace

std::vector<Structure> add_structural_intervals(const Scenario& own, const std::vector<Scenario>& others,
                                                std::span<const Choice> choices, const Execution& execution,
                                                const std::vector<std::vector<Predicted>*>& numbers) {
  std::vector<Structure> structures(others.size());
  const Trials trials(own, others);
  if (const std::string& error = trials.unchanged().error; !error.empty()) {
    for (Structure& s : structures) s.left_out = {"no choice of the model could be tried: " + error};
    return structures;
  }
  const auto why = [&](const Choice& c, const Scenario& other) {
    return why_left_out(c, c.of_template && own.mesh ? own : other);
  };
  std::vector<const Choice*> active;
  for (const Choice& c : choices)
    if (std::any_of(others.begin(), others.end(), [&](const Scenario& s) { return why(c, s).empty(); }))
      active.push_back(&c);
  const std::vector<Ends> ends = tried_ends(active, trials, own.parameters.muscle, execution);
  const Combinations combinations = tried_combinations(ends, trials, execution);
  for (std::size_t k = 0; k < others.size(); ++k) {
    structures[k] =
        OtherStructure(k, others[k], ends, combinations, trials.unchanged()).intervals(*numbers[k]);
    for (const Choice& c : choices)
      if (const std::string reason = why(c, others[k]); !reason.empty())
        structures[k].left_out.push_back(reason);
  }
  return structures;
}

}  // namespace trunk
