"""trunk diff, replay, export --csv and --vtk: what they say of files written by the program."""

import csv
import unittest

from support import COARSE, FAST_FIT, HEALTHY, TrunkTest, trace

try:
    import h5py
    import numpy as np
except ImportError as missing:
    raise unittest.SkipTest(f"{missing}: apt install python3-h5py")

PARALYSED = ("--set", "paralysis.side=right")
STIFFER = ("--set", "parameters.k_elasticity_N_per_m=1930.1")


class Afterwards(TrunkTest):
    def simulate(self, name, *more, **options):
        return self.succeeds("simulate", HEALTHY, "-o", name, *COARSE, *more, **options)

    def fit(self, name="fit.h5", *more):
        self.file("t.csv", trace())
        return self.succeeds("fit", HEALTHY, "--trace", "t.csv", "-o", name, *FAST_FIT, *more, codes=(0, 4))

    def names(self, json):
        return [f"{d['group']} {d['name']}" for d in json["differences"]]


class Diff(Afterwards):
    def test_two_runs(self):
        healthy, other = self.simulate("a.h5"), self.simulate("b.h5", *STIFFER)
        self.simulate("again.h5")
        same = self.succeeds("diff", "a.h5", "again.h5")
        self.assertEqual((same["schema"], same["same"], same["differences"], same["farthest_m"]), ("trunk.diff/1", True, [], 0))
        self.assertGreater(same["compared"], 30)
        json = self.succeeds("diff", "a.h5", "b.h5", codes=(1,))
        self.assertFalse(json["same"])
        found = dict(zip(self.names(json), json["differences"]))
        self.assertEqual((found["parameters k_elasticity"]["first"], found["parameters k_elasticity"]["second"]), (1930, 1930.1))
        volume = found["measures delta_v_ml"]
        self.assertEqual((volume["first"], volume["second"], volume["unit"]), (healthy["delta_v_ml"], other["delta_v_ml"], "ml"))
        self.assertIn("curves dV_model", found)
        self.assertNotIn("parameters k_muscle", found)
        self.assertNotIn("curves activation", found)
        self.assertTrue(self.succeeds("diff", "a.h5", "b.h5", "--tolerance", "0.01")["same"])

    def test_with_and_without_trajectory(self):
        self.simulate("a.h5")
        self.simulate("b.h5", "--every", "0")
        self.assertTrue(self.succeeds("diff", "a.h5", "b.h5")["same"])

    def test_two_fits(self):
        self.fit("a.h5")
        self.fit("b.h5", "--fix", "damping=21", "--timing", "trace")
        self.assertTrue(self.succeeds("diff", "a.h5", "a.h5")["same"])
        found = self.names(self.succeeds("diff", "a.h5", "b.h5", codes=(1,)))
        for name in ("parameters damping", "parameters k_elasticity", "statistics nrmse_percent", "result dV_fit"):
            self.assertIn(name, found)
        self.assertNotIn("result measured", found)

    def test_as_a_table(self):
        self.simulate("a.h5")
        self.simulate("b.h5", *PARALYSED)
        outcome = self.trunk("diff", "a.h5", "b.h5")
        self.assertEqual((outcome.code, outcome.err), (1, ""))
        self.assertRegex(outcome.out, r"a.h5 and b.h5: \d+ of \d+ differ")
        self.assertRegex(outcome.out, r"  measures delta_v_ml +[\d.]+ +[\d.]+ +-[\d.]+ ml\n")
        self.assertRegex(outcome.out, r"  trajectory particle \d+ [xyz] .* m at [\d.]+ s\n")
        self.assertRegex(self.trunk("diff", "a.h5", "a.h5").out, "the same: 4[0-9] numbers")

    def test_refusals(self):
        self.simulate("a.h5")
        self.fit()
        self.refused("diff", "a.h5", "fit.h5", says="fit.h5: is a fit; expected a run, like the first file")
        self.refused("diff", "fit.h5", "a.h5", says="a.h5: is a run; expected a fit, like the first file")
        self.refused("diff", "a.h5", "none.h5", says="none.h5: no such file")
        self.refused("diff", "a.h5", says="SECOND")
        self.refused("diff", "a.h5", "a.h5", "--tolerance", "-1", says="--tolerance")
        self.refused("diff", "a.h5", "a.h5", "--absolute", "nan", says="--absolute")


