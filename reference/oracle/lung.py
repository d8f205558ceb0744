"""The lung and the airway: what the pleural pressure does to the particles."""

import numpy as np

from oracle.loads import PA_PER_CMH2O
from oracle.volume import enclosed_volume, increasing_root, volume_gradient

PER_LITRE = PA_PER_CMH2O / 1e-3
ROUND_OFF = 2.0**-50  # of the multiplier


class Lung:
    """dPpl = airway pressure - E dV - R dV/dt, a force dPpl dV/dx on every particle. Elastance and airway act as at the
    start of a step, resistance on the flow of the step itself, along the gradient at its start."""

    def __init__(self, scenario, anatomy, dt):
        lung, airway = scenario.get("lung", {}), scenario.get("airway", {})
        self.triangles, self.dt = anatomy.lung, dt
        self.elastance = PER_LITRE * lung.get("elastance_cmH2O_per_L", 0.0)
        self.resistance = PER_LITRE * (lung.get("resistance_cmH2O_s_per_L", 0.0)
                                       + airway.get("tube_resistance_cmH2O_s_per_L", 0.0))
        pressure = airway.get("pressure_cmH2O", 0.0)
        time, value = np.array([[0.0, pressure]] if np.isscalar(pressure) else pressure, float).T
        before = value[0] if np.isscalar(pressure) else 0.0
        self.airway = lambda t: PA_PER_CMH2O * np.interp(t, time, value, left=before)
        self.rest = enclosed_volume(anatomy.rest, self.triangles)

    def gradient(self, positions):
        return volume_gradient(positions, self.triangles)

    def force(self, positions, t):
        """That part which is known at the start of a step, N."""
        gain = enclosed_volume(positions, self.triangles) - self.rest
        return (self.airway(t) - self.elastance * gain) * self.gradient(positions)

    def resisted(self, places, positions, gradient, begin):
        """The multiplier mu with mu = -dt R gradient . (places(mu) - positions), from near `begin`."""
        coupling = self.dt * self.resistance

        def missing(mu):
            return mu + coupling * (gradient * (places(mu) - positions)).sum()

        at_begin = missing(begin)
        step = -2.0 * at_begin
        enough = ROUND_OFF * coupling * (abs(gradient) * abs(places(begin) - positions)).sum()
        return begin + increasing_root(lambda more: missing(begin + more), step, max(enough, 1e-300))
