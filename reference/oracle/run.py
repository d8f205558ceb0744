"""A run file: the question (scenario, mesh) and the answer (frames, lung volume)."""

import dataclasses
import tomllib

import h5py
import numpy as np

from oracle.trunk_file import TrunkFile, read_trunk_file


@dataclasses.dataclass
class Run:
    scenario: dict
    rest: np.ndarray  # [particles, xyz] m
    frames: np.ndarray  # [frames, particles, xyz] m
    frame_steps: np.ndarray
    delta_v_ml: np.ndarray  # [steps + 1]
    triangles: dict  # by component, [triangles, 3]
    fibres: np.ndarray  # [fibres, 2]: insertion, origin
    muscle_lines: np.ndarray  # [lines, points]: around the trunk, each from the costal insertion up
    regions: dict  # particles by name
    rigid: np.ndarray  # [particles]: 0, or 1 + which rigid component carries it
    trunk: TrunkFile | None  # where the trunk came from a file: what that says of single particles


def text_of(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def by_name(dataset, codes):
    """{name: indices} of a dataset of flags."""
    names = text_of(dataset.attrs["flag_meanings"]).split()
    return {name: np.flatnonzero(codes == value) for name, value in zip(names, dataset.attrs["flag_values"])}


def starts_at_rest(scenario):
    return scenario["time"].get("start", "rest") == "rest"


def read_run(path, rest_path=None):
    """The rest shape is the first frame of `rest_path`, or of the run itself."""
    rest = read_run(rest_path) if rest_path else None
    with h5py.File(path) as file:
        particles, connectivity, parameters = file["particles/trajectory"], file["connectivity"], file["parameters"]
        component, species = connectivity["triangle_component"], particles["species"]
        triangles = connectivity["triangles"][:]
        scenario, frames = tomllib.loads(text_of(parameters["scenario_toml"][()])), particles["position/value"][:]
        if not starts_at_rest(rest.scenario if rest else scenario):
            raise ValueError("it does not start at rest: --rest has to name a run of this trunk that does")
        trunk = read_trunk_file(text_of(parameters["trunk_pml"][()])) if "trunk_pml" in parameters else None
        return Run(
            scenario=scenario,
            rest=rest.rest if rest else frames[0],
            frames=frames,
            frame_steps=particles["position/step"][:],
            delta_v_ml=file["curves/dV_model"][:],
            triangles={name: triangles[rows] for name, rows in by_name(component, component[:]).items()},
            fibres=connectivity["fibres"][:],
            muscle_lines=connectivity["muscle_lines"][:],
            regions=by_name(species, species[:]),
            rigid=particles["rigid"][:],
            trunk=trunk,
        )
