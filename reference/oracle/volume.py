"""The enclosed volume, its gradient, and a bracketed root."""

import numpy as np

from oracle.elasticity import cross, dot


def enclosed_volume(positions, triangles):
    """One sixth of the sum of the corner determinants, m3."""
    a, b, c = (positions[:, corner] for corner in triangles.T)
    return dot(a, cross(b, c)).sum() / 6.0


def volume_gradient(positions, triangles):
    """dV/dP, m2: each corner of a triangle gets a third of its area vector (the surface is closed)."""
    a, b, c = (positions[:, corner] for corner in triangles.T)
    third = cross(b - a, c - a) / 6.0
    corners = triangles.T.ravel()
    return np.stack([np.bincount(corners, np.tile(part, 3), positions.shape[1]) for part in third])


def increasing_root(function, guess, enough):
    """Where the function is 0 within `enough`, between ends of opposite sign (Illinois rule)."""
    low, at_low = 0.0, function(0.0)
    if abs(at_low) <= enough:
        return low
    high = guess
    at_high = function(high)
    while at_high * at_low > 0.0:
        if not abs(high) < 1e300:
            raise ArithmeticError("no displacement restores the abdominal volume")
        low, at_low, high = high, at_high, 2.0 * high
        at_high = function(high)
    for _ in range(200):
        middle = (low * at_high - high * at_low) / (at_high - at_low)
        at_middle = function(middle)
        if abs(at_middle) <= enough or middle in (low, high):
            return middle
        if at_middle * at_high < 0.0:
            low, at_low = high, at_high
        else:
            at_low *= 0.5
        high, at_high = middle, at_middle
    raise ArithmeticError("the search for the abdominal volume did not end")