class Replay(Afterwards):
    def check_same(self, name):
        json = self.succeeds("replay", name)
        self.assertEqual((json["schema"], json["same"], json["differences"]), ("trunk.replay/1", True, []))
        self.assertLess(json["farthest_m"], 1e-12)
        self.assertEqual(json["written_by"], json["replayed_by"])
        return json["compared"]

    def test_from_the_file_alone(self):
        self.file("mine.toml", f'extends = "{HEALTHY}"\n[paralysis]\nside = "left"\n')
        self.succeeds("simulate", "mine.toml", "-o", "a.h5", *COARSE)
        (self.folder / "mine.toml").unlink()
        compared = self.check_same("a.h5")
        self.assertGreater(compared, 30)
        self.simulate("summary.h5", "--every", "0")
        self.assertEqual(self.check_same("summary.h5"), compared - 1)  # no trajectory
        self.succeeds("export", "a.h5", "--pml", "mine")
        self.succeeds("simulate", "mine/scenario.toml", "-o", "b.h5")
        (self.folder / "mine/trunk.pml").unlink()
        self.check_same("b.h5")

    def test_the_best_run_of_a_fit(self):
        self.fit()
        self.check_same("fit.h5")

    def test_a_run_that_diverged_diverges_again(self):
        weight = ('[[force]]\nregion = "central_tendon"\ndirection = [0, 0, 1]\nevents_N = [[0, 1e6]]\n')
        self.file("mine.toml", f'extends = "{HEALTHY}"\n{weight}')
        json = self.succeeds("simulate", "mine.toml", "-o", "a.h5", *COARSE, codes=(3,))
        self.assertNotEqual(json["status"], "completed")
        self.check_same("a.h5")

    def test_a_file_that_says_something_else(self):
        """Numbers changed by hand are found."""
        self.simulate("a.h5")
        with h5py.File(self.folder / "a.h5", "r+") as file:
            file["measures/delta_v_ml"][()] += 1
            file["particles/trajectory/position/value"][5, 40, 2] += 0.001
        json = self.succeeds("replay", "a.h5", codes=(1,))
        self.assertEqual(self.names(json), ["measures delta_v_ml", "trajectory particle 40 z"])
        self.assertAlmostEqual(json["farthest_m"], 0.001, delta=1e-9)
        outcome = self.trunk("replay", "a.h5")
        self.assertEqual((outcome.code, outcome.err), (1, ""))
        self.assertRegex(outcome.out, "2 of [0-9]+ differ: stored, replayed, difference")

    def test_sweeps_are_refused(self):
        design = self.file("s.toml", f'schema = "trunk.sweep/1"\nscenarios = ["{HEALTHY}"]\n[grid]\n'
                                     '"time.dt_ms" = [3]\n"time.duration_s" = [0.3]\n')
        self.succeeds("sweep", design, "-o", "d")
        for command in (("replay", "d/sweep.h5"), ("diff", "d/sweep.h5", "d/sweep.h5"), ("export", "d/sweep.h5", "--csv", "out")):
            self.refused(*command, says="d/sweep.h5: is a sweep[;,] expected a run or a fit")


