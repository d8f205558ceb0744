"""Lungs as a segmentation program exports them: label maps of our own, as a staircase of voxels or smoothed."""

import numpy as np

SPACING = (3.0, 3.0, 4.0)  # mm


class Lungs:
    """Two lungs in a tapering chest over two domes, in mm, RAS: `gap` mm apart, with a notch for the heart."""

    def __init__(self, gap=60.0, notch=True, fissures=False, trachea=False, size=1.0, spacing=SPACING):
        self.spacing = np.array(spacing)
        self.low = np.array((-170.0, -130.0, -20.0)) * size
        counts = np.ceil((np.array((170.0, 130.0, 330.0)) * size - self.low) / self.spacing).astype(int)
        grid = np.meshgrid(*(self.low[k] + self.spacing[k] * (np.arange(counts[k]) + 0.5) for k in range(3)), indexing="ij")
        x, y, z = (g / size for g in grid)
        top = np.clip(1.0 - (np.clip(z, 0.0, None) / 255.0) ** 2.6, 0.0, None) ** 0.5
        chest = (x / (138.0 * top + 1e-9)) ** 2 + ((y + 8.0 * (1 - top)) / (98.0 * top + 1e-9)) ** 2 < 1.0
        side = np.sign(x)
        height = np.where(side > 0, 98.0, 88.0)
        dome = height * (1.0 - ((np.abs(x) - 62.0) / 92.0) ** 2 - ((y - 12.0) / 120.0) ** 2) + 0.35 * (y + 95.0) - 20.0
        # Between the domes lies the central tendon: there the lungs end, too.
        above = (z > dome) & (z > 4.0 + 0.25 * (y + 95.0))
        both = chest & above & (np.abs(x) > 0.5 * gap / size) & (z < 258.0)
        if notch:
            both &= ((x + 28.0) / 58.0) ** 2 + ((y - 45.0) / 55.0) ** 2 + ((z - 120.0) / 62.0) ** 2 > 1.0
        if fissures:  # oblique in both, and a level one in the right lung; a voxel wide
            both &= np.abs(z - 130.0 - 1.1 * y) > 2.5
            both &= ~((x > 0) & (y > -5.0) & (np.abs(z - 132.0) < 2.5))
        self.right, self.left = both & (x > 0), both & (x < 0)
        self.trachea = np.zeros_like(both)
        if trachea:
            self.trachea |= (x ** 2 + (y + 25.0) ** 2 < 81.0) & (z > 160.0) & (z < 300.0)
            self.trachea |= ((y + 25.0) ** 2 + (z - 165.0 + 0.35 * np.abs(x)) ** 2 < 49.0) & (np.abs(x) < 0.5 * gap / size + 12.0)

    def volume_ml(self):
        return float((self.right | self.left).sum() * self.spacing.prod() * 1e-3)

    def surface(self, label, smoothed=True):
        """Points, mm, and triangles of the border of a label."""
        label = np.pad(label, 1)
        corners, key = [], np.array(label.shape) + 1
        for axis in range(3):
            for way in (1, -1):
                border = label & ~np.roll(label, -way, axis)
                cells = np.argwhere(border)
                along, across = np.eye(3, dtype=int)[(axis + 1) % 3], np.eye(3, dtype=int)[(axis + 2) % 3]
                first = cells + (np.eye(3, dtype=int)[axis] if way > 0 else 0)
                quad = [first, first + along, first + along + across, first + across]
                corners.append(np.stack(quad if way > 0 else quad[::-1], 1))
        corners = np.concatenate(corners)
        number = (corners[..., 0] * key[1] + corners[..., 1]) * key[2] + corners[..., 2]
        unique, quads = np.unique(number, return_inverse=True)
        quads = quads.reshape(-1, 4)
        index = np.stack((unique // (key[1] * key[2]), unique // key[2] % key[1], unique % key[2]), 1)
        points = self.low + self.spacing * (index - 1.0)
        if smoothed:
            points = self.smooth(points, quads)
        return points, np.concatenate((quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]))

    @staticmethod
    def smooth(points, quads, rounds=12):
        """Taubin's smoothing, which shrinks nothing."""
        a = np.concatenate([quads[:, k] for k in range(4)])
        b = np.concatenate([quads[:, (k + 1) % 4] for k in range(4)])
        count = np.bincount(a, minlength=len(points)) + np.bincount(b, minlength=len(points))
        for share in (0.5, -0.53) * rounds:
            mean = np.stack([np.bincount(a, points[b, k], len(points)) + np.bincount(b, points[a, k], len(points))
                             for k in range(3)], 1) / np.maximum(count, 1)[:, None]
            points = points + share * (mean - points)
        return points


def joined(*surfaces):
    points, triangles, before = [], [], 0
    for p, t in surfaces:
        points.append(p)
        triangles.append(t + before)
        before += len(p)
    return np.concatenate(points), np.concatenate(triangles)
