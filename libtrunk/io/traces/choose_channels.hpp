#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "traces/channel.hpp"
#include "traces/find_column.hpp"

namespace trunk {

/// A column of a recording that holds a channel.
struct ChannelColumn {
  ChannelKind kind;
  std::size_t column;
  std::string unit;        ///< "cmH2O"; "" of an EMG without one
  double to_si = 1;        ///< factor to Pa or m, negative if the sign is turned
  bool by_option = false;  ///< the user named the column
};

/// The channels of a recording beside its signal.
struct ChosenChannels {
  std::vector<ChannelColumn> columns;   ///< at most one of each kind
  std::optional<double> excursion_m{};  ///< if it is one number
  std::vector<std::string> notes;       ///< messages about the choice
};

/// Chooses the channels of a recording of which `columns` are the names and `signal` is the breathing signal.
///
/// Without an option, pressures are taken if their name without the unit is poes, pes, pga, pgas, pdi or paw
/// (also p_oes, "P es" and so on), and a note says so; of two such columns neither is taken. The unit is that
/// of the option, of the header, or else cmH2O for a pressure and mm for an excursion, which a note reports.
///
/// Throws InputErrors if a named column is missing, is the signal or the time, has a wrong unit, or differs
/// from the signal in rate or length; a column that is taken by its name is then left out, with a note.
ChosenChannels choose_channels(const Recording& recording, const std::vector<ColumnName>& columns,
                               std::size_t signal, std::optional<std::size_t> time,
                               const ChannelOptions& options);

}  // namespace trunk
