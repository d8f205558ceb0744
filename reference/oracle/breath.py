"""One breath: the forces of a moment, the step, the course."""

import numpy as np

from oracle.constraint import VolumeAndRibs
from oracle.elasticity import shape_memory


def activation(timing, t):
    """A(t): a linear rise to 1, a fast fall to a level, a slow fall to 0."""
    if timing["period_s"] > 0.0:
        t %= timing["period_s"]
    corners = np.cumsum([timing["onset_s"], timing["rise_s"], timing["fast_fall_s"], timing["slow_fall_s"]])
    return np.interp(t, corners, [0.0, 1.0, timing["fast_fall_level"], 0.0])


def forces(body, positions, active, t):
    """On every particle, N."""
    force = body.mass * body.gravity + shape_memory(body.rings, positions, body.published)
    muscle = body.tissue
    pull = active * muscle.fibres * (positions[:, muscle.origin] - positions[:, muscle.insertion])
    np.add.at(force.T, muscle.insertion, pull.T)
    np.add.at(force.T, muscle.origin, -pull.T)
    for membrane in body.membranes:
        force += membrane.force(positions)
    for particles, at_one, magnitude in body.dead_forces:
        force[:, particles] += magnitude(t) * at_one
    for pressure in body.pressures:
        force += pressure.force(positions, t)
    return force


def predict(body, positions, velocity, active, t, end):
    """Where the forces alone, and what is imposed, would take the particles."""
    force = forces(body, positions, active, t)
    velocity = body.mobility * (body.mass * velocity + body.dt * force) / body.effective_mass
    predicted = positions + body.dt * velocity
    for part in body.driven:
        predicted[:, part.particles] = part.places(end)
    for part in body.free:
        predicted[:, part.particles] = part.predict(force)
    for particles, axes, direction, magnitude in body.displacements:
        for axis in axes:
            predicted[axis, particles] = body.rest[axis, particles] + magnitude(end) * direction[axis]
    return predicted


def simulate(body, timing):
    """Yields the positions at step 0 and after each step."""
    positions, velocity = body.rest, np.zeros_like(body.rest)
    constraint = VolumeAndRibs(body)
    yield positions
    for step in range(body.steps):
        t, end = step * body.dt, (step + 1) * body.dt
        predicted = predict(body, positions, velocity, activation(timing, t), t, end)
        planes = body.ribs.planes(predicted, positions, t, end)
        corrected = constraint.solve(predicted, positions, planes, body.target(end))
        velocity = (corrected - positions) / body.dt
        positions = corrected
        yield positions
