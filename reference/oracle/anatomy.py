"""The particles of a trunk by name, and the tissue of each."""

import numpy as np

from oracle.rings import rings_of
from oracle.sheet import areas, ring_weights, stiffness_factor

DIAPHRAGM = ("costal_insertion", "zone_of_apposition", "muscular_dome", "central_tendon")
ABDOMINAL = ("pelvis", "abdominal_wall")
TEMPLATE_AREA = 4.554e-3  # m2, the mean of its elastic particles
RIB_CAGE = ("costal_insertion", "lung_wall", "lung_top")


def share_of_side(side, x):
    """How much a particle belongs to the paralysed side: a half on the midline, in proportion within 1 mm of it."""
    if side in ("none", "both"):
        return np.full(len(x), float(side == "both"))
    return np.clip(0.5 + 0.5 * (x if side == "right" else -x) / 1e-3, 0.0, 1.0)


def spine(rest, regions):
    """The hindmost particle of each ring of the abdominal wall and of the costal insertion."""
    members = np.concatenate([regions["abdominal_wall"], regions["costal_insertion"]])
    heights = rest[2, members]
    rings = (members[np.abs(heights - z) < 1e-6] for z in np.unique(heights.round(6)))
    return np.array([ring[rest[1, ring].argmin()] for ring in rings])


class Anatomy:
    """Names, places and connections of the particles, none of it subject to the scenario's loads."""

    def __init__(self, run):
        self.rest = rest = np.ascontiguousarray(run.rest.T)
        self.surface, self.lung = run.triangles["abdomen_and_diaphragm"], run.triangles["lung"]
        self.muscle_lines = run.muscle_lines
        names = {}
        for name in ("pelvis", "abdominal_wall", *DIAPHRAGM, "lung_wall", "lung_top"):
            names[name] = run.regions.get(name, np.array([], int))
        if run.trunk:
            self.names = names | run.trunk.names
            return
        names["spine"] = spine(rest, names)
        names["fixed"] = np.concatenate([names[name] for name in ("pelvis", "spine", "lung_wall", "lung_top")])
        for whole, parts in (("rib_cage", ("costal_insertion", "lung_wall")),
                             ("zone_of_apposition", ("zone_of_apposition",))):
            members = np.concatenate([names[part] for part in parts])
            names[whole + "_right"] = members[rest[0, members] > 0.0]
            names[whole + "_left"] = members[rest[0, members] < 0.0]
        self.names = names

    def particles(self, names):
        """Those of several regions."""
        return np.concatenate([self.names[name] for name in names])

    def selected(self, text):
        """Those of a scenario's text: names, numbers and ranges as in "spine,0-3,7", or "*" for all."""
        chosen = set()
        for item in text.split(","):
            if item == "*":
                chosen.update(range(self.rest.shape[1]))
            elif item in self.names:
                chosen.update(self.names[item].tolist())
            elif item[:1].isdigit():
                first, _, last = item.partition("-")
                chosen.update(range(int(first), int(last or first) + 1))
            else:
                raise ValueError(f"the oracle knows no region '{item}'")
        return np.array(sorted(chosen))

    def facets(self, particles):
        """Triangles with all corners among the particles, once each: the dome's face as the abdomen's do."""
        once = {}
        for triangle in np.concatenate([self.surface, self.lung]):
            once.setdefault(frozenset(triangle.tolist()), triangle)
        return np.array([triangle for triangle in once.values() if np.isin(triangle, particles).all()])


class Tissue:
    """Mass kg, damping N s/m and stiffness N/m of every particle, stiffness of every fibre.

    On a mesh of n times as many particles along a length, these stand for n^2 times as many particles and n times
    as many fibres of the same trunk: mass and damping a particle are those at n = 1 over n^2, muscle over n,
    shape memory times n^2. In a sheet, shape memory and damping go by areas, and muscle by widths.
    """

    def __init__(self, run, anatomy):
        s, rest = run.scenario, anatomy.rest
        n = run.trunk.fineness if run.trunk else s["geometry"]["resolution"]
        everywhere = np.ones(rest.shape[1])
        self.mass = s["tissue"]["particle_mass_kg"] / n**2 * everywhere
        share_of_damping = everywhere / n**2
        if s["tissue"].get("damping") == "area" or s["tissue"].get("elasticity") == "sheet":
            area = areas(anatomy.surface, rest)
            share_of_damping = np.where(area > 0.0, area / TEMPLATE_AREA, share_of_damping)
        stiffness = n**2 * everywhere
        stiffness[anatomy.names["central_tendon"]] *= s["tissue"]["tendon_stiffness_factor"]
        strength = 1.0 / n
        if run.trunk:
            self.mass, share_of_damping, stiffness = (
                np.where(np.isnan(given), otherwise, given) for given, otherwise in (
                    (run.trunk.mass, self.mass), (run.trunk.damping, share_of_damping),
                    (run.trunk.stiffness, stiffness)))
            strength = run.trunk.fibre_strength if run.trunk.fibre_strength > 0.0 else strength
        self.damping = s["parameters"]["damping_N_s_per_m"] * share_of_damping

        paralysis = s.get("paralysis", {})
        costal = rest[0, anatomy.names["costal_insertion"]]
        midline = 0.5 * (costal.min() + costal.max())
        paralysed = share_of_side(paralysis.get("side", "none"), rest[0] - midline)
        diaphragm = anatomy.particles(DIAPHRAGM)
        stiffness[diaphragm] *= 1.0 + paralysed[diaphragm] * (paralysis.get("stiffness_factor", 1.0) - 1.0)
        stiffness[anatomy.particles(ABDOMINAL)] *= s["parameters"]["abdomen_stiffness_factor"]
        self.stiffness = s["parameters"]["k_elasticity_N_per_m"] * stiffness
        self.insertion, self.origin = run.fibres.T
        self.fibres = s["parameters"]["k_muscle_N_per_m"] * strength * (1.0 - paralysed[self.insertion])
        self.weights = None
        if s["tissue"].get("elasticity") == "sheet":
            self.make_sheet(anatomy, n, s["tissue"]["particle_mass_kg"])

    def make_sheet(self, anatomy, n, particle_mass):
        rest, area = anatomy.rest, areas(anatomy.surface, anatomy.rest)
        self.weights, self.sheet_factor = {}, np.ones(rest.shape[1])
        for v, ring in rings_of(anatomy.surface, rest).items():
            arms = rest[:, ring] - rest[:, [v]]
            self.weights[v] = ring_weights(arms)
            self.sheet_factor[v] = stiffness_factor(area[v], arms, self.weights[v])
        on_sheet = area > 0.0
        self.stiffness *= self.sheet_factor / n**2
        self.mass = np.where(on_sheet, np.maximum(self.mass, particle_mass * self.sheet_factor / n**4), self.mass)
        insertions = rest[:, anatomy.muscle_lines[:, 0]]
        step = np.linalg.norm(np.roll(insertions, -1, axis=1) - insertions, axis=0)
        width = 0.5 * (step + np.roll(step, 1))
        self.fibres = self.fibres * n * width / 0.070
