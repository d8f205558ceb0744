#pragma once

#include "recordings/recording.hpp"
#include "traces/choose_columns.hpp"
#include "traces/trace.hpp"
#include "traces/used_samples.hpp"

namespace trunk {

/// Turns the signal if `inverted_by_user`, and holds a flow against the volume beside it, or a volume against
/// the flow.
///
/// A flow that runs against its volume (correlation below -0.5) is turned, unless the user turned it. A
/// volume that is late or early by 0.1 s or more, that does not go with the flow (below 0.5 at any lag), or
/// that rises by less than 0.8 or more than 1.25 of the flow's integral is told in a note. All our choice.
///
/// Throws InputError if that share is below 0.5 or above 2, as after a mistake of a unit, and the user has
/// not given the unit of the signal.
void check_other(Recording& recording, const TraceColumns& columns, const UsedSamples& used, Trace& trace);

}  // namespace trunk
