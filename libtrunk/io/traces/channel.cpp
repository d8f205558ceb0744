#include "traces/channel.hpp"

namespace trunk {

std::string_view option_of(ChannelKind kind) {
  switch (kind) {
    case ChannelKind::pleural:
      return "poes";
    case ChannelKind::gastric:
      return "pga";
    case ChannelKind::transdiaphragmatic:
      return "pdi";
    case ChannelKind::airway:
      return "paw";
    case ChannelKind::excursion:
      return "excursion";
    case ChannelKind::emg:
      break;
  }
  return "emg";
}

std::string_view words_of(ChannelKind kind) {
  switch (kind) {
    case ChannelKind::pleural:
      return "oesophageal pressure";
    case ChannelKind::gastric:
      return "gastric pressure";
    case ChannelKind::transdiaphragmatic:
      return "transdiaphragmatic pressure";
    case ChannelKind::airway:
      return "airway pressure";
    case ChannelKind::excursion:
      return "excursion of the diaphragm";
    case ChannelKind::emg:
      break;
  }
  return "EMG of the diaphragm";
}

}  // namespace trunk
