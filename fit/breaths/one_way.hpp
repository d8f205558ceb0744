#pragma once

#include "breaths/segment.hpp"
#include "breaths/volume_signal.hpp"
#include "breaths/whole_breaths.hpp"

namespace trunk {

/// Throws InputError if a signal hardly comes back: in the median breath the volume falls by less than a
/// third of what it rises, or the other way round, or it drifts by 1.25 of a breath's size (our choice; steps
/// of 0.1 s). The error says whether it looks like a counter, a flow without its sign, a flow of one
/// direction, or an offset. If the user says that it is a drift, a note is added instead. A note
/// also tells of a volume that moves at one rate for 40 % of the time. => signal.notes
void check_both_ways(const Trace& trace, const WholeBreaths& breaths, VolumeSignal& signal);

/// Throws InputError if the median breath fills or empties from 10 to 90 % within 0.12 s, and in proportion
/// less if it is shorter than 2 s: no lung does, but a counter that is reset does, and a gas analyser (our
/// choice).
void check_not_abrupt(const Segmentation& segmentation);

}  // namespace trunk
