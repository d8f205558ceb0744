#pragma once

#include "prediction/predicted.hpp"
#include "problem/trunk_model.hpp"
#include "structure/choices.hpp"

namespace trunk {

/// Adds structural intervals to numbers of scenarios, and returns for each scenario what they consist of.
///
/// A structural interval says how far a number may be off because the model had to be chosen, however well
/// its parameters are known. Each choice that makes a difference goes to both ends of its range, alone; then
/// some combinations of all ranges show what two choices do together (a Sobol sequence, six more than
/// there are pairs). k_muscle is refitted each time, so that the subject's own scenario keeps
/// its tidal volume: that is what was measured. With it the other scenario is simulated. All changes are
/// taken between breaths of the same coarse steps (see CoarseTrunk), put together by mixture_of, and added to
/// the number's value. A choice of one of two values is not combined with others (our choice: a finer mesh is
/// slow).
///
/// `own` is the scenario in which the subject was measured, with the best parameters. `numbers` of each other
/// scenario are the measures, and then own_delta_v_ml and ratio_percent if they are there. If a trunk cannot
/// be simulated, the interval is unknown, and `left_out` says so. Throws Cancelled. => numbers
std::vector<Structure> add_structural_intervals(const Scenario& own, const std::vector<Scenario>& others,
                                                std::span<const Choice> choices, const Execution& execution,
                                                const std::vector<std::vector<Predicted>*>& numbers);

}  // namespace trunk
