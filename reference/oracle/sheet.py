"""Shape memory as a thin sheet, whatever its triangles: weights of rings, stiffness, and rings on clamped borders.

A regular mesh of the spacing SPACING has one N/m of stiffness a particle for each N/m of k_elasticity.
"""

import math

import numpy as np

from oracle.elasticity import IMAGINARY_STEP, cross, dot, offset_at_rest, target, unit

SPACING = 0.08  # m
AREA = 0.5 * math.sqrt(3.0) * SPACING**2  # m2 a particle
BENDING = SPACING**4 / (16.0 * AREA)  # bending stiffness over k_elasticity, m2


def areas(triangles, rest):
    """A third of the triangles around each particle, m2."""
    a, b, c = (rest[:, triangles[:, corner]] for corner in range(3))
    size = 0.5 * np.sqrt((cross(b - a, c - a)**2).sum(axis=0))
    return sum(np.bincount(triangles[:, corner], size / 3.0, rest.shape[1]) for corner in range(3))


def bounded_least_squares(matrix, wanted, low):
    """x that makes |matrix x - wanted| least with x >= low: Murty's pivots, one at a time, which always end."""
    free = np.ones(matrix.shape[1], bool)
    while True:
        x = np.full(len(free), low)
        x[free] = np.linalg.lstsq(matrix[:, free], wanted - matrix @ np.where(free, 0.0, low), rcond=None)[0]
        slope = matrix.T @ (matrix @ x - wanted)
        wrong = np.flatnonzero((free & (x < low)) | (~free & (slope < -1e-10)))
        if len(wrong) == 0:
            return x
        free[wrong[-1]] ^= True


def ring_weights(arms):
    """Weights of the neighbours at `arms` [xyz, m] from the particle, m: a centre over the particle, and the same
    second moment in all directions, as far as weights of 0.15/m and more can."""
    m = arms.shape[1]
    normal = unit(cross(arms, np.roll(arms, -1, axis=1)).sum(axis=1))
    across = np.linalg.svd(normal[None])[2][1:] @ arms  # in any two axes across the normal
    a, b = across / math.sqrt((across**2).sum() / m)
    rows = np.vstack([30 * np.ones(m), 30 * a, 30 * b, a * a - b * b, 2 * a * b, 0.15 * np.eye(m)])
    wanted = np.concatenate([[30.0], np.zeros(4), np.full(m, 0.15 / m)])
    weights = bounded_least_squares(rows, wanted, 0.15 / m)
    return weights / weights.sum()


def stiffness_factor(area, arms, weights):
    """(A / A_ref) (h_ref / h)^4 of a ring."""
    return area / AREA * (SPACING**2 / (weights * dot(arms, arms)).sum())**2


def free_side(ring, clamped):
    """Positions in the ring from one clamped neighbour over the free ones to the next clamped one, if the free ones lie
    side by side between two clamped neighbours."""
    starts = [j for j in range(len(ring)) if clamped[ring[j - 1]] and not clamped[ring[j]]]
    if len(starts) != 1 or clamped[ring].sum() < 2:
        return None
    return [(starts[0] - 1 + k) % len(ring) for k in range((~clamped[ring]).sum() + 2)]


def border_stiffness(points, weights, side):
    """Stiffness over k_elasticity of a ring [xyz, 1 + m] that bends on one side: the energy of its linear answer to
    d^2 / 2 on that side is that of the sheet."""
    arms = (points[:, 1:] - points[:, :1])[:, side]
    twice = cross(arms[:, :-1], arms[:, 1:])
    normal = unit(twice.sum(axis=1))
    inward = unit(cross(normal, arms[:, 0] - arms[:, -1]))
    area = np.sqrt((twice**2).sum(axis=0)).sum() / 6.0
    bent = points[:, 1:].astype(complex)
    free = side[1:-1]
    bent[:, free] += 1j * IMAGINARY_STEP * normal[:, None] * 0.5 * (inward @ arms[:, 1:-1])**2
    offset = offset_at_rest(points, weights)
    answer = target(bent, weights, offset).imag / IMAGINARY_STEP
    return BENDING * area / (answer**2).sum()
