"""trunk sweep and status: killed, interrupted, with impossible runs, on any number of threads."""

import csv
import io
import signal
import unittest

from support import HEALTHY, SCENARIOS, TrunkTest, catches, file_limit, start

GRID = '"time.dt_ms" = [3]\n"time.duration_s" = [0.3]\n'


class SweepTest(TrunkTest):
    def design(self, grid, name="s.toml", scenarios=(HEALTHY,), top=""):
        return self.file(name, f'schema = "trunk.sweep/1"\ntitle = "test"\nscenarios = {list(map(str, scenarios))}\n'
                               f"{top}\n[grid]\n{grid}")

    def muscles(self, count, extra=GRID):
        return self.design(f'"parameters.k_muscle_N_per_m" = {{ from = 10, to = 60, count = {count} }}\n{extra}')

    def rows(self, folder="d"):
        return list(csv.DictReader(io.StringIO((self.folder / folder / "table.csv").read_text())))

    def finished(self, folder="d"):
        return {p.name: (p.stat().st_ino, p.stat().st_mtime_ns) for p in (self.folder / folder / "runs").glob("*.h5")}

    def assert_all_there(self, count, folder="d"):
        status = self.succeeds("status", folder)
        self.assertEqual((status["runs"], status["done"], status["has_table"]), (count, count, True))
        rows = self.rows(folder)
        self.assertEqual([int(r["run"]) for r in rows], list(range(count)))
        self.assertEqual({r["status"] for r in rows}, {"completed"})
        self.assertEqual(set(self.finished(folder)), {f"{i:05}.h5" for i in range(count)})
        self.assert_no_part()

    def stopped(self, sign, after, *command):
        process = start(*command, cwd=self.folder)
        ready = lambda: len(self.finished()) >= after and catches(process)
        return self.interrupt(process, ready, sign)


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
        alone = self.succeeds("simulate", HEALTHY, "-o", "r.h5", "--set", "parameters.k_muscle_N_per_m=35",
                              "--set", "time.dt_ms=3", "--set", "time.duration_s=0.3")
        for name in ("delta_v_ml", "excursion_left_mm", "abdominal_pressure_peak_cmH2O"):
            self.assertEqual(float(self.rows()[1][name]), alone[name])

    def test_two_sweeps_are_the_same_files(self):
        design = self.muscles(4)
        found = []
        for folder in ("one", "two"):
            (self.folder / folder).mkdir()
            process = start("sweep", self.folder / design, "-o", "d", cwd=self.folder / folder, epoch=0)
            process.communicate()
            found.append({str(p.relative_to(self.folder / folder)): p.read_bytes()
                          for p in (self.folder / folder).rglob("*") if p.is_file()})
        self.assertEqual(len(found[0]), 7)
        self.assertEqual(found[0], found[1])

    def test_shipped_designs(self):
        done = self.succeeds("sweep", SCENARIOS / "sweep_softening.toml", "-o", "d")
        self.assertEqual((done["runs"], done["failed"]), (10, 0))
        soft = [float(r["delta_v_ml"]) for r in self.rows()]
        for stiffer, softer in zip(soft[:4], soft[1:5]):  # the softer the paralysed half, the less air
            self.assertLess(softer, 1.001 * stiffer)  # between 1 and 0.7 nothing happens
        self.assertLess(soft[4], 0.8 * soft[0])
        self.assertTrue((SCENARIOS / "sweep_paralysis.toml").is_file())

    def test_an_impossible_run_does_not_stop_the_others(self):
        design = self.design('"time.dt_ms" = [2, 20, 3]\n"time.duration_s" = [0.3]\n')
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


class Refusals(SweepTest):
    def test_a_folder_of_another_design(self):
        self.succeeds("sweep", self.muscles(2), "-o", "d")
        other = self.design('"parameters.k_muscle_N_per_m" = [11, 12, 13]\n' + GRID, "other.toml")
        self.refused("sweep", other, "-o", "d", says=("d: holds another sweep", "--force"))
        self.succeeds("sweep", other, "-o", "d", "--force")
        self.assert_all_there(3)

    def test_folders_that_cannot_be_used(self):
        design = self.muscles(2)
        (self.folder / "thesis").mkdir()
        self.file("thesis/chapter1.txt", "years of work")
        self.refused("sweep", design, "-o", "thesis", says="thesis: is not empty")
        self.refused("sweep", design, "-o", "none/d", says=("none/d: ", "no folder 'none'"))
        self.refused("sweep", design, "-o", design, says="is a file, expected a folder")
        self.refused("sweep", design, "-o", "/proc/d", says="/proc/d: cannot be")
        self.refused("status", "thesis", says="thesis: holds no sweep, expected")
        self.refused("status", "none", says="none: ")

    def test_a_full_disk(self):
        command = ("sweep", self.muscles(4), "-o", "d")
        outcome = self.trunk(*command, **file_limit(4096, ignore_signal=True))
        self.assertEqual(outcome.code, 2, str(outcome))
        self.assert_one_line(outcome)
        self.assert_no_part()
        self.succeeds(*command)  # there is room again
        self.assert_all_there(4)

    def test_designs_that_are_wrong(self):
        line = 6  # of the first line of the grid
        for grid, says in (('"parameters.k_muscle_N_per_m" = [10, "strong"]', f"s.toml:{line}: .*strong.*expected a"),
                           ('"parameters.k_muscle" = [10]', f"s.toml:{line}: .*k_muscle'.*_N_per_m"),
                           ('"parameters.k_muscle_N_per_m" = [10, -20]', f"s.toml:{line}: .*-20, expected .* 0 to"),
                           ('k_muscle = [10]', f"s.toml:{line}: .*full name"),
                           ('"time.dt_ms" = { from = 1, to = 2 }', f"s.toml:{line}: .*count"),
                           ('"time.dt_ms" = { from = 0, to = 2, count = 2, scale = "log" }', f"s.toml:{line}: .*log"),
                           ('"time.dt_ms" = []', f"s.toml:{line}: .*expected a list"),
                           ('"time.dt_ms" = [1', "s.toml:[67]: not valid TOML")):
            with self.subTest(grid):
                self.refused("sweep", self.design(grid + "\n"), "-o", "d", says=says)
        self.refused("sweep", self.design(GRID, scenarios=["none.toml"]), "-o", "d", says=("s.toml:3: .*none.toml",))
        self.refused("sweep", self.design(GRID, top="seed = 3"), "-o", "d", says="s.toml:4: unknown key 'seed', expected")
        self.refused("sweep", "none.toml", "-o", "d", says="none.toml: no such file")


if __name__ == "__main__":
    unittest.main()
