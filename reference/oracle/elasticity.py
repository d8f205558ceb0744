"""Forces as negative slopes of energies.

Shape memory: particle P is drawn to T = G + x0 u + y0 v + z0 n, known from its ring N_1..N_m alone. G is the mean of
the ring by the weights of its members. The axis u starts from the plain mean.
"""

import functools

import numpy as np

IMAGINARY_STEP = 1e-30  # of the complex-step derivative: nothing is subtracted, so it may be as small as one likes


@functools.cache
def imaginary_steps(components, members):
    """One for each coordinate of a group of points."""
    coordinates = components * members
    return 1j * IMAGINARY_STEP * np.eye(coordinates).reshape(components, members, coordinates, 1)


def slopes(function, points):
    """d function / d points by the complex step: exact to round-off, for an analytic function.

    points: [xyz, m, groups]; function: [xyz, m, ..., groups] to [..., groups]
    """
    steps = imaginary_steps(*points.shape[:2])
    return (function(points[:, :, None] + steps).imag / IMAGINARY_STEP).reshape(points.shape)


def added(shape, members, forces):
    """Sums the forces [xyz, m, groups] on members [m, groups] by particle."""
    return np.stack([np.bincount(members.ravel(), part.ravel(), shape[1]) for part in forces])


def dot(a, b):
    return (a * b).sum(axis=0)  # no complex conjugate: an analytic function


def cross(a, b):
    return np.stack([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def unit(a):
    return a / np.sqrt(dot(a, a))


def local_frame(ring):
    """The axes (u, v, n) of rings [xyz, m, ...]: n along the area vector, u to N_1 across n, v = n x u."""
    arm = ring - ring.mean(axis=1)[:, None]
    n = unit(cross(arm[:, :-1], arm[:, 1:]).sum(axis=1) + cross(arm[:, -1], arm[:, 0]))
    u = unit(arm[:, 0] - dot(arm[:, 0], n) * n)
    return u, cross(n, u), n


def centre_of(ring, weights):
    """G of rings [xyz, m, ..., rings]; weights: [m, rings], or None for the plain mean"""
    if weights is None:
        return ring.mean(axis=1)
    spread = weights.reshape(weights.shape[:1] + (1,) * (ring.ndim - 1 - weights.ndim) + weights.shape[1:])
    return (spread * ring).sum(axis=1)


def target(ring, weights, rest_offset):
    return centre_of(ring, weights) + sum(number * axis for number, axis in zip(rest_offset, local_frame(ring)))


def offset_at_rest(points, weights):
    """P - G of rings at rest along their axes. points: [xyz, m + 1, ...], P before N_1..N_m"""
    ring = points[:, 1:]
    return [dot(points[:, 0] - centre_of(ring, weights), axis) for axis in local_frame(ring)]


class RingGroup:
    """All rings of one valence m, side by side. members: [m + 1, rings], P before N_1..N_m; weights: [m, rings]."""

    def __init__(self, members, stiffness, weights, rest):
        self.members, self.stiffness, self.weights = members, stiffness, weights
        self.rest_offset = offset_at_rest(rest[:, members], weights)

    def energy(self, points):
        """E = 1/2 k |P - T|^2 of every ring, J. points: [xyz, m + 1, ..., rings]"""
        stretch = points[:, 0] - target(points[:, 1:], self.weights, self.rest_offset)
        return 0.5 * self.stiffness * dot(stretch, stretch)

    def variational(self, points):
        """-dE/d(P, N_1..N_m)."""
        return -slopes(self.energy, points)

    def published(self, points):
        """k (T - P) on P, shared equally by its neighbours with the opposite sign."""
        force = self.stiffness * (target(points[:, 1:], self.weights, self.rest_offset) - points[:, 0])
        valence = points.shape[1] - 1
        return np.stack([force] + valence * [-force / valence], axis=1)


def shape_memory(rings, positions, published):
    """Force on every particle, N. rings: groups by valence"""
    force = np.zeros_like(positions)
    for group in rings:
        points = positions[:, group.members]
        on_members = group.published(points) if published else group.variational(points)
        force += added(positions.shape, group.members, on_members)
    return force


class Membrane:
    """A spring along every edge of a surface, at rest at its rest length: E = 1/2 k (|b - a| - l)^2."""

    def __init__(self, triangles, rest, stiffness):
        sides = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
        self.edges = np.unique(np.sort(sides, axis=1), axis=0).T
        self.stiffness = stiffness
        self.length_at_rest = self.length(rest[:, self.edges])

    @staticmethod
    def length(points):
        along = points[:, 1] - points[:, 0]
        return np.sqrt(dot(along, along))

    def energy(self, points):
        return 0.5 * self.stiffness * (self.length(points) - self.length_at_rest) ** 2

    def force(self, positions):
        return -added(positions.shape, self.edges, slopes(self.energy, positions[:, self.edges]))
