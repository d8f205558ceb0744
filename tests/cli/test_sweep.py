"""trunk sweep: killed, interrupted, with impossible runs, on any number of threads."""

import math
import signal
import unittest

import h5py

from support import COARSE, NO_LUNG, SCENARIOS, SHORT_BREATH, Outcome, scenario_with, start
from sweeps import GRID, OF_GRID, SLOW_GRID, SweepTest


class Resume(SweepTest):
    def test_kill_in_the_middle_of_200_runs(self):
        command = ("sweep", self.muscles(200), "-o", "d")
        self.assertEqual(self.stopped(signal.SIGKILL, 40, *command).code, -signal.SIGKILL)
        kept = self.finished()
        self.assertTrue(40 <= len(kept) < 200)
        again = self.succeeds(*command)
        self.assertEqual((again["runs"], again["found"] + again["simulated"], again["failed"]), (200, 200, 0))
        self.assertEqual(again["found"], len(kept))
        self.assertEqual({name: now for name, now in self.finished().items() if name in kept}, kept)
        self.assert_all_there(200)
        volumes = [float(r["delta_v_ml"]) for r in self.rows()]
        self.assertEqual(volumes, sorted(volumes))  # stronger muscles, deeper breaths
        table = (self.folder / "d/table.csv").read_bytes()
        third = self.succeeds(*command)
        self.assertEqual((third["found"], third["simulated"]), (200, 0))
        self.assertEqual((self.folder / "d/table.csv").read_bytes(), table)

    def test_ctrl_c_and_go_on(self):
        command = ("sweep", self.muscles(100), "-o", "d", "-j", "1")
        for sign in (signal.SIGINT, signal.SIGTERM):
            outcome = self.stopped(sign, len(self.finished()) + 10, *command)
            self.assertEqual(outcome.code, 130, str(outcome))
            self.assertEqual(outcome.out, "")
            self.assertRegex(outcome.err, r"\Ainterrupted: \d+ of 100 runs are done; [^\n]+\n\Z")
            self.assertEqual(self.succeeds("status", "d")["done"], int(outcome.err.split()[1]))
            self.assertFalse((self.folder / "d/table.csv").exists())
            self.assert_no_part()
        found = len(self.finished())
        self.assertEqual(self.succeeds(*command)["found"], found)
        self.assert_all_there(100)

    def test_what_a_crash_left_is_repaired(self):
        """A run cut short or damaged on the disk is done again, and a half file does not stay."""
        command = ("sweep", self.muscles(6), "-o", "d")
        self.succeeds(*command)
        table = (self.folder / "d/table.csv").read_bytes()
        runs = self.folder / "d/runs"
        data = (runs / "00001.h5").read_bytes()
        (runs / "00001.h5").write_bytes(data[:len(data) // 2])
        (runs / "00002.h5").write_bytes(b"")
        damaged = bytearray(data)
        for place in range(len(data) // 4, 3 * len(data) // 4, 50):
            damaged[place] ^= 0x10
        (runs / "00003.h5").write_bytes(bytes(damaged))
        again = self.succeeds(*command)
        self.assertEqual((again["found"], again["simulated"]), (3, 3))
        self.assertEqual((self.folder / "d/table.csv").read_bytes(), table)
        self.assert_all_there(6)

    def test_a_file_whose_row_was_lost_gives_the_same_row(self):
        command = ("sweep", self.muscles(3), "-o", "d")
        self.succeeds(*command)
        table = (self.folder / "d/table.csv").read_bytes()
        journal = self.folder / "d/journal/1-of-1"
        journal.write_bytes(journal.read_bytes()[:-100])  # a crash between a run's file and its row
        again = self.succeeds(*command)
        self.assertEqual((again["found"], again["simulated"]), (3, 0))
        self.assertEqual((self.folder / "d/table.csv").read_bytes(), table)

    def test_a_half_file_of_a_killed_sweep_goes(self):
        command = ("sweep", self.muscles(3), "-o", "d")
        self.succeeds(*command)
        (self.folder / "d/runs/00001.h5").rename(self.folder / "d/runs/00001.h5.4194305-1.part")  # no such process
        self.succeeds(*command)
        self.assert_all_there(3)


class Results(SweepTest):
    def test_threads_do_not_change_the_table(self):
        design = self.design('"paralysis.stiffness_factor" = [1, 0.5, 0.1]\n"parameters.k_muscle_N_per_m" = [20, 40]\n'
                             + GRID, scenarios=(SCENARIOS / "hemiparalysis_left.toml", SCENARIOS / "healthy.toml"))
        for threads in (1, 2):
            self.succeeds("sweep", design, "-o", f"d{threads}", "-j", threads)
        one, two = (self.folder / f"d{threads}/table.csv" for threads in (1, 2))
        self.assertEqual(one.read_bytes(), two.read_bytes())
        rows = self.rows("d1")
        self.assertEqual(len(rows), 12)
        self.assertEqual([(r["scenario"], r["paralysis.stiffness_factor"], r["parameters.k_muscle_N_per_m"])
                          for r in rows[:3]], [("hemiparalysis_left", "1", "20"), ("hemiparalysis_left", "1", "40"),
                                               ("hemiparalysis_left", "0.5", "20")])

    def test_a_row_is_the_run_alone(self):
        self.succeeds("sweep", self.muscles(3), "-o", "d")
        alone = self.succeeds("simulate", NO_LUNG, "-o", "r.h5", "--set", "parameters.k_muscle_N_per_m=35", *OF_GRID)
        for name in ("delta_v_ml", "excursion_left_mm", "abdominal_pressure_peak_cmH2O"):
            self.assertEqual(float(self.rows()[1][name]), alone[name])

    def test_lungs_side_by_side(self):
        self.succeeds("sweep", self.design('"lung.elastance_cmH2O_per_L" = [0, 5, 10, 15]\n' + GRID, scenarios=(NO_LUNG,)),
                      "-o", "d")
        alone = self.succeeds("simulate", NO_LUNG, "-o", "r.h5", "--set", "lung.elastance_cmH2O_per_L=10", *COARSE)
        for name in ("delta_v_ml", "pleural_swing_cmH2O", "transdiaphragmatic_swing_cmH2O"):
            self.assertEqual(float(self.rows()[2][name]), alone[name])
        none = self.succeeds("simulate", NO_LUNG, "-o", "none.h5", *COARSE)
        self.assertIsNone(none["pleural_swing_cmH2O"])

    def test_two_sweeps_are_the_same_files(self):
        design = self.muscles(4)
        found = []
        for folder in ("one", "two"):
            (self.folder / folder).mkdir()
            process = start("sweep", self.folder / design, "-o", "d", cwd=self.folder / folder, epoch=0)
            process.communicate()
            found.append({str(p.relative_to(self.folder / folder)): p.read_bytes()
                          for p in (self.folder / folder).rglob("*") if p.is_file() and p.parent.name != "journal"})
        self.assertEqual(len(found[0]), 9)
        self.assertEqual(found[0], found[1])

    def test_shipped_designs(self):
        done = self.succeeds("sweep", SCENARIOS / "sweep_softening.toml", "-o", "d")
        self.assertEqual((done["runs"], done["failed"]), (10, 0))
        soft = [float(r["delta_v_ml"]) for r in self.rows()]
        for stiffer, softer in zip(soft[:4], soft[1:5]):  # the softer the paralysed half, the less air
            self.assertLess(softer, 1.001 * stiffer)  # between 1 and 0.7 nothing happens
        self.assertLess(soft[4], 0.8 * soft[0])
        self.assertTrue((SCENARIOS / "sweep_paralysis.toml").is_file())

    def test_errors_do_not_tell_from_where_it_was_called(self):
        (self.folder / "here/sc").mkdir(parents=True)
        self.file("here/sc/a.toml", scenario_with({**SHORT_BREATH, "duration_s": 0.3}))
        self.file("here/s.toml", 'scenarios = ["sc/a.toml"]\nstore = "summary"\n[grid]\n'
                                 '"parameters.k_elasticity_N_per_m" = [1000, 1000000]\n')
        tables = []
        for number, (at, name) in enumerate((("here", "s.toml"), ("here", "./s.toml"), (".", "here/s.toml"),
                                             ("here/sc", "../s.toml"), (".", self.folder / "here/s.toml"))):
            process = start("sweep", name, "-o", self.folder / f"d{number}", cwd=self.folder / at)
            self.assertEqual(Outcome(process).code, 3)
            tables.append((self.folder / f"d{number}/table.csv").read_text())
        self.assertEqual(len(set(tables)), 1, tables)
        errors = [r["error"] for r in self.rows("d0")]
        self.assertEqual(errors[0], "")
        self.assertRegex(errors[1], r"\Asc/a.toml:\d+: a time step")

    def test_what_is_said_of_curves_is_so(self):
        for store, says in (("summary", " and"), ("curves", ", with curves in")):
            design = self.muscles(1, top=f'store = "{store}"')
            for command in (("sweep", design, "-o", "d", "--force"), ("merge", "d")):
                self.assertIn(f"Table in d/table.csv{says} d/sweep.h5\n", self.trunk(*command).out)

    def test_an_impossible_run_does_not_stop_the_others(self):
        design = self.design(GRID.replace("[3]", "[2, 20, 3]"), scenarios=(NO_LUNG,))
        outcome = self.trunk("sweep", design, "-o", "d", "--json")
        self.assertEqual(outcome.code, 3, str(outcome))
        self.assertEqual(outcome.json()["failed"], 1)
        rows = self.rows()
        self.assertEqual([r["status"] for r in rows], ["completed", "invalid", "completed"])
        self.assertRegex(rows[1]["error"], "20 ms is unstable")
        self.assertNotIn("--set", rows[1]["error"])  # nobody typed it
        self.assertEqual(rows[1]["delta_v_ml"], "")
        self.assertAlmostEqual(float(rows[0]["delta_v_ml"]) / float(rows[2]["delta_v_ml"]), 1, delta=0.01)
        self.assertEqual(self.succeeds("inspect", "d/sweep.h5")["runs"], {"completed": 2, "invalid": 1})


class Limits(SweepTest):
    def test_a_run_that_takes_too_long_stops_no_other(self):
        # A millisecond of work beside minutes of it: the time between them is what any machine needs.
        design = self.design(GRID.replace("[3]", "[3, 0.0001]") + '"parameters.k_muscle_N_per_m" = [10, 20]\n',
                             scenarios=(NO_LUNG,), top='store = "curves"')
        outcome = self.succeeds("sweep", design, "-o", "d", "--timeout", "1.5", codes=(3,))
        self.assertEqual((outcome["runs"], outcome["failed"]), (4, 2))
        self.assertEqual({(r["time.dt_ms"], r["status"]) for r in self.rows()},
                         {("3", "completed"), ("0.0001", "timeout")})
        self.assertRegex(next(r["error"] for r in self.rows() if r["error"]), "took longer than 1.5 s")
        again = self.succeeds("sweep", design, "-o", "d", codes=(3,))
        self.assertEqual((again["found"], again["simulated"]), (4, 0))  # failures are results too
        status = self.succeeds("status", "d")
        self.assertEqual((status["done"], status["failed"], status["left"]), (4, 2, 0))
        for seconds in ("nan", "inf", "0", "-1", "soon"):
            self.refused("sweep", design, "-o", "d", f"--timeout={seconds}", says="--timeout")


    def test_what_took_too_long_is_simulated_again_when_asked_for(self):
        design = self.muscles(3, SLOW_GRID, top='store = "curves"')
        self.assertEqual(self.succeeds("sweep", design, "-o", "d", "--timeout", "0.001", codes=(3,))["failed"], 3)
        retried = self.succeeds("sweep", design, "-o", "d", "--retry-failed")
        self.assertEqual((retried["found"], retried["simulated"], retried["failed"]), (0, 3, 0))
        self.assertEqual([r["status"] for r in self.rows()], 3 * ["completed"])


class Samples(SweepTest):
    def sampled(self, method, seed=1, top=""):
        return self.file(f"{method}{seed}.toml", f'scenarios = ["{NO_LUNG}"]\nstore = "summary"\n{top}\n'
                         f'[grid]\n{GRID}[sample]\nmethod = "{method}"\npoints = 16\nseed = {seed}\n'
                         '"parameters.k_muscle_N_per_m" = { from = 10, to = 1000, scale = "log" }\n'
                         '"geometry.dome_height_left_mm" = { from = 60, to = 76 }\n')

    def test_points_are_spread_evenly(self):
        for method in ("sobol", "latin_hypercube"):
            self.succeeds("sweep", self.sampled(method), "-o", method)
            self.succeeds("sweep", self.sampled(method, 2), "-o", f"{method}2")
            rows = self.rows(method)
            muscle = [math.log10(float(r["parameters.k_muscle_N_per_m"])) - 1 for r in rows]
            dome = [(float(r["geometry.dome_height_left_mm"]) - 60) / 8 for r in rows]
            for values in (muscle, dome):  # both from 0 to 2
                self.assertTrue(all(0 <= v < 2 for v in values), values)
                least = 1 if method == "latin_hypercube" else 0  # of 16 points in each sixteenth
                self.assertTrue(all(sum(i <= 8 * v < i + 1 for v in values) >= least for i in range(16)), values)
                self.assertIn(sum(v < 1 for v in values), (7, 8, 9) if method == "sobol" else (8,))
            self.assertNotEqual(muscle, sorted(muscle))
            other = [r["parameters.k_muscle_N_per_m"] for r in self.rows(f"{method}2")]
            self.assertNotEqual(other, [r["parameters.k_muscle_N_per_m"] for r in rows])

    def test_samples_that_make_no_sense(self):
        text = (self.folder / self.sampled("sobol")).read_text()
        for old, new, says in (('"sobol"', '"random"', "bad.toml:8: sample.method is 'random'"),
                               ("points = 16", "points = 1.5", "bad.toml:9: sample.points is 1.5; expected a whole number"),
                               ("points = 16\n", "", "bad.toml:7: there is no sample.points"),
                               ("points = 16", "points = 1000001", "bad.toml:9: .*1 to"),
                               ("to = 76", "till = 76", "bad.toml:12: unknown 'till'"),
                               ("to = 76", "to = 760", r"bad.toml:12: .*dome_height_left_mm is \d+.*expected"),
                               ("geometry.dome_height_left_mm", "time.dt_ms", r"bad.toml:12: time.dt_ms is in \[grid\] too"),
                               ('"summary"', '"all"', "bad.toml:2: store is 'all'; expected \"summary\" or")):
            self.assertIn(old, text)
            self.file("bad.toml", text.replace(old, new))
            with self.subTest(new):
                self.refused("sweep", "bad.toml", "-o", "d", says=says)


class Subjects(SweepTest):
    def test_a_subject_is_put_on_every_scenario(self):
        for name, muscle in (("a", 25), ("b", 35)):
            self.succeeds("simulate", NO_LUNG, "-o", f"{name}.h5", "--set", f"parameters.k_muscle_N_per_m={muscle}",
                          *COARSE, "--set", "activation.rise_s=0.2")
        design = self.file("s.toml", f'scenarios = ["{NO_LUNG}", "{SCENARIOS / "hemiparalysis_right.toml"}"]\n'
                           f'subjects = ["a.h5", "b.h5"]\nstore = "summary"\n[grid]\n{GRID}')
        self.succeeds("sweep", design, "-o", "d")
        self.assertEqual([(r["scenario"], r["subject"]) for r in self.rows()],
                         [(s, f"{x}.h5") for s in ("healthy_no_lung", "hemiparalysis_right") for x in "ab"])
        alone = self.succeeds("simulate", SCENARIOS / "hemiparalysis_right.toml", "-o", "r.h5", "--from", "b.h5",
                              *OF_GRID)
        self.assertEqual(float(self.rows()[3]["delta_v_ml"]), alone["delta_v_ml"])
        with h5py.File(self.folder / "d/sweep.h5") as file:
            self.assertEqual([s.decode() for s in file["table/subject"][:2]], ["a.h5", "b.h5"])
        self.file("b.h5", "not a fit")
        self.refused("sweep", design, "-o", "e", says=r"\Atrunk: b.h5: .*\(named in s.toml:2\)")


if __name__ == "__main__":
    unittest.main()
