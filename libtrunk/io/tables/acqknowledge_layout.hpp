#pragma once

#include "tables/table_layout.hpp"

namespace trunk {

/// Returns whether a text begins as AcqKnowledge (BIOPAC) writes it: with the sampling rate ("10
/// msec/sample", "100 samples/sec") among the first lines, and "2 channels" below it.
bool is_acqknowledge(TextLines lines);

/// Finds the parts of a text that is_acqknowledge. After the number of channels come two lines for each, its
/// name and its unit; a row of short names (min, CH1, CH2), and a row with the number of samples of each
/// channel. Neither row is there in every export.
///
/// The rate gives the times. A column of times is kept under a name that nothing takes by itself, since it
/// has six digits: too few after a quarter of an hour (our choice). A note says if the number of samples
/// differs from that of the rows.
TableLayout acqknowledge_layout(const TextLines& lines);

}  // namespace trunk
