#pragma once

#include "model/model.hpp"
#include "model/parameters.hpp"

namespace trunk {

/// Measures how a model springs back (our choice of what stands for a whole breath). The muscle holds 5 % of
/// the lung volume, the mean over a normal breath, until nothing moves, and then lets go:
///  - gain is the volume held, per k_muscle / k_elasticity;
///  - time_factor is the integral of the volume after release over the volume held, times k_elasticity / c.
///    In a linear model this is its mean delay, whatever its masses;
///  - memory is the time after release from which on the volume stays below 2e-5 of the volume held, times
///    k_elasticity / c.
/// One compartment with these numbers follows quiet breaths of the default trunk within 0.3 % of their tidal
/// volume at periods of 5 and 3.3 s, and within 0.8 % at 2 s (measured). It cannot follow a trunk with one
/// paralysed side, whose domes sway for longer than the volume lasts.
///
/// abdominal is the abdominal pressure over the volume held and k_elasticity.
///
/// If the model has a pleura, elastance is measured too: a pleural pressure holds the same volume, and
/// elastance is that pressure over the volume and k_elasticity. The lung itself, resistances and the pressure
/// of the airway have no part in any of these numbers.
///
/// Loads, weight, and courses of the abdominal volume and of rigid parts are left out. If all fibres are
/// paralysed, they all pull in the measurement, and the gain is 0. Throws InputError if the model does not
/// come to rest. It costs about 7 ms for 113 particles.
Recoil measure_recoil(const Model& model, const Parameters<double>& parameters);

/// Returns the time in which a relaxed trunk, with its lung and airway, loses 63 % of its volume, s: the
/// resistance of the tissue and the airway over the elastance of the tissue and the lung.
double recoil_time_s(const Recoil& recoil, const Parameters<double>& parameters,
                     const std::optional<Pleura>& pleura);

/// Measures the recoil that leads depend on (see lead_s): that of the model without membrane, for fixed
/// parameters, so that a lead does not depend on the trial for which a trunk was built.
Recoil measure_recoil_for_leads(Model model);

}  // namespace trunk
