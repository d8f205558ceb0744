"""The study scripts run, and show what README.md says of them."""

import csv
import subprocess
import unittest

from support import PROGRAM, ROOT, TrunkTest, at_night

SCRIPTS = ROOT / "scripts"
COLUMNS = ["breath", "costal_ring", "abdomen_stiffness_factor", "fibres", "reaction", "paralysed",
           "paralysed_stiffness_factor", "k_muscle_N_per_m", "delta_v_ml", "right_dome_descends_mm",
           "left_dome_descends_mm", "abdominal_pressure_peak_cmH2O", "flipped_triangles",
           "delta_v_of_healthy_percent", "dt_ms", "status"]


class StudyTest(TrunkTest):
    def study(self, script, *arguments, limit_s=120):
        return subprocess.run([SCRIPTS / script, *arguments], cwd=self.folder, capture_output=True, text=True,
                              timeout=limit_s)

    def assert_no_program(self, script):
        done = self.study(script, "--trunk", "nowhere", "-o", "study")
        self.assertEqual(done.returncode, 2)
        self.assertIn("nowhere is not a program", done.stderr)
        self.assertNotIn("Traceback", done.stderr)


class Paradox(StudyTest):
    def test_the_paralysed_dome_rises_with_ribs_and_not_without(self):
        done = self.study("study_paradox.py", "--quick", "--trunk", PROGRAM, "-o", "study")
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
        self.assert_no_program("study_paradox.py")


class Mesh(StudyTest):
    def test_a_finer_mesh_is_stiffer_and_keeps_the_paradox(self):
        done = self.study("study_mesh.py", "--quick", "--trunk", PROGRAM, "-o", "study")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue(done.stdout.startswith("| "), done.stdout)
        with open(self.folder / "study/mesh.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        for row in rows:
            self.assertEqual((row["status"], row["flipped_triangles"]), ("completed", "0"), row)
            self.assertEqual(row["particles"], {"1": "113", "2": "455"}[row["resolution"]])

        def volumes(question, change=""):
            return [float(row["delta_v_ml"]) for row in rows if (row["question"], row["change"]) == (question, change)]
        coarse, fine = volumes("same parameters")
        self.assertTrue(0.6 < fine / coarse < 0.9, (coarse, fine))
        for question in ("466 ml by k_muscle", "466 ml by k_elasticity", "held rings twice, 466 ml"):
            for volume in volumes(question):
                self.assertAlmostEqual(volume, 466, delta=0.06)
        coarse, fine = volumes("membrane, same parameters", "100 N/m")
        self.assertTrue(0.6 < fine / coarse < 0.9, (coarse, fine))
        for row in rows:
            if row["change"] == "paralysed":
                self.assertLess(float(row["right_dome_descends_mm"]), -1)
                self.assertGreater(float(row["left_dome_descends_mm"]), 1)

    def test_a_program_that_is_not_there(self):
        self.assert_no_program("study_mesh.py")


class Sheet(StudyTest):
    def volumes(self, *arguments):
        done = self.study("study_sheet.py", *arguments, "--trunk", PROGRAM, "-o", "study", limit_s=3600)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue(done.stdout.startswith("| "), done.stdout)
        with open(self.folder / "study/sheet.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual({row["status"] for row in rows}, {"completed"})
        found = {}
        for row in rows:
            if row["mesh"] != "craighero":
                found.setdefault((row["question"], row["elasticity"], row["resolution"]), []).append(
                    float(row["delta_v_ml"] or 0))
        return found

    def test_five_triangulations_of_a_sheet_hold_the_same_volume(self):
        volumes = self.volumes("--quick")["held", "sheet", "3"]
        self.assertEqual(len(set(volumes)), 5)
        self.assertLessEqual(max(volumes) / min(volumes), 1.05)

    @at_night  # it takes minutes
    def test_the_whole_study(self):
        found = self.volumes()
        for question in ("held", "breath"):
            self.assertLessEqual(max(found[question, "sheet", "3"]) / min(found[question, "sheet", "3"]), 1.05)
            coarse, fine = found[question, "sheet", "2"][0], found[question, "sheet", "4"][0]
            self.assertLess(coarse / fine, 1.15)
            coarse, fine = found[question, "ring", "2"][0], found[question, "ring", "4"][0]
            self.assertGreater(coarse / fine, 1.15)

    def test_a_program_that_is_not_there(self):
        self.assert_no_program("study_sheet.py")


class Published(StudyTest):
    def test_every_run_has_the_published_tidal_volume(self):
        done = self.study("study_published.py", "--only", "tissue.reaction", "--set", "time.dt_ms=3",
                          "--trunk", PROGRAM, "-o", "study.csv")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        with open(self.folder / "study.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["value"] for row in rows], ["", "published", "variational"])
        for row in rows:
            self.assertEqual(row["status"], "completed")
            self.assertAlmostEqual(float(row["delta_v_ml"]), 438, delta=0.01)
        shape = [[row[name] for name in ("delta_l_mm", "delta_h_mm", "delta_r_mm")] for row in rows]
        self.assertEqual(shape[0], shape[1])  # the scenario's own reaction
        self.assertNotEqual(shape[0], shape[2])

    def test_a_program_that_is_not_there(self):
        self.assert_no_program("study_published.py")


if __name__ == "__main__":
    unittest.main()
