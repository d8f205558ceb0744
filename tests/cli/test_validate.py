"""trunk validate: exit 0 on what ships, 3 where a bound fails, 2 where its inputs are not there or not right."""

import re
import shutil
import subprocess
import unittest
from pathlib import Path

from support import LIMIT_S, PROGRAM, ROOT, SCENARIOS, TrunkTest

TABLE = ROOT / "reference" / "table1.csv"
COLUMNS = ("end_expiratory_volume_ml", "end_inspiratory_volume_ml", "delta_v_ml", "delta_v_percent", "delta_l_mm",
           "delta_l_percent", "delta_h_mm", "delta_r_mm")
ROWS = ("experiment", "published_model", "published_healthy", "healthy", "craighero")


class Validate(TrunkTest):
    def scenarios_with(self, name, pattern, replacement):
        """A copy of the shipped scenarios with one line of one of them changed."""
        shutil.copytree(SCENARIOS, self.folder / "mine")
        file = self.folder / "mine" / f"{name}.toml"
        text, found = re.subn(pattern, replacement, file.read_text())
        self.assertEqual(found, 1)
        file.write_text(text)
        return "mine"

    def test_the_shipped_scenarios_hold(self):
        """From another working directory, without options."""
        before = self.contents()
        report = self.succeeds("validate")
        self.assertEqual((report["schema"], report["status"]), ("trunk.validate/1", "valid"))
        self.assertEqual([row["name"] for row in report["rows"]], list(ROWS))
        self.assertEqual([row["name"] for row in report["errors"]], list(ROWS[1:]))
        for row in report["rows"]:
            self.assertEqual(tuple(row)[1:], COLUMNS)
        for row in report["errors"]:
            self.assertEqual([row[c]["unit"] for c in COLUMNS], 7 * ["percent"] + ["mm"])
        self.assertEqual(report["rows"][0]["delta_v_ml"], 466)
        for ours in (3, 4):
            self.assertAlmostEqual(report["rows"][ours]["delta_v_ml"], 466, delta=4.66)
        self.assertEqual(len(report["breaths"]), 7)
        for breath in report["breaths"]:
            self.assertLessEqual(breath["excursion_right_most_risen_mm"], min(0, breath["excursion_right_mm"]) + 1e-9)
            if breath["scenario"].startswith("published"):
                self.assertEqual(breath["start"], "rest")
        self.assert_pressures_are_told(report)
        self.assertTrue(all(breath["status"] == "completed" for breath in report["breaths"]))
        self.assert_bounds_are_judged(report["bounds"])
        self.assertTrue(all(bound["pass"] for bound in report["bounds"]))
        self.assertEqual(self.contents(), before)

    def assert_pressures_are_told(self, report):
        """Of the scenarios with a lung, with a range and its source for each number."""
        names = [usual["name"] for usual in report["usual"]]
        self.assertEqual(names, ["gastric_swing_cmH2O", "pleural_swing_cmH2O", "transdiaphragmatic_swing_cmH2O",
                                 "recoil_time_s"])
        self.assertTrue(all(usual["source"] and usual["low"] < usual["high"] for usual in report["usual"]))
        judged = {bound["name"] for bound in report["bounds"]}
        for row in report["pressures"]:
            self.assertFalse(row["scenario"].startswith("published"))
            self.assertTrue(all(row[name] is not None for name in names))
            if row["scenario"] == "healthy":
                self.assertLessEqual({f"healthy.{name}" for name in names}, judged)

    def assert_bounds_are_judged(self, bounds):
        self.assertGreaterEqual(len(bounds), 20)
        for bound in bounds:
            low = float("-inf") if bound["low"] is None else bound["low"]
            high = float("inf") if bound["high"] is None else bound["high"]
            self.assertLess(low, high)
            self.assertEqual(bound["pass"], bound["value"] is not None and low <= bound["value"] <= high, bound)

    def test_the_table_people_read(self):
        shown = self.trunk("validate")
        self.assertEqual((shown.code, shown.err), (0, ""))
        self.assertRegex(shown.out, r"(?m)^experiment +4760\.0 +5226\.0 +466\.0 +9\.78 +9\.13 +6\.13 +2\.00 +0\.00$")
        self.assertRegex(shown.out, r"(?m)^published model .* \+565\.00 +\+8\.80$")
        self.assertIn("All 29 bounds hold.", shown.out)
        self.assertNotIn("FAILS", shown.out)

    def test_half_the_muscle_fails(self):
        mine = self.scenarios_with("healthy", r"(?m)^k_muscle_N_per_m = [\d.]+", "k_muscle_N_per_m = 9.6")
        outcome = self.trunk("validate", "--scenarios", mine, "--json")
        self.assertEqual(outcome.code, 3, str(outcome))
        self.assert_one_line(outcome)
        report = outcome.json()
        self.assertEqual(report["status"], "not_valid")
        failed = {bound["name"] for bound in report["bounds"] if not bound["pass"]}
        self.assertLessEqual({"healthy.dv_error", "healthy.eev_error"}, failed)  # the breath ends half as far above relaxation
        self.assertNotIn("craighero.dv_error", failed)  # which has a muscle of its own
        for name in failed:
            self.assertIn(name, outcome.err)
        plain = self.trunk("validate", "--scenarios", mine)
        self.assertEqual((plain.code, plain.err), (3, outcome.err))
        self.assertIn("FAILS", plain.out)

    def test_no_ribs_no_paradox(self):
        mine = self.scenarios_with("hemiparalysis_right", r"(?m)^\[paralysis\]", "[tissue]\nribs = false\n[paralysis]")
        outcome = self.trunk("validate", "--scenarios", mine)
        self.assertEqual(outcome.code, 3, str(outcome))
        self.assertIn("hemiparalysis_right.paralysed_dome", outcome.err)

    def test_a_breath_that_diverges_is_named(self):
        """Its numbers are not known, so its bounds do not hold; the others are still judged."""
        load = ('\n[[force]]\nregion = "central_tendon"\ndirection = [0, 0, 1]\nevents_N = [[0, 0], [0.1, 100000], [2.7, 0]]\n')
        mine = self.scenarios_with("exercise_healthy", r"\Z", load)
        outcome = self.trunk("validate", "--scenarios", mine, "--json")
        self.assertEqual(outcome.code, 3, str(outcome))
        self.assert_one_line(outcome)
        self.assertRegex(outcome.err, r"exercise_healthy: .*(diverged|volume)")
        values = {bound["name"]: bound["value"] for bound in outcome.json()["bounds"]}
        self.assertIsNone(values["exercise_hemiparalysis_right.dv"])
        self.assertIsNone(values["all.volume_error"])
        self.assertIsNotNone(values["healthy.dv_error"])

    def test_bad_input(self):
        self.refused("validate", "--scenarios", "none", says=("none", "no such folder"))
        self.refused("validate", "--table1", "none.csv", says=("none.csv", "no such file"))
        self.refused("validate", "somewhere", says="not expected")
        text = TABLE.read_text()
        broken = {"column.csv": (text.replace("dh_mm", "dh_cm"), "dh_cm"),
                  "row.csv": (text.replace("published_model", "our_model"), "our_model"),
                  "number.csv": (text.replace("9.73", "9,73"), r"number\.csv:\d+"),
                  "typo.csv": (text.replace("466", "644"), r"expected eiv_ml - eev_ml"),
                  "empty.csv": ("", "empty")}
        for name, (content, says) in broken.items():
            with self.subTest(name):
                self.refused("validate", "--table1", self.file(name, content), says=(name, says))
        (self.folder / "mine").mkdir()
        self.refused("validate", "--scenarios", "mine", says=r"mine/published_healthy\.toml")

    def test_where_it_looks(self):
        """Beside the program's folder, else in the working directory; else both places are named."""
        (self.folder / "bin").mkdir()
        program = shutil.copy(PROGRAM, self.folder / "bin" / "trunk")

        def run():
            return subprocess.run([program, "validate", "--json"], cwd=self.folder / "work", capture_output=True,
                                  text=True, timeout=LIMIT_S)

        work = self.folder / "work"
        work.mkdir()
        answer = run()
        self.assertEqual((answer.returncode, answer.stdout), (2, ""))
        self.assertRegex(answer.stderr, r"\Atrunk: neither [^\n]*\n\Z")
        for place in (self.folder / "scenarios", work / "scenarios", "--scenarios"):
            self.assertIn(str(place), answer.stderr)
        for folder in (work, self.folder):
            shutil.copytree(SCENARIOS, folder / "scenarios")
            (folder / "reference").mkdir()
            shutil.copy(TABLE, folder / "reference")
            answer = run()
            self.assertEqual(answer.returncode, 0, answer.stderr)
            self.assertIn(f'"scenarios": "{Path(folder, "scenarios")}"', answer.stdout)


if __name__ == "__main__":
    unittest.main()
