#pragma once

#include <cmath>

#include "compartment/compartment_breath.hpp"
#include "problem/measured_curve.hpp"
#include "problem/volume_model.hpp"

namespace trunk {

/// How the stiffness factor of the abdominal wall changes what a trunk is: powers of the factor over that at
/// which it was measured.
struct WallFactor {
  double measured_at = 1.0;
  double elastance = 0.0, gain = 0.0, abdominal = 0.0;  // powers; gain: of the pressure that a muscle makes

  double of(double power, const Parameters<double>& p) const {
    return power == 0.0 ? 1.0 : std::pow(p.abdomen_factor / measured_at, power);
  }
};

/// How a trunk breathes as one compartment. It is not quite one: the compartment that follows its volume best
/// has a time constant that depends on what may move along. With the timing held, that is 25.2 c/k on the
/// default trunk; with the timing free, 23.4, 23.3 and 22.7 c/k for three subjects of one resistance and
/// elastance, and 22.0 c/k for the trunk's own breath. The recoil time that is reported lies between (our
/// choice, made with these four in view): it was 2 to 4 % too long on all of them. A uniform error of 4 % to
/// either side is a part of its interval. The volume follows that of a compartment to about 0.2 % of the
/// tidal volume (see measure_recoil).
struct TrunkAsCompartment {
  double recoil = 0.0;      // time constant = recoil * damping / k_elasticity
  double gain_m3 = 0.0;     // gain of the compartment = gain * k_muscle / k_elasticity
  double held_m3 = 0.0;     // volume that full activation holds, per k_muscle / k_elasticity
  double relaxation = 0.0;  // recoil time = relaxation * damping / k_elasticity
  // With a lung, tissue and lung act together (see Recoil); 0 without one.
  double elastance = 0.0;        // 1/m4, of the tissue, per k_elasticity
  double tube_resistance = 0.0;  // Pa s/m3
  // What is measured beside the volume: as it is in a trunk at rest, and over a breath (see calibrate).
  double abdominal = 0.0;             // 1/m4, abdominal elastance, per k_elasticity
  double abdominal_flow = 0.0;        // Pa s/m3, abdominal resistance, per damping
  double right_descent = 0.0;         // m/m3, of the dome
  PiecewiseLinear airway_pressure{};  // Pa
  WallFactor wall{};

  double time_constant_s(const Parameters<double>& p) const { return with_lung_s(recoil, p); }
  /// Between the two time factors of a trunk, over that with the timing held; and the deviation of this.
  static constexpr double between = 0.96, log_error = 0.023;
  double recoil_time_s(const Parameters<double>& p) const { return with_lung_s(relaxation, p); }
  /// Returns the elastance of the respiratory system and of the abdomen, Pa/m3; 0 if they are not known.
  double respiratory_elastance(const Parameters<double>& p) const {
    return elastance * stiffness(p) + p.lung_elastance;
  }
  double abdominal_elastance(const Parameters<double>& p) const {
    return abdominal * p.elasticity * wall.of(wall.abdominal, p);
  }
  /// Returns whether the airway drives the breath, and not a muscle alone.
  bool airway_drives() const { return airway_pressure.events().size() > 1; }
  /// Returns the volume that full activation holds, per k_muscle / k_elasticity, m3.
  double held(const Parameters<double>& p) const {
    return tissue_share(p) * held_m3 * (wall.of(wall.gain, p) / wall.of(wall.elastance, p));
  }
  /// Returns the share of the tissue in the elastance of tissue and lung.
  double tissue_share(const Parameters<double>& p) const {
    return elastance > 0.0 ? elastance * stiffness(p) / respiratory_elastance(p) : 1.0;
  }
  /// Returns the k_elasticity with which a trunk of these parameters has a recoil time; it may be negative.
  double elasticity_of(double recoil_s, const Parameters<double>& p) const {
    const double softer = wall.of(wall.elastance, p);
    if (elastance == 0.0) return relaxation * p.damping / recoil_s / softer;
    const double resistance = elastance * relaxation * p.damping + p.resistance + tube_resistance;
    return (resistance / recoil_s - p.lung_elastance) / elastance / softer;
  }
  /// Returns the trunk that breathes with `p` as this one does with `found`.
  TrunkAsCompartment moved(const Parameters<double>& found, const Parameters<double>& p) const {
    TrunkAsCompartment other = *this;
    other.recoil = recoil * p.elasticity / found.elasticity;
    other.gain_m3 = gain_m3 * (found.muscle / found.elasticity) / (p.muscle / p.elasticity);
    if (elastance == 0.0) return other;
    other.gain_m3 *= tissue_share(found) / tissue_share(p);
    other.recoil = (time_constant_s(found) * respiratory_elastance(p) - p.resistance - tube_resistance) /
                   (elastance * p.damping);
    return other;
  }
  Compartment of(const Parameters<double>& p) const {
    const double gain = gain_m3 * p.muscle / stiffness(p);
    return {time_constant_s(p), tissue_share(p) * (gain * wall.of(wall.gain, p))};
  }

