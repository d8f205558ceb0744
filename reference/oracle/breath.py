"""One breath: the forces of a moment, the step, the course."""

import numpy as np

from oracle.constraint import VolumeAndRibs
from oracle.elasticity import shape_memory


MOST_BREATHS = 200  # until breathing repeats


def activation(timing, t, breath_s=None):
    """A(t): a linear rise to 1, a fast fall to a level, a slow fall to 0. In breathing that repeats, every `breath_s`
    if the timing has no period of its own, it lasts from one onset to the next."""
    period, onset = timing["period_s"], timing["onset_s"]
    if breath_s is not None:
        t = onset + (t - onset) % (period if period > 0.0 else breath_s)
    elif period > 0.0:
        t %= period
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
    if body.lung:
        force += body.lung.force(positions, t)
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


class Motion:
    """Where the particles are and how fast, and what the constraint remembers."""

    def __init__(self, body, timing):
        self.body, self.timing = body, timing
        self.positions, self.velocity = body.rest, np.zeros_like(body.rest)
        self.constraint = VolumeAndRibs(body)

    def breath(self):
        """Yields the positions after each step of one breath."""
        body, breath_s = self.body, self.body.breath_s if self.body.periodic else None
        for step in range(body.steps):
            t, end = step * body.dt, (step + 1) * body.dt
            active = activation(self.timing, t, breath_s)
            predicted = predict(body, self.positions, self.velocity, active, t, end)
            planes = body.ribs.planes(predicted, self.positions, t, end)
            moved = body.dt * self.velocity  # in the last step
            corrected = self.constraint.solve(predicted, self.positions, moved, planes, body.target(end))
            self.velocity = (corrected - self.positions) / body.dt
            self.positions = corrected
            yield corrected


def simulate(body, timing):
    """Yields the positions at step 0 and after each step. If breathing repeats, step 0 is the end of whole breaths
    from rest: as many as it takes until one ends where it began, to 1e-9 m."""
    motion = Motion(body, timing)
    for _ in range(MOST_BREATHS if body.periodic else 0):
        began = motion.positions
        for _ in motion.breath():
            pass
        if abs(motion.positions - began).max() < 1e-9:
            break
    yield motion.positions
    yield from motion.breath()
