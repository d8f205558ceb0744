#include "subject/channel_curves.hpp"

#include <algorithm>

#include "anatomy/breath_run.hpp"
#include "linear_algebra/decompositions.hpp"
#include "math/units.hpp"
#include "subject/observable_noise.hpp"

namespace trunk {
namespace {

std::string name_of(ChannelKind kind) {
  if (kind == ChannelKind::excursion) return "excursion";
  if (kind == ChannelKind::emg) return "emg";
  std::string name(words_of(kind));
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

std::vector<double> times(std::vector<double> values, double factor) {
  for (double& v : values) v *= factor;
  return values;
}

/// Returns how far the model is from a measured channel once it has what the channel may have beside it; none
/// for an EMG that falls as the activation rises. `simulated`: what the model says of the block.
std::optional<Eigen::VectorXd> residual_of(const MeasuredCurve& measured, std::size_t block,
                                           const Eigen::VectorXd& simulated) {
  const MeasuredObservable& channel = measured.beside[block - 1];
  const bool emg = channel.kind == ChannelKind::emg;
  const Eigen::VectorXd off = emg ? simulated : Eigen::VectorXd(simulated - mapped(channel.value));
  const Eigen::MatrixXd courses = nuisance_of(measured, block);
  const Eigen::VectorXd beside = pseudo_inverse(courses) * off;
  const Eigen::VectorXd left = off - courses * beside;
  if (!emg) return left;
  constexpr Eigen::Index gain = 1;  // its column in nuisance_of: activation per unit of the EMG
  if (!(beside[gain] > 0.0)) return std::nullopt;
  return Eigen::VectorXd(left / beside[gain]);
}

/// Returns the channels that a model is compared with, as if a fit followed all of them.
MeasuredCurve followed(const MeasuredBreath& breath) {
  MeasuredCurve curve{breath.time_s, breath.volume_m3, {}, {}};
  for (const MeasuredChannel& c : breath.channels)
    if (c.kind != ChannelKind::airway) curve.beside.push_back({c.kind, c.value, 1.0});
  return curve;
}

}  // namespace

std::vector<FitRecord::Channel> channel_curves(const SubjectFit& fit, const Estimation& e) {
  const auto& breath = fit.measurement().breath;
  if (!breath || breath->channels.empty()) return {};
  const Scenario best = fit.fitted(e).scenario;
  const VolumeCurve curves = simulate_volume(fit.trunk(), best.parameters, best.activation, best.time);
  const MeasuredCurve measured = followed(*breath);
  const std::vector<Block> blocks = blocks_of(measured);
  Eigen::VectorXd simulated;
  if (curves.ending.completed() && !measured.beside.empty()) {
    SeenBreath at_times = seen(measured, curves, best.time.dt_s);
    at_times.activation = activation_at(measured, best.activation, best.time);
    simulated = as_measured(measured, at_times, at_times);
  }
  std::vector<FitRecord::Channel> all;
  std::size_t block = 1;
  for (const MeasuredChannel& c : breath->channels) {
    const ShownUnit unit = shown_unit(c.kind);
    FitRecord::Channel& shown = all.emplace_back(FitRecord::Channel{name_of(c.kind),
                                                                    unit.name,
                                                                    std::string(words_of(c.kind)),
                                                                    times(c.value, unit.per_si),
                                                                    times(c.sigma, unit.per_si),
                                                                    {}});
    if (c.kind == ChannelKind::airway) {
      for (const double t : breath->time_s)
        shown.model.push_back(unit.per_si * (best.pleura.airway_pressure(t) - c.end_expiratory));
      continue;
    }
    const Block& b = blocks[block++];
    if (simulated.size() == 0) continue;
    const auto left = residual_of(measured, block - 1, simulated.segment(b.first, b.count));
    for (Eigen::Index i = 0; left && i < left->size(); ++i)
      shown.model.push_back(shown.measured[static_cast<std::size_t>(i)] + unit.per_si * (*left)[i]);
  }
  return all;
}

}  // namespace trunk
