"""One breath: the forces of a moment, the step, the course."""

import numpy as np

from oracle.elasticity import shape_memory
from oracle.volume import VolumeAndRibs


def activation(timing, t):
    """A(t): a linear rise to 1, a fast fall to a level, a slow fall to 0."""
    if timing["period_s"] > 0.0:
        t %= timing["period_s"]
    corners = np.cumsum([timing["onset_s"], timing["rise_s"], timing["fast_fall_s"], timing["slow_fall_s"]])
    return np.interp(t, corners, [0.0, 1.0, timing["fast_fall_level"], 0.0])


def forces(body, positions, active, t):
    force = body.mass * body.gravity + shape_memory(body.rings, positions, body.published)
    pull = active * body.fibre_stiffness * (positions[:, body.origin] - positions[:, body.insertion])
    np.add.at(force.T, body.insertion, pull.T)
    np.add.at(force.T, body.origin, -pull.T)
    for particles, direction, magnitude in body.forces:
        force[:, particles] += magnitude(t) * direction
    return force


def simulate(body, timing):
    """Yields the positions at step 0 and after each step."""
    positions, velocity = body.rest, np.zeros_like(body.rest)
    constraint = VolumeAndRibs(body)
    yield positions
    for step in range(body.steps):
        t, end = step * body.dt, (step + 1) * body.dt
        force = forces(body, positions, activation(timing, t), t)
        velocity = body.mobility * (body.mass * velocity + body.dt * force) / body.effective_mass
        predicted = positions + body.dt * velocity
        for particles, direction, magnitude in body.displacements:
            for axis in np.flatnonzero(direction):
                predicted[axis, particles] = body.rest[axis, particles] + magnitude(end) * direction[axis]
        corrected = constraint.solve(predicted, body.target(end))
        velocity = (corrected - positions) / body.dt
        positions = corrected
        yield positions