class Csv(Afterwards):
    def table(self, name):
        with open(self.folder / "out" / name, encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    def column(self, rows, name):
        return np.array([float(row[name]) for row in rows])

    def test_run(self):
        json = self.simulate("a.h5", *PARALYSED)
        written = self.succeeds("export", "a.h5", "--csv", "out")
        self.assertEqual(written["files"], [f"out/{n}.csv" for n in ("curves", "measures", "parameters", "frames", "positions",
                                                                     "particles", "triangles", "fibres")])
        self.assertEqual({r["name"]: float(r["value"]) for r in self.table("measures.csv")},
                         {k: json[k] for k in (r["name"] for r in self.table("measures.csv"))})
        with h5py.File(self.folder / "a.h5") as file:
            curves = self.table("curves.csv")
            np.testing.assert_array_equal(self.column(curves, "time_s"), file["curves/time"])
            np.testing.assert_array_equal(self.column(curves, "dV_model_ml"), file["curves/dV_model"])
            np.testing.assert_array_equal(self.column(curves, "abdominal_pressure_cmH2O"), file["curves/abdominal_pressure"])
            frames = self.table("frames.csv")
            np.testing.assert_array_equal(self.column(frames, "excursion_right_mm"), file["observables/excursion_right/value"])
            places, stored = self.table("positions.csv"), file["particles/trajectory"]
            shape = stored["position/value"].shape
            for axis in range(3):
                for name, quantity in (("{}_m", "position"), ("v{}_m_per_s", "velocity")):
                    values = self.column(places, name.format("xyz"[axis])).reshape(shape[:2])
                    np.testing.assert_array_equal(values, stored[quantity + "/value"][:, :, axis])
            np.testing.assert_array_equal(self.column(places, "contact").reshape(shape[:2]), stored["contact/value"])
            self.assertEqual([places[i][k] for i, k in ((0, "time_s"), (113, "particle"))], ["0", "0"])
            triangles = self.table("triangles.csv")
            self.assertEqual([[int(t[c]) for c in "abc"] for t in triangles], file["connectivity/triangles"][()].tolist())
        self.assertEqual({p["region"] for p in self.table("particles.csv")} & {"pelvis", "central_tendon"},
                         {"pelvis", "central_tendon"})
        self.assertEqual({f["activity"] for f in self.table("fibres.csv")}, {"0", "0.5", "1"})  # on the midline half

    def test_fit(self):
        json = self.fit("fit.h5", "--surface", "5", "--predict", HEALTHY)
        self.succeeds("export", "fit.h5", "--csv", "out")
        parameters = {p["parameter"]: p for p in self.table("parameters.csv")}
        for name, estimate in json["parameters"].items():
            row = parameters[name]
            self.assertEqual([float(row[k]) for k in ("best", "stderr", "lower95", "upper95")],
                             [estimate[k] for k in ("value", "stderr", "lower95", "upper95")])
            self.assertEqual((row["how"], row["unit"]), ("free", "N m-1"))
        self.assertEqual({parameters[name]["how"] for name in ("rise", "damping", "lung_elastance")}, {"beside"})
        self.assertGreater(float(parameters["damping"]["stderr"]), 0)  # under a prior
        statistics = {s["name"]: float(s["value"]) for s in self.table("statistics.csv")}
        self.assertEqual((statistics["nrmse_percent"], statistics["breaths_used"]), (json["nrmse_percent"], json["breaths_used"]))
        breath = self.table("breath.csv")
        residual = self.column(breath, "fit_ml") - self.column(breath, "measured_ml")
        np.testing.assert_allclose(residual, self.column(breath, "residual_ml"), atol=1e-9)
        baseline = self.column(breath, "baseline_ml") - self.column(breath, "measured_ml")
        self.assertAlmostEqual(100 * np.sqrt((baseline ** 2).mean()) / json["tidal_volume_measured_ml"],
                               json["baseline_nrmse_percent"], delta=1e-9)
        evaluations = self.table("evaluations.csv")
        self.assertEqual(len(evaluations), json["evaluations"])
        self.assertIn("k_muscle_N_per_m", evaluations[0])
        self.assertAlmostEqual(min(self.column(evaluations, "objective")), json["objective"], delta=1e-3 * json["objective"])
        self.assertEqual(len(self.table("surface.csv")), json["surface"]["points"])
        self.assertEqual({p["parameter"] for p in self.table("profiles.csv")}, set(json["profiles"]))
        self.assertEqual(len(self.table("starts.csv")), json["starts"])
        prediction = {p["name"]: float(p["value"]) for p in self.table("predictions.csv")}
        self.assertEqual(prediction["ratio_percent"], json["predictions"]["healthy"]["ratio_percent"]["value"])
        results = {r["result"]: r for r in self.table("results.csv")}
        self.assertEqual(list(results), list(json["results"]))
        straight = {r["result"]: r for r in self.table("straight_activation.csv")}
        for rows, of_json in ((results, json["results"]), (straight, json["straight_activation"])):
            for name, row in rows.items():
                self.assertEqual([float(row[k]) for k in ("value", "lower95")], [of_json[name][k] for k in ("value", "lower95")])
                self.assertEqual([row[k] for k in ("grade", "assumption", "reason")],
                                 [of_json[name][k] or "" for k in ("grade", "assumption", "reason")])
        self.assertEqual([name for name, r in results.items() if int(r["headline"]) > 0], json["headline"])
        sentences = [(row["what"], row["text"]) for row in self.table("verdict.csv")]
        self.assertLessEqual({("grade", json["grade"]), ("verdict", json["verdict"]), ("input", json["input"]),
                              *(("note", note) for note in json["notes"])}, set(sentences))

    def test_a_gate_is_exported_with_its_sentence(self):
        self.file("small.csv", trace(tidal_ml=40))
        json = self.succeeds("fit", HEALTHY, "--trace", "small.csv", "-o", "fit.h5", *FAST_FIT, codes=(4,))
        self.succeeds("export", "fit.h5", "--csv", "out")
        sentences = {row["what"]: row["text"] for row in self.table("verdict.csv")}
        self.assertEqual(sentences["gate subject_size"], json["verdict"])
        recoil = next(r for r in self.table("results.csv") if r["result"] == "recoil_time_s")
        self.assertEqual([recoil[k] for k in ("value", "lower95", "upper95", "grade")], ["", "", "", "not_determined"])

    def test_a_summary_has_no_frames(self):
        self.simulate("a.h5", "--every", "0")
        self.assertEqual(len(self.succeeds("export", "a.h5", "--csv", "out")["files"]), 3)
        self.refused("export", "a.h5", "--vtk", "vtk", says="a.h5: has no trajectory; expected a run simulated without --every 0")

    def test_two_formats_at_once_and_again_by_force(self):
        self.simulate("a.h5")
        first = self.succeeds("export", "a.h5", "--csv", "out", "--vtk", "vtk")["files"]
        self.assertEqual(len(first), 8 + 34 + 2)
        before = self.contents()
        outcome = self.trunk("export", "a.h5", "--csv", "out")
        self.assertEqual((outcome.code, outcome.out), (2, ""))
        self.assertRegex(outcome.err, "out/curves.csv: exists already; use --force")
        self.assertEqual(self.contents(), before)
        self.assertEqual(self.succeeds("export", "a.h5", "--csv", "out", "--vtk", "vtk", "--force")["files"], first)


if __name__ == "__main__":
    unittest.main()
