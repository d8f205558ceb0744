"""trunk compare: a run beside surfaces whose distance to it is known."""

import math
import unittest

from support import TrunkTest, coarse_run, shared_file

try:
    import h5py
    import numpy as np
except ImportError as missing:
    raise unittest.SkipTest(f"{missing}: apt install python3-h5py")

written = b""  # a run, once for all


def setUpModule():
    global written
    written = coarse_run()


def obj(points_mm, triangles):
    return "".join("v {:.9f} {:.9f} {:.9f}\n".format(*p) for p in points_mm) + \
        "".join("f {} {} {}\n".format(*(int(i) + 1 for i in t)) for t in triangles)


class Compare(TrunkTest):
    def setUp(self):
        super().setUp()
        self.file("r.h5", written)
        with h5py.File(self.folder / "r.h5") as file:
            self.frames = file["particles/trajectory/position/value"][()]
            self.times = file["particles/trajectory/position/time"][()]
            self.triangles = file["connectivity/triangles"][()]
            self.component = file["connectivity/triangle_component"][()]

    def lung(self, frame, move=(0, 0, 0)):
        """The run's own lung, mm."""
        return self.file("lung.obj", obj(1e3 * self.frames[frame] + move, self.triangles[self.component == 1]))

    def compare(self, surface, *options):
        return self.succeeds("compare", "r.h5", "--surface", surface, "--axes", "RAS", *options)

    def test_a_surface_of_the_run_itself_is_no_distance_away(self):
        for frame, at in ((0, "start"), (-1, "end"), (len(self.times) // 2, self.times[len(self.times) // 2])):
            with self.subTest(at=at):
                result = self.compare(self.lung(frame), "--at", at, "--region", "lung")
                self.assertEqual(result["schema"], "trunk.compare/1")
                self.assertAlmostEqual(result["time_s"], self.times[frame])
                self.assertLess(result["hausdorff_mm"], 1e-6)
                self.assertEqual(result["covered_percent"], 100)
                for both in ("model_to_surface", "surface_to_model"):
                    self.assertLess(result[both]["rms_mm"], 1e-6)

    def test_peak_is_the_largest_lung(self):
        corners = self.frames[:, self.triangles[self.component == 1]]
        volumes = np.einsum("ftx,ftx->f", corners[:, :, 0], np.cross(corners[:, :, 1], corners[:, :, 2])) / 6
        frame = int(volumes.argmax())
        result = self.compare(self.lung(frame), "--region", "lung")
        self.assertAlmostEqual(result["time_s"], self.times[frame])
        self.assertLess(result["hausdorff_mm"], 1e-6)

    def test_distances_are_signed(self):
        # A large plane-like bowl 10 mm below the whole diaphragm: all of it lies above.
        low = 1e3 * self.frames[0][:, 2].min()
        bowl = [(1000 * x, 700 * y, low - 10 - 20 * x * x - 20 * y * y) for x in (-1, 0, 1) for y in (-1, 0, 1)]
        squares = [(a, a + 3, a + 4) for a in (0, 1, 3, 4)] + [(a, a + 4, a + 1) for a in (0, 1, 3, 4)]
        below = self.compare(self.file("bowl.obj", obj(bowl, squares)), "--at", "start", "--surface-unit", "mm")
        self.assertTrue(all(d > 10 for d in below["signed_distance_mm"]))
        self.assertGreater(below["mean_signed_mm"], 10)
        above = self.compare(self.file("lid.obj", obj([(x, y, z + 1500) for x, y, z in bowl], squares)), "--at", "start",
                             "--surface-unit", "mm")
        self.assertTrue(all(d < 0 for d in above["signed_distance_mm"]))
        # Inside a closed surface is negative: an octahedron around the lung, its triangles turned at random.
        middle = 1e3 * self.frames[0][np.unique(self.triangles[self.component == 1])].mean(axis=0)
        corners = [middle + 700 * sign * np.eye(3)[axis] for axis in range(3) for sign in (1, -1)]
        sides = [(x, y, z) if (x + y + z) % 3 else (y, x, z) for x in (0, 1) for y in (2, 3) for z in (4, 5)]
        inside = self.compare(self.file("around.obj", obj(corners, sides)), "--at", "start", "--region", "lung",
                              "--surface-unit", "mm")
        self.assertTrue(all(d < 0 for d in inside["signed_distance_mm"]))

    def test_a_known_shift_is_measured(self):
        # Spheres of known distance in place of a trunk's surface would need a run of spheres; a shifted copy has
        # a largest distance of at most the shift, and of the shift where the surface faces along it.
        result = self.compare(self.lung(0, move=(0, 0, 7)), "--at", "start", "--region", "lung")
        self.assertLessEqual(result["hausdorff_mm"], 7 + 1e-6)
        self.assertGreater(result["hausdorff_mm"], 5)
        d = result["model_to_surface"]
        self.assertTrue(0 < d["median_mm"] <= d["percentile95_mm"] <= d["hausdorff_mm"])
        self.assertTrue(d["mean_mm"] <= d["rms_mm"])
        aligned = self.compare(self.lung(0, move=(0, 0, 7)), "--at", "start", "--region", "lung", "--align")
        self.assertLess(aligned["model_to_surface"]["rms_mm"], 0.2)
        self.assertAlmostEqual(aligned["aligned"]["shift_mm"][2], -7, delta=0.5)

    def test_maps(self):
        surface = self.lung(0, move=(0, 0, 7))
        result = self.compare(surface, "--at", "start", "--region", "lung", "-o", "map.csv")
        rows = (self.folder / "map.csv").read_text().splitlines()
        self.assertEqual(rows[0], "particle,x_mm,y_mm,z_mm,signed_distance_mm,at_border")
        self.assertEqual([int(row.split(",")[0]) for row in rows[1:]], result["particles"])
        for row, d in zip(rows[1:], result["signed_distance_mm"]):
            self.assertTrue(math.isclose(float(row.split(",")[4]), d))
        self.refused("compare", "r.h5", "--surface", surface, "-o", "map.csv", says="--force")
        self.compare(surface, "--at", "start", "--region", "lung", "-o", "map.vtp")
        try:
            import vtk
        except ImportError as missing:
            self.skipTest(f"{missing}: apt install python3-vtk9")
        reader = vtk.vtkXMLPolyDataReader()
        reader.SetFileName(str(self.folder / "map.vtp"))
        reader.Update()
        map_ = reader.GetOutput()
        self.assertEqual(map_.GetNumberOfPoints(), len(result["particles"]))
        values = map_.GetPointData().GetArray("signed_distance_mm")
        self.assertAlmostEqual(values.GetValue(3), result["signed_distance_mm"][3])

    def test_requests_that_cannot_be_met(self):
        surface = self.lung(0)
        self.refused("compare", "r.h5", "--surface", surface, "--at", "noon", says="moment 'noon'")
        self.refused("compare", "r.h5", "--surface", surface, "--at", "7", says="0 to ")
        self.refused("compare", "r.h5", "--surface", surface, "--region", "heart", says=("'heart'", "diaphragm"))
        self.refused("compare", "r.h5", "--surface", surface, "--axes", "up", says="'up'")
        self.refused("compare", "r.h5", "--surface", surface, "-o", "map.xyz", says="csv or .vtp")
        self.refused("compare", "r.h5", "--surface", "none.stl", says="none.stl: no such file")
        self.refused("compare", surface, "--surface", surface, says="lung.obj")
        self.refused("compare", "r.h5", "--surface", "r.h5", says="an HDF5 file found; expected a surface")

    def test_the_measured_diaphragm(self):
        surface = shared_file("surfaces/diaphragm.pml")
        outcome = self.trunk("compare", "r.h5", "--surface", surface, "--at", "start", "--align")
        self.assertEqual(outcome.code, 0, str(outcome))
        self.assertIn("guessed as LSA", outcome.err)
        result = self.succeeds("compare", "r.h5", "--surface", surface, "--at", "start", "--align")
        # The template is of another size, but of the same shape: 10 mm is a tenth of its depth.
        self.assertLess(result["surface_to_model"]["rms_mm"], 12)
        upside_down = self.trunk("compare", "r.h5", "--surface", surface, "--at", "start", "--align", "--axes", "LIA", "--json")
        self.assertEqual(upside_down.code, 3, str(upside_down))
        self.assertRegex(upside_down.err, r"--align turned the surface by \d\d degrees; expected at most 30")
        self.assertGreater(upside_down.json()["surface_to_model"]["rms_mm"], 1.3 * result["surface_to_model"]["rms_mm"])


if __name__ == "__main__":
    unittest.main()
