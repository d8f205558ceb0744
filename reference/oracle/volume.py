"""The enclosed volume, and how the abdomen keeps it while the ribs are not crossed."""

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


class VolumeAndRibs:
    """Moves predicted positions to the target volume along d, and back onto a rib plane where outside of it."""

    def __init__(self, body):
        self.body = body
        self.touching = np.zeros(len(body.supported), bool)

    def put_back(self, positions, always=False):
        """Onto the planes: those outside, or those marked. Returns a copy."""
        body = self.body
        at = positions[:, body.supported]
        excess = dot(body.normal, at) - body.offset
        where = excess > 0.0 if always is False else always
        positions = positions.copy()
        positions[:, body.supported] = at - np.where(where, excess, 0.0) * body.normal
        return positions

    def solve(self, predicted, volume):
        """Positions of the target volume. d is taken where those that touched at the last step are on their plane."""
        body = self.body
        gradient = volume_gradient(self.put_back(predicted, always=self.touching), body.surface)
        direction = body.mobility * gradient / body.effective_mass

        def excess_volume(multiplier):
            return enclosed_volume(self.put_back(predicted + multiplier * direction), body.surface) - volume

        guess = -2.0 * excess_volume(0.0) / (gradient * direction).sum()
        multiplier = increasing_root(excess_volume, guess, 2.0**-50 * volume)
        free = predicted + multiplier * direction
        self.touching = dot(body.normal, free[:, body.supported]) > body.offset
        return self.put_back(free)