 private:
  double stiffness(const Parameters<double>& p) const { return p.elasticity * wall.of(wall.elastance, p); }
  double with_lung_s(double factor, const Parameters<double>& p) const {
    if (elastance == 0.0) return factor * p.damping / stiffness(p);
    return (elastance * factor * p.damping + p.resistance + tube_resistance) / respiratory_elastance(p);
  }
};

/// Returns the breath of the compartment, with what the airway does, at times that increase.
CompartmentBreath breath_of(const TrunkAsCompartment& trunk, const Candidate& candidate, const TimeGrid& grid,
                            std::span<const double> time_s);

/// Returns what the compartment says of a breath at the measured times.
SeenBreath seen(const TrunkAsCompartment& trunk, const Candidate& candidate, const TimeGrid& grid,
                const MeasuredCurve& measured);

/// Lets the compartment have the pressure and the dome of a simulated breath: least squares over the curves,
/// on the volume and the flow of the same breath. => abdominal_flow, right_descent
void calibrate(const Candidate& candidate, const BreathCurves& curves, const TimeGrid& grid,
               TrunkAsCompartment& trunk);

/// Returns how the wall's factor changes a trunk, from recoils at two factors. `more` is at the higher one.
WallFactor wall_factor(const Recoil& recoil, const Recoil& more);

/// Returns the compartment of a trunk that springs back like this. Some trunks have no recoil time: of one
/// with a paralysed side the domes sway for longer than the volume lasts, and one that is hardly damped
/// swings. They get the usual one, and the fit corrects it.
TrunkAsCompartment as_compartment(const Recoil& recoil, const std::optional<Pleura>& pleura = {});

/// One compartment that stands in for the trunk. It costs a thousandth of a simulation. What it misses at one
/// candidate can be added everywhere, since it hardly changes nearby.
class CompartmentModel final : public VolumeModel {
 public:
  /// All arguments must outlive the model. `measured` must hold times.
  CompartmentModel(const TrunkAsCompartment& trunk, const TimeGrid& grid, const MeasuredCurve& measured)
      : trunk_(trunk), grid_(grid), curve_(measured) {}

  /// Makes the model exact at a candidate, at which the trunk has these values.
  void correct_at(const Candidate& candidate, const Eigen::VectorXd& values);

  std::vector<LedgerEntry> at(const std::vector<Candidate>& candidates) override;
  std::optional<LedgerEntry> slopes(const Candidate&, const std::vector<Candidate>&) override {
    return std::nullopt;
  }
  bool is_simulation() const noexcept override { return false; }

 private:
  Eigen::VectorXd plain(const Candidate& candidate) const;

  const TrunkAsCompartment& trunk_;
  const TimeGrid& grid_;
  const MeasuredCurve& curve_;
  Eigen::VectorXd missed_;  // [values]; empty: nothing
};

}  // namespace trunk
