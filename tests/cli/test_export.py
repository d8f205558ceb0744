"""trunk export --pml: what it writes simulates to the same trajectory; what it refuses."""

import shutil
import unittest

from support import COARSE, FAST_FIT, HEALTHY, NO_LUNG, SCENARIOS, SHORT_BREATH, TrunkTest, scenario_with, trace

try:
    import h5py
    import numpy as np
except ImportError as missing:
    raise unittest.SkipTest(f"{missing}: apt install python3-h5py")

# Without a lung: that would act on the free part.
LOADED = f"""extends = "{NO_LUNG}"
gravity_m_s2 = [0, 0.5, 0]
abdominal_volume_fraction = [[0, 1], [1, 0.99]]

[tissue]
rib_friction = 0.1
membrane_stiffness_N_per_m = 50

[[force]]
region = "central_tendon"
direction = [0.1, 0, 1]
events_N = [[0, 0], [0.2, 0.5]]

[[pressure]]
region = "abdominal_wall,pelvis"
events_cmH2O = [[0, 0], [0.1, 2]]

[[pressure]]
region = "central_tendon"
direction = [0, 0, -1]
events_cmH2O = [[0, 1]]

[[acceleration]]
region = "*"
direction = [0, 0, -1]
events_m_s2 = [[0, 0], [0.1, 3]]

[[displacement]]
region = "20,21"
direction = [3, 0, 1]
axes = [0, 1, 1]
events_mm = [[0, 0], [0.2, 2]]

[[rigid]]
region = "rib_cage_right"
motion = "driven"
surface_for = "zone_of_apposition_right"
axis = [0, 1, 0]
axis_point_mm = [0, 0, 600]
events_deg = [[0, 0], [0.3, -1]]

[[rigid]]
region = "rib_cage_left"
motion = "driven"
surface_for = "zone_of_apposition_left"
direction = [-1, 0, 0.5]
events_mm = [[0, 0], [0.3, 3]]

[[rigid]]
region = "dome_top_right"
motion = "free"
"""


class ExportTest(TrunkTest):
    def positions(self, name, group=""):
        with h5py.File(self.folder / name) as file:
            return file[f"{group}particles/trajectory/position/value"][()]

    def check_same_motion(self, name, folder, group="", tolerance=1e-12):
        self.succeeds("simulate", f"{folder}/scenario.toml", "-o", "again.h5", "--force")
        before, after = self.positions(name, group), self.positions("again.h5")
        self.assertEqual(before.shape, after.shape)
        self.assertGreater(np.abs(before - before[0]).max(), 1e-4, "nothing moves")
        self.assertLessEqual(np.abs(before - after).max(), tolerance)

    def simulate(self, scenario, *more):
        return self.succeeds("simulate", scenario, "-o", "r.h5", "--force", *COARSE, *more)

    def export(self, name="r.h5", folder="out", *more):
        return self.succeeds("export", name, "--pml", folder, *more)


class SameMotion(ExportTest):
    def test_shipped_scenarios_over_a_whole_breath(self):
        for name in ("healthy", "hemiparalysis_right", "published_healthy"):
            with self.subTest(name):
                self.succeeds("simulate", SCENARIOS / f"{name}.toml", "-o", "r.h5", "--force")
                written = self.export("r.h5", name)
                self.assertEqual(written["schema"], "trunk.export/1")
                self.assertEqual(written["files"], [f"{name}/trunk.pml", f"{name}/scenario.toml"])
                self.check_same_motion("r.h5", name)
        healthy, paralysed = ((self.folder / name / "trunk.pml").read_text().splitlines()
                              for name in ("healthy", "hemiparalysis_right"))
        changed = [a for a, b in zip(healthy, paralysed) if a != b]
        self.assertEqual([a for a in changed if "name=" not in a], [])  # the title alone
        self.assertIn('side = "right"', (self.folder / "hemiparalysis_right/scenario.toml").read_text())

    def test_loads_and_rigid_parts(self):
        own = self.file("own.toml", LOADED)
        self.simulate(own)
        written = self.export()
        self.assertEqual(written["files"], ["out/trunk.pml", "out/loads.lml", "out/scenario.toml"])
        self.check_same_motion("r.h5", "out")
        scenario = (self.folder / "out/scenario.toml").read_text()
        self.assertIn('loads = "loads.lml"', scenario)
        self.assertNotIn("[[force]]", scenario)
        self.assertEqual((self.folder / "out/loads.lml").read_text().count("<load "), 5)

    def test_each_load_counts(self):
        """A trajectory that would be the same without them shows nothing."""
        self.simulate(self.file("own.toml", LOADED))
        before = self.positions("r.h5")
        tables = LOADED.split("\n\n[[")
        for skip in range(1, len(tables)):
            with self.subTest(tables[skip].splitlines()[0]):
                self.simulate(self.file("less.toml", "\n\n[[".join(tables[:skip] + tables[skip + 1:])))
                self.assertGreater(np.abs(self.positions("r.h5") - before).max(), 1e-6)

    def test_finer_mesh(self):
        self.simulate(HEALTHY, "--set", "geometry.resolution=2", "--set", "time.dt_ms=0.5")
        self.export()
        self.check_same_motion("r.h5", "out")
        self.assertEqual(self.positions("again.h5").shape[1], 455)

    def test_fit(self):
        self.file("t.csv", trace())
        self.file("short.toml", scenario_with(SHORT_BREATH))
        self.succeeds("fit", "short.toml", "--trace", "t.csv", "-o", "fit.h5", *FAST_FIT, codes=(0, 4))
        self.export("fit.h5")
        self.check_same_motion("fit.h5", "out", "best_run/")

    def test_run_whose_trunk_file_is_gone(self):
        self.simulate(HEALTHY)
        self.export()
        self.succeeds("simulate", "out/scenario.toml", "-o", "second.h5")
        before = self.positions("second.h5")
        shutil.rmtree(self.folder / "out")
        self.export("second.h5", "again")
        self.check_same_motion("second.h5", "again")
        self.assertLessEqual(np.abs(self.positions("r.h5") - before).max(), 1e-12)
        again = (self.folder / "again/scenario.toml").read_text()
        self.assertIn('pml = "trunk.pml"', again)
        self.assertNotIn(str(self.folder), again)  # can be carried elsewhere
        (self.folder / "again").rename(self.folder / "elsewhere")
        self.check_same_motion("second.h5", "elsewhere")

    def test_exported_twice_is_the_same(self):
        self.simulate(self.file("own.toml", LOADED))
        self.export("r.h5", "one")
        self.succeeds("simulate", "one/scenario.toml", "-o", "second.h5")
        self.export("second.h5", "two")
        for name in ("trunk.pml", "loads.lml"):
            self.assertEqual((self.folder / "one" / name).read_text(), (self.folder / "two" / name).read_text(), name)
        self.assertNotIn("trunk_pml", h5py.File(self.folder / "r.h5")["parameters"])
        self.assertIn("trunk_pml", h5py.File(self.folder / "second.h5")["parameters"])


