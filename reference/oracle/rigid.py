"""Rigid parts. A part is where x = R x_rest + b takes its rest shape; R is a matrix throughout."""

import numpy as np

from oracle.elasticity import cross


def cross_matrix(a):
    """[a]x: [a]x b = a x b."""
    return np.array([[0.0, -a[2], a[1]], [a[2], 0.0, -a[0]], [-a[1], a[0], 0.0]])


def rotation(axis, angle):
    """By `angle` rad around a unit vector (Rodrigues): the part along the axis, the rest turned within its plane."""
    along = np.outer(axis, axis)
    return along + np.cos(angle) * (np.eye(3) - along) + np.sin(angle) * cross_matrix(axis)


def cayley(angle):
    """(1 - [angle]x / 2)^-1 (1 + [angle]x / 2): what the implicit midpoint rule makes of a turn by `angle` rad."""
    half = 0.5 * cross_matrix(angle)
    return np.linalg.solve(np.eye(3) - half, np.eye(3) + half)


class Fixed:
    """Carries its particles by holding them, no more: an imposed displacement may still shift them."""
    moves = False

    def __init__(self, particles):
        self.particles = particles

    def at(self, _):
        return np.eye(3), np.zeros((3, 1))


class Driven:
    """Turned by angle(t) around an axis through a point, then shifted by a length(t) along a direction."""
    moves = True

    def __init__(self, particles, rest, part, course):
        self.particles, self.rest = particles, rest[:, particles]
        self.point = 1e-3 * np.array(part.get("axis_point_mm", [0.0, 0.0, 0.0]))
        self.axis = np.array(part.get("axis", [0.0, 0.0, 1.0]))
        self.direction = np.array(part.get("direction", [0.0, 0.0, 0.0]))
        nothing = lambda t: 0.0
        self.angle = course(part, "events_deg", np.pi / 180.0) if "events_deg" in part else nothing
        self.shift = course(part, "events_mm", 1e-3) if "events_mm" in part else nothing

    def at(self, t):
        turn = rotation(self.axis, self.angle(t))
        return turn, (self.point - turn @ self.point + self.shift(t) * self.direction)[:, None]

    def places(self, t):
        turn, shift = self.at(t)
        return turn @ self.rest + shift


class Free:
    """Newton's and Euler's laws, M dv/dt = F - C v and dL/dt = torque - (C/M) L about the centre of mass, with M and
    C the sums of its particles' masses and damping. Each step takes F and the torque from its start, C from its
    end, and turns by the Cayley transform of dt times the angular velocity."""

    def __init__(self, particles, rest, mass, damping, dt):
        self.particles, self.masses, self.dt = particles, mass[particles], dt
        self.mass = self.masses.sum()
        self.effective_mass = self.mass + dt * damping[particles].sum()
        self.kept = self.mass / self.effective_mass
        self.centre = rest[:, particles] @ self.masses[:, None] / self.mass
        self.arms_at_rest = rest[:, particles] - self.centre
        self.turn = np.eye(3)
        self.velocity, self.momentum = np.zeros((3, 1)), np.zeros(3)  # m/s; angular, kg m2/s

    def spin(self, turn, momentum):
        """Angular velocity: inertia, from the particles where they are, times it is the angular momentum."""
        arms = turn @ self.arms_at_rest
        spread = (self.masses * arms) @ arms.T
        return np.linalg.solve(np.trace(spread) * np.eye(3) - spread, momentum)

    def predict(self, force):
        """Moves on, free of constraints. Returns the particles' places."""
        on, dt = force[:, self.particles], self.dt
        velocity = (self.mass * self.velocity + dt * on.sum(axis=1, keepdims=True)) / self.effective_mass
        torque = cross(self.turn @ self.arms_at_rest, on).sum(axis=1)
        self.next_momentum = self.kept * (self.momentum + dt * torque)
        self.next_centre = self.centre + dt * velocity
        self.next_turn = cayley(dt * self.spin(self.turn, self.next_momentum)) @ self.turn
        return self.next_turn @ self.arms_at_rest + self.next_centre

    def prepare(self, gradient):
        """What an impulse of dV/dx on its particles does to it, by unit of the multiplier."""
        on = gradient[:, self.particles]
        self.push = on.sum(axis=1, keepdims=True) / self.effective_mass
        self.twist = self.kept * cross(self.turn @ self.arms_at_rest, on).sum(axis=1)
        self.turning = self.spin(self.next_turn, self.twist)

    def corrected(self, multiplier):
        """Its particles' places after that much of the impulse: still the rest shape."""
        turn = cayley(multiplier * self.turning) @ self.next_turn
        return turn @ self.arms_at_rest + self.next_centre + multiplier * self.push

    def accept(self, multiplier):
        centre = self.next_centre + multiplier * self.push
        self.velocity = (centre - self.centre) / self.dt
        self.momentum = self.next_momentum + multiplier / self.dt * self.twist
        self.turn = cayley(multiplier * self.turning) @ self.next_turn
        self.centre = centre
