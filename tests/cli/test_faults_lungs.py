"""Lungs as segmentation programs export them become a trunk that stands upright: pairs, and one lung alone."""

import unittest

from support import TrunkTest

try:
    import numpy as np
    from lungs import Lungs, joined
    from surface_files import stl
except ImportError as missing:
    raise unittest.SkipTest(f"{missing}: apt install python3-numpy")

LPS, SCANNER = np.array((-1.0, -1.0, 1.0)), np.array((12.0, -180.0, -1300.0))  # mm


class LungTest(TrunkTest):
    def lung_file(self, name, points, triangles, axes=LPS):
        return self.file(name, stl(points * axes + SCANNER, triangles, b"exported"))

    def upright(self, *lungs, options=("--axes", "LPS"), turn=5.0, rms=5.0):
        arguments = [a for name in lungs for a in ("--lungs", name)]
        outcome = self.trunk("register", *arguments, *options, "-o", "me.pml", "--force", "--json")
        self.assertEqual(outcome.code, 0, str(outcome))
        report = outcome.json()
        whole = next(r for r in report["regions"] if r["region"] == "all")
        self.assertLess(report["similarity"]["rotation_deg"], turn)
        for way in ("to_target", "from_target"):
            self.assertLessEqual(whole[way]["rms_mm"], rms, way)
            self.assertLessEqual(whole[way]["p95_mm"], 2 * rms, way)
        self.assertEqual(report["folded_triangles"], 0)
        return report


class Pairs(LungTest):
    def check(self, lungs, smoothed):
        """In two files and in one, and each lung alone: for its own side."""
        right, left = lungs.surface(lungs.right, smoothed), lungs.surface(lungs.left, smoothed)
        self.lung_file("r.stl", *right)
        self.lung_file("l.stl", *left)
        self.lung_file("both.stl", *lungs.surface(lungs.right | lungs.left | lungs.trachea, smoothed))
        pair, one = self.upright("r.stl", "l.stl"), self.upright("both.stl")
        for report in (pair, one):  # the windpipe holds a few ml, fissures count as lung
            self.assertAlmostEqual(report["lungs_given_ml"] / lungs.volume_ml(), 1, delta=0.12)
            self.assertIn("two lungs at least", " ".join(report["notes"]))
        self.assertAlmostEqual(one["lung_volume_ml"] / pair["lung_volume_ml"], 1, delta=0.05)
        for name, side in (("r.stl", "right"), ("l.stl", "left")):
            alone = self.upright(name)
            self.assertIn(f"taken as the {side} one", " ".join(alone["notes"]))
            self.assertAlmostEqual(alone["similarity"]["scale"] / pair["similarity"]["scale"], 1, delta=0.15)

    def test_close_together_and_fine(self):
        self.check(Lungs(gap=40.0, spacing=(1.5, 1.5, 3.0)), smoothed=True)

    def test_with_fissures(self):
        self.check(Lungs(gap=60.0, fissures=True), smoothed=True)

    def test_far_apart_as_a_staircase(self):
        self.check(Lungs(gap=90.0), smoothed=False)

    def test_with_a_windpipe(self):
        self.check(Lungs(gap=60.0, trachea=True), smoothed=True)

    def test_everything_at_once(self):
        self.check(Lungs(gap=75.0, fissures=True, trachea=True), smoothed=False)

    def test_a_small_subject(self):
        self.check(Lungs(gap=50.0, size=0.85), smoothed=True)


class Shapes(LungTest):
    def test_two_lungs_show_their_axes(self):
        for gap, notch in ((50.0, True), (80.0, True)):
            lungs = Lungs(gap=gap, notch=notch, spacing=(4.0, 4.0, 4.0))
            points, triangles = joined(lungs.surface(lungs.right), lungs.surface(lungs.left))
            for letters, axes in (("RAS", (1, 1, 1)), ("LPS", (-1, -1, 1))):
                with self.subTest(letters, gap=gap):
                    name = self.lung_file("both.stl", points, triangles, np.array(axes))
                    report = self.upright(name, options=())
                    self.assertRegex(report["notes"][0], f"axes guessed as {letters}, since the files do not say them")
            self.lung_file("lps.stl", points, triangles, LPS)
            wrong = self.trunk("register", "--lungs", "lps.stl", "--axes", "RAS", "-o", "x.pml", "--force")
            self.assertRegex(wrong.err, r"\Anote: the axes are in doubt: with them .* check --axes")

    def test_walls_of_fissures_do_not_make_a_lung_smaller(self):
        """Lobes that share a wall: its edges have three triangles or more, and no volume is stated from them."""
        lungs = Lungs(gap=60.0, spacing=(4.0, 4.0, 4.0))
        low, high = lungs.right.copy(), lungs.right.copy()
        middle = lungs.right.shape[2] // 2
        low[:, :, middle:], high[:, :, :middle] = False, False
        surfaces = [lungs.surface(part, False) for part in (low, high, lungs.left)]
        name = self.lung_file("lobes.stl", *joined(*surfaces))
        report = self.upright(name)
        self.assertAlmostEqual(report["lungs_given_ml"] / lungs.volume_ml(), 1, delta=0.1)


if __name__ == "__main__":
    unittest.main()
