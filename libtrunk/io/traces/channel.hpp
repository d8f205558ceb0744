#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trunk {

/// What a channel beside the breathing signal measures. Transdiaphragmatic pressure is gastric minus pleural
/// pressure. The excursion is the descent of a dome of the diaphragm.
enum class ChannelKind { pleural, gastric, transdiaphragmatic, airway, excursion, emg };

/// Returns the option that chooses a channel, without its dashes ("poes"), and what it measures in words.
std::string_view option_of(ChannelKind kind);
std::string_view words_of(ChannelKind kind);
inline bool is_pressure(ChannelKind kind) {
  return kind != ChannelKind::excursion && kind != ChannelKind::emg;
}

/// A channel of a trace, on the times of the breathing signal.
struct TraceChannel {
  ChannelKind kind = ChannelKind::pleural;
  std::string column;         ///< name in the file, for messages
  std::string unit;           ///< that the values had in the file: "cmH2O", "kPa", "mm"; or ""
  std::vector<double> value;  ///< [samples] Pa as measured, m (descent positive), an EMG as in the file; NaN
                              ///< in a gap
};

/// The user's choice of channels. A column is given as in TraceOptions; "none" leaves the channel out.
struct ChannelOptions {
  std::string poes, pga, pdi, paw;    ///< empty: by an unmistakable name
  std::string emg, excursion;         ///< empty: none; a number is an excursion in mm
  std::string pressure_unit;          ///< of all pressures, "kPa"; empty: as in the file
  std::vector<std::string> inverted;  ///< channels whose sign is turned, by their options: "poes"
};

}  // namespace trunk
