"""What a trunk read from PML says of single particles, over the tissue of the scenario."""

import dataclasses
import xml.etree.ElementTree as xml

import numpy as np


@dataclasses.dataclass
class TrunkFile:
    fineness: float
    mass: np.ndarray  # [particles] kg; NaN: nothing said, here and below
    stiffness: np.ndarray  # [particles] of the healthy tissue, times k_elasticity
    damping: np.ndarray  # [particles] times the damping coefficient
    fibre_strength: float  # times k_muscle
    names: dict  # particles of every region and landmark


def local_name(element):
    return element.tag.rpartition("}")[2]


def within(root, name):
    return [element for element in root.iter() if local_name(element) == name]


def read_trunk_file(text):
    root = xml.fromstring(text.encode())
    model = within(root, "physicalModel")[0]
    atoms = within(within(root, "atoms")[0], "atomProperties")
    components = {c.get("name"): c for c in within(root, "structuralComponent")}
    names = {name: np.array([int(atom.get("index")) for atom in c if local_name(atom) == "atomRef"], int)
             for name, c in components.items()}
    return TrunkFile(
        float(model.get("fineness", 1.0)),
        *(np.array([float(atom.get(key, "nan")) for atom in atoms]) for key in ("mass", "stiffness", "damping")),
        float(components["muscle_lines"].get("strength", "nan")),
        {name: particles for name, particles in names.items() if len(particles)},
    )
