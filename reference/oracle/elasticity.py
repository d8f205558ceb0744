"""Shape memory. Particle P is drawn to T = G + x0 u + y0 v + z0 n, known from its ring N_1..N_m alone."""

import numpy as np

IMAGINARY_STEP = 1e-30  # of the complex-step derivative: nothing is subtracted, so it may be as small as one likes


def dot(a, b):
    return (a * b).sum(axis=0)  # no complex conjugate: an analytic function


def cross(a, b):
    return np.stack([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def unit(a):
    return a / np.sqrt(dot(a, a))


def local_frame(ring):
    """G and the axes (u, v, n) of rings [xyz, m, ...]: n along the area vector, u to N_1 across n, v = n x u."""
    centre = ring.mean(axis=1)
    arm = ring - centre[:, None]
    n = unit(cross(arm[:, :-1], arm[:, 1:]).sum(axis=1) + cross(arm[:, -1], arm[:, 0]))
    u = unit(arm[:, 0] - dot(arm[:, 0], n) * n)
    return centre, (u, cross(n, u), n)


def target(ring, rest_offset):
    centre, axes = local_frame(ring)
    return centre + sum(number * axis for number, axis in zip(rest_offset, axes))


class RingGroup:
    """All rings of one valence m, side by side. members: [m + 1, rings], P before N_1..N_m."""

    def __init__(self, members, stiffness, rest):
        self.members, self.stiffness = members, stiffness
        points = rest[:, members]
        centre, axes = local_frame(points[:, 1:])
        self.rest_offset = [dot(points[:, 0] - centre, axis) for axis in axes]
        coordinates = points.shape[0] * points.shape[1]
        # One imaginary step for each coordinate of P and its ring: [xyz, m + 1, coordinates, 1]
        self.steps = 1j * IMAGINARY_STEP * np.eye(coordinates).reshape(*points.shape[:2], coordinates, 1)

    def energy(self, points):
        """E = 1/2 k |P - T|^2 of every ring, J. points: [xyz, m + 1, ..., rings]"""
        stretch = points[:, 0] - target(points[:, 1:], self.rest_offset)
        return 0.5 * self.stiffness * dot(stretch, stretch)

    def variational(self, points):
        """-dE/d(P, N_1..N_m) by the complex step: exact to round-off."""
        slopes = self.energy(points[:, :, None] + self.steps).imag / IMAGINARY_STEP
        return -slopes.reshape(points.shape)

    def published(self, points):
        """k (T - P) on P, shared equally by its neighbours with the opposite sign."""
        force = self.stiffness * (target(points[:, 1:], self.rest_offset) - points[:, 0])
        valence = points.shape[1] - 1
        return np.stack([force] + valence * [-force / valence], axis=1)


def shape_memory(rings, positions, published):
    """Force on every particle, N. rings: groups by valence"""
    force = np.zeros_like(positions)
    for group in rings:
        points = positions[:, group.members]
        on_members = group.published(points) if published else group.variational(points)
        for axis in range(3):
            force[axis] += np.bincount(group.members.ravel(), on_members[axis].ravel(), positions.shape[1])
    return force
