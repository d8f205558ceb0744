"""The trunk of a run file: geometry as stored, everything else derived here from the scenario's definitions."""

import dataclasses
import tomllib

import h5py
import numpy as np

from oracle.elasticity import RingGroup
from oracle.rings import rings_of
from oracle.volume import enclosed_volume

DIAPHRAGM = ("costal_insertion", "zone_of_apposition", "central_tendon")
ABDOMINAL = ("pelvis", "abdominal_wall")
RINGS_AT_ONCE = 25  # their complex steps stay in the processor's cache


@dataclasses.dataclass
class Run:
    """What the file says: the question and the answer."""
    scenario: dict
    frames: np.ndarray  # [frames, particles, xyz] m
    frame_steps: np.ndarray
    delta_v_ml: np.ndarray  # [steps + 1]
    triangles: dict  # by component, [triangles, 3]
    fibres: np.ndarray  # [fibres, 2]
    regions: dict  # particles by name


def by_name(dataset, codes):
    """{name: indices} of a dataset of flags."""
    names = dataset.attrs["flag_meanings"]
    names = (names.decode() if isinstance(names, bytes) else names).split()
    return {name: np.flatnonzero(codes == value) for name, value in zip(names, dataset.attrs["flag_values"])}


def read_run(path):
    with h5py.File(path) as file:
        particles, connectivity = file["particles/trajectory"], file["connectivity"]
        component, species = connectivity["triangle_component"], particles["species"]
        triangles = connectivity["triangles"][:]
        return Run(tomllib.loads(file["parameters/scenario_toml"][()].decode()),
                   particles["position/value"][:], particles["position/step"][:], file["curves/dV_model"][:],
                   {name: triangles[rows] for name, rows in by_name(component, component[:]).items()},
                   connectivity["fibres"][:], by_name(species, species[:]))


def share_of_side(side, x):
    """How much a particle belongs to the paralysed side: a half on the midline."""
    if side in ("none", "both"):
        return np.full(len(x), float(side == "both"))
    return 0.5 + 0.5 * np.sign(x if side == "right" else -x)


def spine(rest, regions):
    """The hindmost particle of each ring of the abdominal wall and of the costal insertion."""
    members = np.concatenate([regions["abdominal_wall"], regions["costal_insertion"]])
    heights = rest[2, members]
    rings = (members[np.abs(heights - z) < 1e-6] for z in np.unique(heights.round(6)))
    return np.array([ring[rest[1, ring].argmin()] for ring in rings])


def events(load, key, unit):
    time, value = np.array(load[key], float).T
    return lambda t: np.interp(t, time, unit * value, left=0.0)


class Body:
    def __init__(self, run):
        s = run.scenario
        self.rest = rest = np.ascontiguousarray(run.frames[0].T)
        self.regions = run.regions | {"spine": spine(rest, run.regions)}
        self.dt = 1e-3 * s["time"]["dt_ms"]
        self.steps = round(1e3 * s["time"]["duration_s"] / s["time"]["dt_ms"])
        self.mass = s["tissue"]["particle_mass_kg"]
        self.effective_mass = self.mass + self.dt * s["parameters"]["damping_N_s_per_m"]
        self.gravity = np.array(s.get("gravity_m_s2", [0.0, 0.0, 0.0]))[:, None]
        self.published = s["tissue"]["reaction"] == "published"
        self.paralysed = share_of_side(s.get("paralysis", {}).get("side", "none"), rest[0])

        self.surface, self.lung = run.triangles["abdomen_and_diaphragm"], run.triangles["lung"]
        self.volume = enclosed_volume(rest, self.surface)
        course = np.array(s.get("abdominal_volume_fraction", [[0.0, 1.0]]), float).T
        self.target = lambda t: self.volume * np.interp(t, *course, left=1.0)

        rings, stiffness = rings_of(self.surface, rest), self.stiffness(s)
        self.rings = []
        for valence in sorted({len(ring) for ring in rings.values()}):
            members = np.array([[v, *ring] for v, ring in rings.items() if len(ring) == valence]).T
            for part in np.array_split(members, -(-members.shape[1] // RINGS_AT_ONCE), axis=1):
                self.rings.append(RingGroup(part, stiffness[part[0]], rest))
        self.insertion, self.origin = run.fibres.T
        self.fibre_stiffness = s["parameters"]["k_muscle_N_per_m"] * (1.0 - self.paralysed[self.insertion])
        self.hold(s)
        self.set_loads(s)
        self.set_supports(s)

    def stiffness(self, s):
        """k of every shape-memory actuator, N/m."""
        k = np.full(self.rest.shape[1], s["parameters"]["k_elasticity_N_per_m"], float)
        k[self.regions["central_tendon"]] *= s["tissue"]["tendon_stiffness_factor"]
        diaphragm = np.concatenate([self.regions[name] for name in DIAPHRAGM])
        softening = s.get("paralysis", {}).get("stiffness_factor", 1.0) - 1.0
        k[diaphragm] *= 1.0 + self.paralysed[diaphragm] * softening
        k[np.concatenate([self.regions[name] for name in ABDOMINAL])] *= s["parameters"]["abdomen_stiffness_factor"]
        return k

    def hold(self, s):
        self.mobility = np.ones_like(self.rest)
        held = ["pelvis", "spine", "lung_wall", "lung_top"] + ["costal_insertion"] * s["tissue"]["ribs"]
        for name in held:
            self.mobility[:, self.regions[name]] = 0.0

    def set_loads(self, s):
        """(particles, direction, course) of every load; displacements bind the axes of their direction."""
        self.forces = [(self.regions[load["region"]], np.array(load["direction"], float)[:, None],
                        events(load, "events_N", 1.0)) for load in s.get("force", [])]
        self.displacements = [(self.regions[load["region"]], np.array(load["direction"], float),
                               events(load, "events_mm", 1e-3)) for load in s.get("displacement", [])]
        for particles, direction, _ in self.displacements:
            self.mobility[np.ix_(direction != 0.0, particles)] = 0.0

    def set_supports(self, s):
        """Ribs: the tangent plane of the trunk's ellipse at each free particle of the zone of apposition."""
        zone = self.regions["zone_of_apposition"] if s["tissue"]["ribs"] else np.array([], int)
        self.supported = zone[self.mobility[:, zone].all(axis=0)]
        half_axes = 1e-3 * np.array([s["geometry"]["half_width_mm"], s["geometry"]["half_depth_mm"], np.inf])
        at = self.rest[:, self.supported]
        gradient = at / half_axes[:, None] ** 2
        self.normal = gradient / np.sqrt((gradient**2).sum(axis=0))
        self.offset = (self.normal * at).sum(axis=0)
