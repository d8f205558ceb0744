"""The neighbours of every particle on the elastic surface, in order."""

import numpy as np

TIE = 1e-9  # directions closer than this count as equal


def rings_of(triangles, rest):
    """{vertex: neighbours counter-clockwise seen from outside}, from first_neighbour on.

    The axis u of the local frame points to the first neighbour. The target T of a ring at rest does not depend
    on that choice, T of a deformed ring does.
    """
    after = {}
    for triangle in triangles:
        for corner in range(3):
            vertex, here, there = np.roll(triangle, -corner)
            after.setdefault(vertex, {})[here] = there
    rings = {}
    for vertex, successor in after.items():
        ring = [min(successor)]
        while successor[ring[-1]] != ring[0]:
            ring.append(successor[ring[-1]])
        assert len(ring) == len(successor), f"the ring of particle {vertex} is not closed"
        start = first_neighbour(rest[:, ring] - rest[:, [vertex]])
        rings[vertex] = ring[start:] + ring[:start]
    return rings


def first_neighbour(toward):
    """Most upward at rest, of those the most forward, of those the next one from the smallest index on.

    toward: [xyz, neighbours], from the particle
    """
    _, y, z = toward / np.sqrt((toward**2).sum(axis=0))
    upward = z > z.max() - TIE
    return np.flatnonzero(upward & (y > y[upward].max() - TIE))[0]
