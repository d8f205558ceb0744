"""Many fits: a muscle a breath, and a cohort from a list."""

import csv as tables
import io
import unittest

from many_fits import FITTED, ONE, PARALYSED, QUICK
from support import FAST_FIT, HEALTHY, NO_LUNG, TrunkTest, breaths, csv, trace


class EachBreath(TrunkTest):
    HEIGHTS = (1.0, 1.3, 0.8, 1.0, 1.3, 0.8)

    def setUp(self):
        super().setUp()
        times, volumes = breaths(count=6)
        self.file("t.csv", csv(times, [v * self.HEIGHTS[min(int(t / 1.5), 5)] for t, v in zip(times, volumes)]))

    def fit(self, *options, scenario=HEALTHY):
        return self.succeeds("fit", scenario, "--trace", "t.csv", "-o", "f.h5", "--force", "--breath", "each", *options,
                             codes=FITTED)

    def test_muscle_follows_the_height_of_each_breath(self):
        for timing in ("trace", "joint"):
            with self.subTest(timing):
                fit = self.fit(*FAST_FIT, "--surface", "0", "--fix", "k_elasticity=4000", "--timing", timing)
                rows = fit["breaths"]
                self.assertEqual([r["number"] for r in rows], [1, 2, 3, 4, 5, 6])
                mean = sum(self.HEIGHTS) / 6
                for row, height in zip(rows, self.HEIGHTS):
                    self.assertEqual(row["status"], "converged")
                    self.assertAlmostEqual(row["onset_s"], 1.5 * (row["number"] - 1), delta=0.05)
                    self.assertAlmostEqual(row["tidal_volume_ml"], 500 * height, delta=8)
                    muscle, wanted = row["k_muscle"], height / mean * fit["parameters"]["k_muscle"]["value"]
                    self.assertAlmostEqual(muscle["value"] / wanted, 1, delta=0.04)
                    self.assertTrue(0 < muscle["lower95"] < muscle["value"] < muscle["upper95"])
                    self.assertLess(row["nrmse_percent"], 5)
                    self.assertTrue(1 <= row["evaluations"] and 0 < row["latency_ms"] < 60000)
                self.assertLess(rows[2]["k_muscle"]["value"], rows[0]["k_muscle"]["value"])

    def test_what_the_mean_found_is_held(self):
        """Alike breaths have the muscle of the mean, with everything else free in the mean fit at its value there."""
        self.file("t.csv", trace())
        fit = self.fit(*QUICK, "--free", "k_elasticity,k_muscle", scenario=NO_LUNG)
        self.assertNotAlmostEqual(fit["parameters"]["k_elasticity"]["value"], 4000, delta=100)  # not the scenario's
        for row in fit["breaths"]:
            self.assertAlmostEqual(row["k_muscle"]["value"] / fit["parameters"]["k_muscle"]["value"], 1, delta=0.03)

    def test_is_kept_with_the_fit(self):
        fit = self.fit(*ONE)
        kept = {d["path"]: d["shape"] for d in self.succeeds("inspect", "f.h5")["datasets"]}
        for name in ("k_muscle", "k_muscle_lower95", "onset_s", "latency_ms", "status"):
            self.assertEqual(kept["breaths/" + name], [len(fit["breaths"])])

    def test_needs_breaths_and_a_muscle_to_fit(self):
        for options, says in ((("--trace", "t.csv", "--fix", "k_muscle=20"), "k_muscle is what it fits"),
                              (("--tidal-volume-ml", "300"), "--breath each: .*; expected a trace")):
            self.refused("fit", HEALTHY, *options, "-o", "g.h5", *FAST_FIT, "--breath", "each", says=says)


