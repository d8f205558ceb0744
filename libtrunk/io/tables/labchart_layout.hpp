#pragma once

#include <cstddef>

#include "tables/table_layout.hpp"

namespace trunk {

/// Returns whether a text begins as LabChart (ADInstruments) writes it: with lines such as "Interval=" and
/// "Range=", and among them "ChannelTitle=" or "ExcelDateTime=".
bool is_labchart(TextLines lines);

/// Finds the parts of one block of a text that is_labchart. A block is what was recorded between a start and
/// a stop of LabChart. Blocks are never joined, since time is missing between them or their settings differ
/// (our choice). `block` counts from 1; 0 takes the longest one, which a note says.
///
/// The names are those of ChannelTitle=, or else "Channel 1" and so on. The units are those of UnitName=, or
/// else in the names, or else of Range=. A column of times, in any unit that agrees with Interval=, or of
/// clock times, and one of dates may stand before the channels. Without times, Interval= gives the rate.
///
/// Throws InputError if there is no such block, or if neither times nor Interval= tell the rate.
TableLayout labchart_layout(const TextLines& lines, std::size_t block);

}  // namespace trunk
