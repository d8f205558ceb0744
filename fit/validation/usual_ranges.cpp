#include "validation/usual_ranges.hpp"

namespace trunk {
namespace {

using Breath = ValidatedBreath;

constexpr UsualRange usual[] = {
    {"gastric_swing_cmH2O", "gastric", "cmH2O", 3.0, 4.0,
     "our choice; 3.7 (SD 1.1) when a ventilator gives 0.6 L to patients (a study of the prone posture, Eur "
     "Respir J)",
     &Breath::gastric_swing_cmH2O},
    {"pleural_swing_cmH2O", "pleural", "cmH2O", -5.0, -3.0,
     "our choice; textbooks let the pleural pressure fall from -5 to -8 (West, Respiratory Physiology)",
     &Breath::pleural_swing_cmH2O},
    {"transdiaphragmatic_swing_cmH2O", "transdiaphragmatic", "cmH2O", 6.0, 9.0,
     "the gastric swing less the pleural one", &Breath::transdiaphragmatic_swing_cmH2O},
    {"recoil_time_s", "recoil time", "s", 0.3, 0.4,
     "our choice; a resistance of 3.1 to 4.4 cmH2O s/L over an elastance of 7.1 to 12.1 cmH2O/L (Am Rev "
     "Respir Dis 1991;143:240)",
     &Breath::recoil_time_s}};

}  // namespace

std::span<const UsualRange> usual_ranges() {
  return usual;
}

}  // namespace trunk
