"""The trunk of a run file: geometry as stored, everything else derived here from the scenario's definitions."""

import numpy as np

from oracle.anatomy import RIB_CAGE, Anatomy, Tissue
from oracle.elasticity import Membrane, RingGroup
from oracle.lung import Lung
from oracle.loads import course, dead_forces, displacements, pressures
from oracle.ribs import Ribs
from oracle.rigid import Driven, Fixed, Free
from oracle.rings import rings_of
from oracle.run import starts_at_rest
from oracle.sheet import border_stiffness, free_side
from oracle.volume import enclosed_volume

RINGS_AT_ONCE = 25  # their complex steps stay in the processor's cache


class Body:
    def __init__(self, run):
        s = run.scenario
        self.anatomy, self.dt = Anatomy(run), 1e-3 * s["time"]["dt_ms"]
        self.tissue, self.rest = Tissue(run, self.anatomy), self.anatomy.rest
        self.steps = round(1e3 * s["time"]["duration_s"] / s["time"]["dt_ms"])
        self.breath_s, self.periodic = s["time"]["duration_s"], not starts_at_rest(s)
        self.mass = self.tissue.mass
        self.effective_mass = self.mass + self.dt * self.tissue.damping
        self.gravity = np.array(s.get("gravity_m_s2", [0.0, 0.0, 0.0]))[:, None]
        self.friction = s["tissue"]["rib_friction"]

        self.volume = enclosed_volume(self.rest, self.anatomy.surface)
        fraction = np.array(s.get("abdominal_volume_fraction", [[0.0, 1.0]]), float).T
        self.target = lambda t: self.volume * np.interp(t, *fraction, left=1.0)

        self.mobility = np.ones_like(self.rest)
        self.mobility[:, self.anatomy.names["fixed"]] = 0.0
        self.set_rigid_parts(s)
        self.set_elasticity(s)
        self.set_loads(s)
        self.lung = Lung(s, self.anatomy, self.dt) if "lung" in s or "airway" in s else None
        self.ribs.keep(self.mobility[:, self.ribs.particles].all(axis=0))
        carried = np.zeros(self.rest.shape[1], int)
        for number, part in enumerate(self.parts):
            carried[part.particles] = number + 1
        if (carried != run.rigid).any():
            raise ValueError("the rigid parts of the run are not those of its scenario")

    def set_elasticity(self, s):
        self.published = s["tissue"]["reaction"] == "published"
        held = ~self.mobility.any(axis=0)
        for part in self.free:
            held[part.particles] = False
        stiffness = self.tissue.stiffness * np.where(held, s["tissue"]["held_stiffness_factor"], 1.0)
        rings, weights = rings_of(self.anatomy.surface, self.rest), self.tissue.weights
        if weights:
            stiffness = self.tissue.stiffness * self.stiffening_of_borders(rings, held)
        self.rings = []
        for valence in sorted({len(ring) for ring in rings.values()}):
            members = np.array([[v, *ring] for v, ring in rings.items() if len(ring) == valence]).T
            for part in np.array_split(members, -(-members.shape[1] // RINGS_AT_ONCE), axis=1):
                of_part = np.array([weights[v] for v in part[0]]).T if weights else None
                self.rings.append(RingGroup(part, stiffness[part[0]], of_part, self.rest))
        per_edge = s["tissue"]["membrane_stiffness_N_per_m"]
        self.membranes = [Membrane(self.anatomy.surface, self.rest, per_edge)] if per_edge > 0.0 else []

    def stiffening_of_borders(self, rings, held):
        """Factor on the stiffness of each particle of a sheet. The ribs clamp what slides along them, and the spine
        is a line with the sheet on both sides."""
        factor, clamped = np.ones(self.rest.shape[1]), held.copy()
        clamped[self.ribs.particles] = True
        for v, ring in rings.items():
            side = free_side(np.array(ring), clamped)
            if held[v] and v not in self.anatomy.names["spine"] and side:
                points = self.rest[:, [v, *ring]]
                factor[v] = border_stiffness(points, self.tissue.weights[v], side) / self.tissue.sheet_factor[v]
        return factor

    def set_rigid_parts(self, s):
        """Those of the scenario; with ribs, one more carries what they leave of the rib cage, and all particles of
        the zone of apposition that slide along none of them slide along it."""
        anatomy, carried, faced = self.anatomy, set(), {}
        self.parts = []
        for table in s.get("rigid", []):
            particles = anatomy.selected(table["region"])
            carried.update(particles.tolist())
            if "surface_for" in table:
                faced |= dict.fromkeys(anatomy.selected(table["surface_for"]).tolist(), len(self.parts))
            self.parts.append(self.rigid_part(table, particles))
        if s["tissue"]["ribs"]:
            zone = anatomy.names["zone_of_apposition"].tolist()
            faced = dict.fromkeys(zone, len(self.parts)) | faced
            cage = [i for i in anatomy.particles(RIB_CAGE).tolist() if i not in carried]
            self.parts.append(Fixed(np.array(cage, int)))
        for part in self.parts:
            self.mobility[:, part.particles] = 0.0
        self.driven = [part for part in self.parts if isinstance(part, Driven)]
        self.free = [part for part in self.parts if isinstance(part, Free)]
        self.ribs = Ribs(anatomy, faced, self.parts)

    def rigid_part(self, table, particles):
        if table["motion"] == "driven":
            return Driven(particles, self.rest, table, course)
        if table["motion"] == "free":
            return Free(particles, self.rest, self.mass, self.tissue.damping, self.dt)
        return Fixed(particles)

    def set_loads(self, s):
        self.dead_forces = dead_forces(s, self.anatomy, self.mass)
        self.pressures = pressures(s, self.anatomy)
        self.displacements = displacements(s, self.anatomy)
        for particles, axes, _, _ in self.displacements:
            self.mobility[np.ix_(axes, particles)] = 0.0