class Cohort(TrunkTest):
    def setUp(self):
        super().setUp()
        (self.folder / "in").mkdir()
        self.file("in/a.csv", trace(tidal_ml=400))
        self.file("in/b.csv", trace(tidal_ml=600))
        self.file("in/broken.csv", "time_s,volume_ml\n0,1\n1,two\n")

    def list(self, text, name="in/list.csv"):
        return self.file(name, text)

    def cohort(self, *options, codes=FITTED, options_for_all=ONE):
        return self.succeeds("fit", HEALTHY, "--cohort", "in/list.csv", "-o", "d", *options_for_all, *options, codes=codes)

    def rows(self):
        return {r["subject"]: r for r in tables.DictReader(io.StringIO((self.folder / "d/cohort.csv").read_text()))}

    def fits(self):
        return {p.name: (p.stat().st_ino, p.stat().st_mtime_ns) for p in (self.folder / "d").glob("*.h5")}

    def test_one_broken_trace_stops_no_other(self):
        self.list("subject,trace\nA,a.csv\nX,broken.csv\nB,b.csv\nY,absent.csv\n")
        result = self.cohort("--predict", PARALYSED, codes=(3,))
        self.assertEqual((result["schema"], result["failed"], result["found"]), ("trunk.cohort/2", 2, 0))
        by_name = {s["subject"]: s for s in result["subjects"]}
        self.assertEqual(list(by_name), ["A", "X", "B", "Y"])
        self.assertRegex(by_name["X"]["error"], r"\Ain/broken.csv: 2 samples found; [^\n]*")
        self.assertRegex(by_name["Y"]["error"], r"absent.csv")
        rows = self.rows()
        self.assertEqual(set(self.fits()), {"A.h5", "B.h5"})
        for name, file in (("A", "in/a.csv"), ("B", "in/b.csv")):
            alone = self.succeeds("fit", HEALTHY, "--trace", file, "-o", name + ".h5", *ONE, "--predict", PARALYSED,
                                  codes=FITTED)
            for key in ("status", "grade", "gates", "headline", "results", "parameters", "verdict", "predictions"):
                self.assertEqual(by_name[name][key], alone[key])
            row, p = rows[name], alone["predictions"]["hemiparalysis_right"]
            self.assertEqual([row[key] for key in ("status", "grade", "gates", "error")], [alone["status"], alone["grade"], "", ""])
            self.assertGreaterEqual(len(alone["headline"]), 5)
            for result in alone["headline"]:
                for end in ("", "_lower95", "_upper95"):
                    self.assertEqual(float(row[result + end]), alone["results"][result][end.strip("_") or "value"], result)
                self.assertEqual(row[result + "_grade"], alone["results"][result]["grade"])
            self.assertEqual(float(row["nrmse_percent"]), alone["nrmse_percent"])
            self.assertEqual(float(row["hemiparalysis_right_delta_v_ml_upper95"]), p["delta_v_ml"]["upper95"])
            self.assertEqual(float(row["hemiparalysis_right_percent"]), p["ratio_percent"]["value"])
            self.assertEqual(float(row["hemiparalysis_right_percent_structural_lower95"]), p["ratio_percent"]["structural_lower95"])
        self.assertEqual([rows["X"][key] for key in ("status", "grade", "k_muscle")], ["failed", "", ""])

    def test_a_gate_withholds_in_the_table_too(self):
        self.file("in/b.csv", trace(tidal_ml=40))  # 0.8 % of this trunk's end-expiratory volume
        self.list("subject,trace\nA,a.csv\nB,b.csv\n")
        result = self.cohort(codes=(4,), options_for_all=QUICK)
        row = self.rows()["B"]
        self.assertEqual((row["grade"], row["gates"], row["k_muscle"], row["recoil_time_s_upper95"]),
                         ("not_determined", "subject_size", "", ""))
        self.assertEqual(row["k_muscle_grade"], "not_determined")
        self.assertIsNone(result["subjects"][1]["results"]["k_muscle"]["value"])
        shown = self.trunk("fit", HEALTHY, "--cohort", "in/list.csv", "-o", "d", *QUICK).out
        self.assertRegex(shown, r"(?m)^  B +not_identifiable +not_determined +withheld +withheld")

    def test_what_is_done_is_not_done_again(self):
        self.list("subject,trace\nA,a.csv\nB,b.csv\n")
        first = self.cohort("-j", "1")
        table, before = (self.folder / "d/cohort.csv").read_bytes(), self.fits()
        again = self.cohort("-j", "2")
        self.assertEqual((first["found"], again["found"]), (0, 2))
        self.assertEqual(self.fits(), before)
        self.assertEqual((self.folder / "d/cohort.csv").read_bytes(), table)
        (self.folder / "d/B.h5").unlink()
        self.assertEqual(self.cohort()["found"], 1)
        self.assertEqual((self.folder / "d/cohort.csv").read_bytes(), table)
        self.assertEqual(self.fits()["A.h5"], before["A.h5"])

    def test_a_fit_of_something_else_is_not_replaced_unasked(self):
        self.list("subject,trace\nA,a.csv\nB,b.csv\n")
        self.cohort()
        before = self.fits()
        self.file("in/b.csv", trace(tidal_ml=500))  # another trace under the same name
        changed = self.cohort(codes=(3,))
        self.assertEqual([s["status"] == "failed" for s in changed["subjects"]], [False, True])
        self.assertRegex(changed["subjects"][1]["error"], "d/B.h5: is another fit: .*; delete it, or give --force")
        self.list("subject,trace,fix\nA,a.csv,k_elasticity=3000\nB,b.csv,\n")  # another option in the row
        self.assertEqual(self.cohort(codes=(2,))["failed"], 2)
        self.list("subject,trace\nA,a.csv\nB,b.csv\n")  # other options for all
        self.assertEqual(self.cohort("--seed", "2", codes=(2,))["failed"], 2)
        self.assertEqual(self.fits(), before)
        self.assertEqual(self.cohort("--force")["found"], 0)
        self.assertAlmostEqual(float(self.rows()["B"]["tidal_volume_measured_ml"]), 500, delta=10)

    def test_a_row_is_a_command_line(self):
        times, volumes = breaths()
        self.file("in/b.csv", csv(times, [1.3 * v if 3.0 <= t < 4.5 else v for t, v in zip(times, volumes)], "Zeit [s],V [ml]"))
        self.file("in/soft.toml", f'extends = "{HEALTHY}"\n[parameters]\nk_elasticity_N_per_m = 3000\n')
        self.list("subject;trace;scenario;breath;fix;time;signal\n"
                  "A;a.csv;;;k_elasticity=2500 damping=10;;\nB;b.csv;soft.toml;3;damping=20;Zeit [s];V [ml]\n")
        self.cohort("--free", "k_muscle", options_for_all=QUICK)
        rows = self.rows()
        self.assertAlmostEqual(float(rows["B"]["tidal_volume_measured_ml"]), 650, delta=7)
        self.assertEqual((rows["A"]["breaths_used"], rows["B"]["breaths_used"]), ("5", "1"))
        kept = {name: self.succeeds("inspect", f"d/{name}.h5")["parameters"] for name in "AB"}
        self.assertEqual((kept["A"]["k_elasticity"]["value"], kept["A"]["damping"]["value"]), (2500, 10))
        self.assertEqual((kept["B"]["k_elasticity"]["value"], kept["B"]["damping"]["value"]), (3000, 20))

    def test_two_stages_for_all(self):
        self.list("subject,trace\nA,a.csv\n")
        self.assertEqual(len(self.cohort("--breath", "each")["subjects"]), 1)
        kept = {d["path"] for d in self.succeeds("inspect", "d/A.h5")["datasets"]}
        self.assertIn("breaths/k_muscle", kept)

    def test_a_list_that_makes_no_sense(self):
        for text, says in (("subject,trace,colour\nA,a.csv,red\n", "list.csv:1: column 'colour'.*expected.*subject.*breath"),
                           ("trace\na.csv\n", "list.csv:1: there is no column 'subject'; expected a header"),
                           ("subject,trace\n", "list.csv: the list names no subject; expected"),
                           ("subject,trace\nA,a.csv\nA,b.csv\n", "list.csv:3: subject 'A' .*line 2 as well; expected each"),
                           ("subject,trace\n../A,a.csv\n", "list.csv:2: subject '../A'"),
                           ("subject,trace\na/b,a.csv\n", "list.csv:2: subject 'a/b'"),
                           ("subject,trace\n.h,a.csv\n", "list.csv:2: subject '.h'"),
                           ("subject,trace\n,a.csv\n", "list.csv:2: this row names no subject; expected 1 to 100"),
                           ("subject,trace,timing\nA,a.csv,never\n", "list.csv:2: .*timing.*never"),
                           ("subject,trace,output\nA,a.csv,b.h5\n", "column 'output'"),
                           ("subject,trace,trace\nA,a.csv,b.csv\n", "'trace' stands twice")):
            with self.subTest(text):
                self.list(text)
                self.refused("fit", HEALTHY, "--cohort", "in/list.csv", "-o", "d", *ONE, says=says)

    def test_a_folder_of_something_else_is_left_alone(self):
        self.list("subject,trace\nA,a.csv\n")
        self.refused("fit", HEALTHY, "--cohort", "in/list.csv", "-o", "in", *ONE, says="in: is not empty and holds no cohort")
        self.refused("fit", HEALTHY, "--cohort", "in/list.csv", "-o", "in/a.csv", *ONE, says="is a file")
        self.refused("fit", HEALTHY, "--cohort", "in/list.csv", "-o", "d", "--save-scenario", "s.toml", *ONE,
                     says="--save-scenario")


if __name__ == "__main__":
    unittest.main()
