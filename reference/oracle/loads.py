"""The loads of a scenario over time."""

import numpy as np

from oracle.elasticity import added, cross, dot, slopes

PA_PER_CMH2O = 98.0665


def course(table, key, unit):
    """A value over time: linear between events, 0 before the first, held after the last."""
    time, value = np.array(table[key], float).T
    return lambda t: np.interp(t, time, unit * value, left=0.0)


def column(direction):
    return np.array(direction, float)[:, None]


def dead_forces(scenario, anatomy, mass):
    """[(particles, force on each at a magnitude of 1 [xyz, particles], magnitude(t))] of the loads that do not
    follow the surface: forces, accelerations of masses, pressures in a direction on areas at rest."""
    loads = []
    for load in scenario.get("force", []):
        loads.append((anatomy.selected(load["region"]), column(load["direction"]), course(load, "events_N", 1.0)))
    for load in scenario.get("acceleration", []):
        particles = anatomy.selected(load["region"])
        loads.append((particles, mass[particles] * column(load["direction"]), course(load, "events_m_s2", 1.0)))
    for load in scenario.get("pressure", []):
        if "direction" not in load:
            continue
        facets = anatomy.facets(anatomy.selected(load["region"]))
        a, b, c = (anatomy.rest[:, corner] for corner in facets.T)
        normal = cross(b - a, c - a)
        third = np.tile(0.5 * np.sqrt(dot(normal, normal)) / 3.0, 3)
        share = np.bincount(facets.T.ravel(), third, anatomy.rest.shape[1])
        everyone = np.arange(len(share))
        loads.append((everyone, share * column(load["direction"]), course(load, "events_cmH2O", PA_PER_CMH2O)))
    return loads


def tetrahedra(base, tip):
    """Volume between facets [a, b, c] and their tips, m3: positive where these are on the side the facets face."""
    a, b, c = base
    return dot(tip - a, cross(b - a, c - a)) / 6.0


class Pressure:
    """A pressure on facets from the side they face. Its work is -p times the volume that they sweep: the prisms
    between where they are and where they move to, each of three tetrahedra."""

    def __init__(self, load, anatomy):
        self.corners = anatomy.facets(anatomy.selected(load["region"])).T
        self.magnitude = course(load, "events_cmH2O", PA_PER_CMH2O)

    def force(self, positions, t):
        points = positions[:, self.corners]
        a, b, c = np.moveaxis(points, 1, 0)[:, :, None]

        def swept(moved):
            to_a, to_b, to_c = np.moveaxis(moved, 1, 0)
            return tetrahedra((a, b, c), to_a) + tetrahedra((to_a, b, c), to_b) + tetrahedra((to_a, to_b, c), to_c)

        return -self.magnitude(t) * added(positions.shape, self.corners, slopes(swept, points))


def pressures(scenario, anatomy):
    return [Pressure(load, anatomy) for load in scenario.get("pressure", []) if "direction" not in load]


def displacements(scenario, anatomy):
    """[(particles, axes, direction, magnitude(t) m)]: these axes are imposed, the others stay free."""
    loads = []
    for load in scenario.get("displacement", []):
        axes = np.flatnonzero(load.get("axes", load["direction"]))
        loads.append((anatomy.selected(load["region"]), axes, load["direction"], course(load, "events_mm", 1e-3)))
    return loads
