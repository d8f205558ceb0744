"""The study scripts run, and show what README.md says of them."""

import csv
import subprocess
import unittest

from support import PROGRAM, ROOT, TrunkTest

SCRIPT = ROOT / "scripts" / "study_paradox.py"
COLUMNS = ["breath", "costal_ring", "abdomen_stiffness_factor", "fibres", "reaction", "paralysed",
           "paralysed_stiffness_factor", "k_muscle_N_per_m", "delta_v_ml", "right_dome_descends_mm",
           "left_dome_descends_mm", "abdominal_pressure_peak_cmH2O", "flipped_triangles",
           "delta_v_of_healthy_percent", "dt_ms", "status"]


class Paradox(TrunkTest):
    def study(self, *arguments):
        return subprocess.run([SCRIPT, *arguments], cwd=self.folder, capture_output=True, text=True, timeout=120)

    def test_the_paralysed_dome_rises_with_ribs_and_not_without(self):
        done = self.study("--quick", "--trunk", PROGRAM, "-o", "study")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue(done.stdout.startswith("| "), done.stdout)
        with open(self.folder / "study/paradox.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(list(rows[0]), COLUMNS)
        self.assertEqual([row["status"] for row in rows], ["completed"] * 4)
        for row in rows:
            if row["paralysed"] == "no":
                self.assertAlmostEqual(float(row["delta_v_ml"]), 466, delta=0.01)
        paralysed = {row["costal_ring"]: row for row in rows if row["paralysed"] == "right"}
        self.assertEqual(set(paralysed), {"ribs", "free"})
        self.assertLess(float(paralysed["ribs"]["right_dome_descends_mm"]), -1)
        self.assertGreater(float(paralysed["free"]["right_dome_descends_mm"]), 1)
        for row in paralysed.values():
            self.assertGreater(float(row["left_dome_descends_mm"]), 1)
            self.assertTrue(40 < float(row["delta_v_of_healthy_percent"]) < 60, row)

    def test_a_program_that_is_not_there(self):
        done = self.study("--trunk", "nowhere", "-o", "study")
        self.assertEqual(done.returncode, 2)
        self.assertIn("nowhere is not a program", done.stderr)
        self.assertNotIn("Traceback", done.stderr)


if __name__ == "__main__":
    unittest.main()