class Refusals(ExportTest):
    def setUp(self):
        super().setUp()
        self.simulate(HEALTHY)

    def test_existing_files_need_force(self):
        self.export()
        self.refused("export", "r.h5", "--pml", "out", says=("out/trunk.pml", "--force"))
        (self.folder / "out/trunk.pml").unlink()
        outcome = self.trunk("export", "r.h5", "--pml", "out")
        self.assertEqual((outcome.code, outcome.out), (2, ""))
        self.assertRegex(outcome.err, "out/scenario.toml.*--force")
        self.assertEqual([p.name for p in (self.folder / "out").iterdir()], ["scenario.toml"])  # no half
        self.export("r.h5", "out", "--force")
        self.check_same_motion("r.h5", "out")

    def test_existing_folder_with_other_things(self):
        (self.folder / "out").mkdir()
        self.file("out/notes.txt", "mine")
        self.export()
        self.assertEqual((self.folder / "out/notes.txt").read_text(), "mine")

    def test_files_that_are_no_run(self):
        self.file("foreign.h5", "not HDF5")
        with h5py.File(self.folder / "other.h5", "w") as other:
            other["x"] = 1
        self.refused("export", "foreign.h5", "--pml", "out", says="foreign.h5: is not an HDF5 file")
        self.refused("export", "other.h5", "--pml", "out", says="other.h5")
        self.refused("export", "none.h5", "--pml", "out", says="none.h5: no such file")
        self.refused("export", HEALTHY, "--pml", "out", says="healthy.toml")
        truncated = (self.folder / "r.h5").read_bytes()[:20000]
        self.file("cut.h5", truncated)
        self.refused("export", "cut.h5", "--pml", "out", says="cut.h5")

    def test_sweep(self):
        self.file("short.toml", scenario_with(SHORT_BREATH))
        self.file("sweep.toml", 'schema = "trunk.sweep/1"\nscenarios = ["short.toml"]\n'
                                '[grid]\n"parameters.k_muscle_N_per_m" = [30]\n')
        outcome = self.trunk("sweep", "sweep.toml", "-o", "s")
        self.assertEqual(outcome.code, 0, str(outcome))
        self.refused("export", "s/sweep.h5", "--pml", "out", says=("s/sweep.h5", "sweep", "expected a run or a fit"))

    def test_folder_that_cannot_be(self):
        self.file("plain", "a file")
        self.refused("export", "r.h5", "--pml", "plain", says="plain")
        self.refused("export", "r.h5", "--pml", "plain/inside", says="plain/inside")

    def test_usage(self):
        self.refused("export", "r.h5", says="--pml DIR")
        self.refused("export", "--pml", "out", says="FILE")
        self.refused("export", "r.h5", "--pml", says="--pml")
        self.refused("export", "r.h5", "--pml", "out", "--json", "extra", says="extra")

    def test_table_on_a_terminal(self):
        outcome = self.trunk("export", "r.h5", "--pml", "out")
        self.assertEqual((outcome.code, outcome.err), (0, ""))
        self.assertRegex(outcome.out, r"Written: out/trunk.pml out/scenario.toml\n.*trunk simulate out/scenario.toml")


if __name__ == "__main__":
    unittest.main()
