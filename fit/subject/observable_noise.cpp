#include "subject/observable_noise.hpp"

#include "math/units.hpp"

namespace trunk {

ShownUnit shown_unit(ChannelKind kind) {
  if (kind == ChannelKind::excursion) return {"mm", mm_per_m};
  if (kind == ChannelKind::emg) return {"1", 1.0};
  return {"cmH2O", 1.0 / Pa_per_cmH2O};
}

std::vector<ObservableNoise> observable_noises(const MeasuredCurve& measured, const Estimation& e) {
  std::vector<ObservableNoise> all;
  if (!e.local) return all;
  for (std::size_t b = 0; b < e.local->blocks.size(); ++b) {
    const Noise& noise = e.local->noises[b];
    const ShownUnit unit = b == 0 ? ShownUnit{"ml", ml_per_m3} : shown_unit(measured.beside[b - 1].kind);
    all.push_back({b == 0 ? "volume" : std::string(words_of(measured.beside[b - 1].kind)), unit.name,
                   unit.per_si * noise.deviation * e.local->deviations[b], noise.rho,
                   static_cast<double>(e.local->blocks[b].count) * (1.0 - noise.rho) / (1.0 + noise.rho)});
  }
  return all;
}

}  // namespace trunk
