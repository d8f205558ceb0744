"""How the abdomen keeps its volume while the ribs are not crossed and rigid parts stay rigid."""

import numpy as np

from oracle.elasticity import dot
from oracle.volume import enclosed_volume, increasing_root, volume_gradient

ROUND_OFF = 2.0**-50  # of the volume


class VolumeAndRibs:
    """Moves predicted positions to the target volume along d = dV/dx / (m + dt c), with dV/dx at the start of the step,
    and back onto a rib plane where outside of it. Free rigid parts move as under an impulse along dV/dx. With a lung,
    they also move along a = dV_lung/dx / (m + dt c), by as much as the resistance to the flow of the step wants: one
    number within the search for the other."""

    def __init__(self, body):
        self.body, self.friction = body, body.friction
        supports = len(body.ribs.particles)
        self.touching = np.zeros(supports, bool)
        self.sticking = np.zeros(supports, bool)
        self.press = np.zeros(supports)  # m, how far the surfaces put particles back at the last step
        self.multiplier = self.pleural = 0.0

    def with_supports(self, positions, planes, where):
        """A copy in which those particles are on their planes."""
        particles = self.body.ribs.particles
        positions = positions.copy()
        at = positions[:, particles]
        positions[:, particles] = np.where(where, planes.projected(at), at)
        return positions

    def direction(self, positions):
        """d, from where the step starts."""
        body = self.body
        gradient = volume_gradient(positions, body.anatomy.surface)
        for part in body.free:
            part.prepare(gradient)
        return body.mobility * gradient / body.effective_mass

    def rub(self, predicted, positions, planes, correction):
        """Coulomb's law for those that touched at the last step, with the push and the multiplier of that step. A
        particle that would slide along the (moving) surface by less than friction times the push sticks, that is,
        goes where the surface goes and is not corrected along it; another slides less far by that much. A push of
        round-off, as at rest, makes nothing stick."""
        particles = self.body.ribs.particles
        stays = positions[:, particles] + planes.moved_on
        own = planes.along(predicted[:, particles] - stays)
        slide = planes.along(predicted[:, particles] + correction[:, particles] - stays)
        length, limit = np.sqrt(dot(slide, slide)), self.friction * self.press
        self.sticking = self.touching & (self.press > 1e-13) & (length < limit)
        held_back = np.where(self.sticking, own, limit / np.maximum(length, 1e-150) * slide)
        predicted = predicted.copy()
        predicted[:, particles] -= np.where(self.touching, held_back, 0.0)
        return predicted

    def solve(self, predicted, positions, moved, planes, volume):
        """Positions of the target volume. moved: in the last step"""
        body, particles = self.body, self.body.ribs.particles
        direction = self.direction(positions)
        lung = body.lung
        if lung:
            gradient = lung.gradient(positions)
            push = body.mobility * gradient / body.effective_mass
        else:
            push = np.zeros_like(direction)
        if self.friction > 0.0:
            before = -body.dt * lung.resistance * (gradient * moved).sum() if lung else 0.0
            predicted = self.rub(predicted, positions, planes, self.multiplier * direction + before * push)
        held = np.zeros(predicted.shape[1], bool)

        def supported(multiplier, pleural):
            free = predicted + multiplier * direction + pleural * push
            outside = planes.excess(free[:, particles]) > 0.0
            held[particles] = outside & self.sticking
            places = self.with_supports(np.where(held, predicted, free), planes, outside)
            for part in body.free:
                places[:, part.particles] = part.corrected(multiplier)
            return places

        def corrected(multiplier):
            if lung:
                self.pleural = lung.resisted(lambda mu: supported(multiplier, mu), positions, gradient, self.pleural)
            return supported(multiplier, self.pleural)

        def excess_volume(multiplier):
            return enclosed_volume(corrected(multiplier), body.anatomy.surface) - volume

        guess = -2.0 * excess_volume(0.0) / self.compliance(predicted, direction)
        self.multiplier = increasing_root(excess_volume, guess, ROUND_OFF * volume)
        places = corrected(self.multiplier)
        excess = planes.excess((predicted + self.multiplier * direction + self.pleural * push)[:, particles])
        self.touching, self.press = excess > 0.0, np.maximum(excess, 0.0)
        for part in body.free:
            part.accept(self.multiplier)
        return places

    def compliance(self, predicted, direction):
        """About dV by unit of the multiplier, m5/(N s2): only to begin the search with."""
        body = self.body
        gradient = volume_gradient(predicted, body.anatomy.surface)
        direction = direction.copy()
        for part in body.free:
            direction[:, part.particles] = part.push
        return (gradient * direction).sum()
