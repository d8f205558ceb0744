"""Parts and shells taken for a diaphragm, and lungs: what is registered is a whole trunk, or its doubts are said."""

import unittest

from test_bad_surface import ball
from test_register import dome

try:
    import numpy as np
    import surface_files
    from lungs import Lungs
    from test_faults_surfaces import LPS, RegisterTest, points_of
except ImportError as missing:
    raise unittest.SkipTest(f"{missing}: apt install python3-numpy")


class Shapes(RegisterTest):
    def test_half_a_diaphragm_is_no_half_trunk(self):
        points, triangles = points_of(dome())
        whole = self.registered(points, triangles, "--axes", "RAS")
        for name, sign in (("right", 1.0), ("left", -1.0)):
            half = triangles[(sign * points[triangles][:, :, 0].mean(1) > 0)]
            for options in (("--axes", "RAS"), ()):  # a part of a dome does not show its axes: RAS is assumed, and said
                with self.subTest(name, options=options):
                    report = self.registered(points, half, *options)
                    self.assertIn(f"the {name} half of one", " ".join(report["notes"]))
                    self.assertAlmostEqual(report["similarity"]["scale"], whole["similarity"]["scale"], delta=0.08)
                    self.assertLess(report["similarity"]["rotation_deg"], 5)
                    self.assertAlmostEqual(report["abdominal_volume_ml"] / whole["abdominal_volume_ml"], 1, delta=0.15)
                    self.assertIn("extrapolated", " ".join(report["notes"]))
                    if not options:
                        self.assertIn("axes assumed to be RAS", report["notes"][0])
        self.assertNotIn("half of one", " ".join(whole["notes"]))

    def test_a_thick_shell_is_taken_at_its_middle(self):
        points, triangles = points_of(dome())
        inner, outer = points * (1 - 4 / 120), points * (1 + 4 / 120)  # about 8 mm apart
        shell = np.concatenate((outer, inner)), np.concatenate((triangles, triangles[:, ::-1] + len(points)))
        report = self.registered(*shell, "--axes", "RAS")
        self.assertRegex(" ".join(report["notes"]), r"two sheets \d\.?\d* mm apart on \d+.* the middle between them is used")
        thin = self.registered(points, triangles, "--axes", "RAS")
        self.assertAlmostEqual(report["similarity"]["scale"], thin["similarity"]["scale"], delta=0.02)

    def test_an_island_far_away_is_left_out(self):
        points, triangles = points_of(dome())
        far = np.array([(x, y, z) for x in (300, 330) for y in (0, 30) for z in (100, 130)], float)
        box = np.array([(0, 1, 3), (0, 3, 2), (4, 7, 5), (4, 6, 7), (0, 5, 1), (0, 4, 5), (2, 3, 7), (2, 7, 6), (0, 2, 6),
                        (0, 6, 4), (1, 5, 7), (1, 7, 3)]) + len(points)
        report = self.registered(np.concatenate((points, far)), np.concatenate((triangles, box)), "--axes", "RAS")
        alone = self.registered(points, triangles, "--axes", "RAS")
        self.assertRegex(" ".join(report["notes"]), r"1 piece left out: small, and \d+ mm or more away")
        self.assertAlmostEqual(report["similarity"]["scale"], alone["similarity"]["scale"], delta=0.01)

    def test_shapes_that_are_no_diaphragm_are_named(self):
        points, triangles = points_of(dome(half_depth=140.0, front=0.0))
        self.assertIn("as deep as it is wide", self.registered(points, triangles, "--axes", "RAS", code=(0, 3))["stderr"])
        points, triangles = points_of(dome())
        top = triangles[points[triangles][:, :, 2].min(1) > 125.0]
        self.assertIn("cut short", self.registered(points, top, "--axes", "RAS", code=(0, 3))["stderr"])

    def test_two_lungs_stand_upright(self):
        lungs = Lungs(gap=65.0, fissures=True, spacing=(6.0, 6.0, 6.0))
        points, triangles = lungs.surface(lungs.right | lungs.left, smoothed=True)
        name = self.file("lungs.stl", surface_files.stl(points * LPS + np.array((10.0, 50.0, -900.0)), triangles))
        outcome = self.trunk("register", "--lungs", name, "-o", "me.pml", "--json")
        self.assertEqual(outcome.code, 0, str(outcome))
        report = outcome.json()
        self.assertLess(report["similarity"]["rotation_deg"], 5)
        whole = next(r for r in report["regions"] if r["region"] == "all")
        self.assertLessEqual(max(whole[way]["rms_mm"] for way in ("to_target", "from_target")), 5)

    def test_notes_also_stand_before_a_refusal(self):
        points, triangles = ball(12, 16)
        name = self.file("egg.stl", surface_files.stl(np.array(points) * (0.6, 0.8, 1.1), np.array(triangles), b""))
        outcome = self.trunk("register", "--lungs", name, "-o", "x.pml", "--axes", "RAS")
        self.assertEqual(outcome.code, 2, str(outcome))
        self.assertRegex(outcome.err, r"(?s)\Anote: .*unit taken as mm.*\ntrunk: .*does not say which one.*--lung-side")


if __name__ == "__main__":
    unittest.main()
