"""A run file: the question (scenario, mesh) and the answer (frames, lung volume)."""

import dataclasses
import tomllib

import h5py
import numpy as np

from oracle.trunk_file import TrunkFile, read_trunk_file


@dataclasses.dataclass
class Run:
    scenario: dict
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


def read_run(path):
    with h5py.File(path) as file:
        particles, connectivity, parameters = file["particles/trajectory"], file["connectivity"], file["parameters"]
        component, species = connectivity["triangle_component"], particles["species"]
        triangles = connectivity["triangles"][:]
        trunk = read_trunk_file(text_of(parameters["trunk_pml"][()])) if "trunk_pml" in parameters else None
        return Run(
            scenario=tomllib.loads(text_of(parameters["scenario_toml"][()])),
            frames=particles["position/value"][:],
            frame_steps=particles["position/step"][:],
            delta_v_ml=file["curves/dV_model"][:],
            triangles={name: triangles[rows] for name, rows in by_name(component, component[:]).items()},
            fibres=connectivity["fibres"][:],
            muscle_lines=connectivity["muscle_lines"][:],
            regions=by_name(species, species[:]),
            rigid=particles["rigid"][:],
            trunk=trunk,
        )
