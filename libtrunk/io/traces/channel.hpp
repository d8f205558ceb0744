#pragma once

#include <string>
#include <vector>

namespace trunk {

/// What a channel beside the breathing signal measures. Transdiaphragmatic pressure is gastric minus pleural
/// pressure. The excursion is the descent of a dome of the diaphragm.
enum class ChannelKind { pleural, gastric, transdiaphragmatic, airway, excursion, emg };

/// A channel of a trace, on the times of the breathing signal.
struct TraceChannel {
  ChannelKind kind = ChannelKind::pleural;
  std::string column;              ///< name in the file, for messages
  std::string unit;                ///< that the values had in the file: "cmH2O", "kPa", "mm"; or ""
  std::vector<double> value;       ///< [samples] Pa as measured, m (descent positive); an EMG as in the file
  std::vector<std::string> notes;  ///< messages for the user about this channel
};

}  // namespace trunk
