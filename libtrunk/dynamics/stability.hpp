#pragma once

#include "model/model.hpp"
#include "model/parameters.hpp"
#include "model/workspace.hpp"

namespace trunk {

/// Returns the longest stable time step at rest with full activation, s; infinity if nothing oscillates. The
/// highest angular frequency w of M^-1 dF/dx comes from power iteration on finite differences of the forces.
/// Semi-implicit Euler with implicit damping (rate g = c/m) is stable while dt^2 w^2 < 4 + 2 g dt, which
/// means dt < (g + sqrt(g^2 + 4 w^2)) / w^2. With centred damping it is stable for dt < 2 / w, whatever g is.
double stable_time_step(const Model& model, const Parameters<double>& parameters,
                        Damping damping = Damping::implicit);

}  // namespace trunk
