"""The surfaces of rigid parts along which the zone of apposition slides."""

import numpy as np

from oracle.elasticity import cross, dot, slopes, unit


class Planes:
    """normal . x <= offset, one a particle. The normal is not of unit length."""

    def __init__(self, normal, offset, moved_on):
        self.normal, self.offset = normal, offset
        self.moved_on = moved_on  # m, how far the part itself moves there in this step
        self.length = np.sqrt(dot(normal, normal))

    def excess(self, points):
        """How far outside, m."""
        return (dot(self.normal, points) - self.offset) / self.length

    def projected(self, points):
        return points - self.excess(points) * self.normal / self.length

    def along(self, vectors):
        outward = self.normal / self.length
        return vectors - dot(outward, vectors) * outward


class Ribs:
    """gap(y) = n.y + 1/2 c1 (e1.y)^2 + 1/2 c2 (e2.y)^2 is 0 on the surface opposite a particle and negative inside,
    with y relative to the particle's rest position and turned with the part.

    On the grid of muscle lines, the derivatives of the place x by line number and by row are central differences (by
    row at the top of the zone, where the next row is off the ribs, the one downward). They give the tangents; n is
    across both, outward; e1 is the tangent around the trunk, e2 is n x e1. c1 and c2 are the normal curvatures
    -x''.n / |x'|^2 around and upward, positive where the part is hollow; c2 is 0 at the top.
    """

    def __init__(self, anatomy, part_of, parts):
        """part_of: {particle: index in parts}"""
        self.parts, self.particles = parts, np.array(sorted(part_of), int)
        self.part = np.array([part_of[i] for i in self.particles], int)
        lines = anatomy.muscle_lines
        zone = np.isin(lines[0], anatomy.names["zone_of_apposition"])
        top = np.flatnonzero(zone)[-1]
        line, row = np.array([np.argwhere(lines[:, :top + 1] == i)[0] for i in self.particles], int).reshape(-1, 2).T
        is_top = row == top

        def at(lines_on, rows_up):
            return anatomy.rest[:, lines[(line + lines_on) % len(lines), row + rows_up]]

        self.point = at(0, 0)
        upper = np.where(is_top, self.point, at(0, 1) if top + 1 < lines.shape[1] else self.point)
        by_line, by_row = 0.5 * (at(1, 0) - at(-1, 0)), 0.5 * (upper - at(0, -1))
        self.outward = unit(cross(by_line, by_row))
        self.around = unit(by_line)
        self.upward = cross(self.outward, self.around)

        def curvature(second, first):
            return -dot(second, self.outward) / dot(first, first)

        self.curvature_around = curvature(at(1, 0) - 2.0 * self.point + at(-1, 0), by_line)
        self.curvature_upward = np.where(is_top, 0.0, curvature(upper - 2.0 * self.point + at(0, -1), by_row))

    def keep(self, wanted):
        """Leaves out the others."""
        for name in ("particles", "part"):
            setattr(self, name, getattr(self, name)[wanted])
        for name in ("point", "outward", "around", "upward", "curvature_around", "curvature_upward"):
            setattr(self, name, getattr(self, name)[..., wanted])

    def poses(self, t):
        """R [xyz, xyz, particles] and b [xyz, particles] of each particle's part."""
        poses = {number: self.parts[number].at(t) for number in np.unique(self.part)}
        turns, shifts = zip(*(poses[number] for number in self.part))
        return np.stack(turns, axis=2), np.concatenate(shifts, axis=1)

    def planes(self, predicted, positions, start, end):
        """Tangent to the surface of the gap's value 0, to first order, seen from where the particles are predicted."""
        if not len(self.particles):
            return Planes(np.zeros((3, 0)), np.zeros(0), np.zeros((3, 0)))
        turn, shift = self.poses(end)

        def gap(x):
            many = (slice(None), *(None,) * (x.ndim - 2))
            turned_back = np.einsum("ij...,i...->j...", turn[(slice(None), *many)], x - shift[many])
            y = turned_back - self.point[many]
            return (dot(self.outward[many], y)
                    + 0.5 * self.curvature_around * dot(self.around[many], y) ** 2
                    + 0.5 * self.curvature_upward * dot(self.upward[many], y) ** 2)

        x = predicted[:, self.particles]
        normal = slopes(lambda points: gap(points[:, 0]), x[:, None])[:, 0]
        before, shift_before = self.poses(start)
        place = np.einsum("ijp,ip->jp", before, positions[:, self.particles] - shift_before)
        moved_on = np.einsum("ijp,jp->ip", turn, place) + shift - positions[:, self.particles]
        return Planes(normal, dot(normal, x) - gap(x), moved_on)
