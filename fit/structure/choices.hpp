#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "results/records.hpp"
#include "scenarios/read_scenario.hpp"

namespace trunk {

/// A choice of the model that no measurement of the subject settles. It is made by keys of the scenario, and
/// every value of its range is as plausible as any other (our choice).
struct Choice {
  std::string_view name;
  std::vector<std::string_view> keys;  // they change together
  /// The range goes from a scenario's own value over this factor to the value times this factor. 0: the other
  /// one of two values is as plausible as the scenario's own.
  double factor;
  bool of_template;         // a trunk from a file has no such choice
  std::string_view source;  // of the range

  bool is_one_of_two() const noexcept { return factor == 0.0; }
};

/// Returns the table of all choices.
std::span<const Choice> declared_choices();

/// Moves the keys of a choice: to the lower end of the range at -1, to the upper end at 1, not at all at 0.
/// Of one of two values, 1 is the other. A key stays within its limits. => scenario
void make_choice(const Choice& choice, double place, Scenario& scenario);

/// Returns why a choice makes no difference in a scenario, in a sentence; "" if it makes one.
std::string why_left_out(const Choice& choice, const Scenario& scenario);

/// Returns the choice with its range in this scenario, in the unit of its first key.
Structure::Choice declared_range(const Choice& choice, const Scenario& scenario);

}  // namespace trunk
