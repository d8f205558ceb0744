"""trunk sweep, merge and status: shards, stores and what a sweep refuses."""

import os
import shutil
import signal
import subprocess
import unittest

import h5py

from support import NO_LUNG, PROGRAM, ROOT, SCENARIOS, Outcome, catches, file_limit, start
from sweeps import GRID, SLOW_GRID, SweepTest


class Shards(SweepTest):
    def test_shards_make_the_same_table(self):
        for store in ("summary", "full"):
            design = self.design('"parameters.k_muscle_N_per_m" = [10, 20, 30, 40]\n"time.dt_ms" = [3, 20]\n'
                                 '"time.duration_s" = [0.3]\n', top=f'store = "{store}"',
                                 scenarios=(NO_LUNG, SCENARIOS / "hemiparalysis_right.toml"))
            whole, parts = f"{store}_whole", f"{store}_parts"
            self.succeeds("sweep", design, "-o", whole, "-j", "2", codes=(3,), epoch=0)
            running = [start("sweep", design, "-o", parts, "-j", k, "--shard", f"{k}/3", cwd=self.folder, epoch=0)
                       for k in (1, 2)]
            for process in running:
                process.communicate()
                self.assertEqual(process.returncode, 3)  # 20 ms is unstable
            early = self.succeeds("merge", parts, codes=(3,), epoch=0)
            self.assertEqual((early["failed"], early["missing"]), (6, 5))
            self.assertEqual(self.succeeds("status", parts)["left"], 5)
            third = self.succeeds("sweep", design, "-o", parts, "--shard", "3/3", codes=(3,), epoch=0)
            self.assertEqual((third["runs"], third["shard"]), (5, "3/3"))
            for _ in range(2):  # merging again changes nothing
                self.succeeds("merge", parts, codes=(3,), epoch=0)
                for name in ("table.csv", "sweep.h5"):
                    self.assertEqual((self.folder / parts / name).read_bytes(),
                                     (self.folder / whole / name).read_bytes(), name)

    def test_one_process_a_shard(self):
        slow = self.design('"time.dt_ms" = [0.001]\n"time.duration_s" = [5]\n"paralysis.stiffness_factor" = [1, 0.5]\n')
        first = start("sweep", slow, "-o", "d", "--shard", "1/2", cwd=self.folder)
        journal = self.folder / "d/journal/1-of-2"
        for command, says in ((("sweep", slow, "-o", "d", "--shard", "1/2"), "1-of-2: is being written by another"),
                              (("sweep", slow, "-o", "d"), "d: is in use by another process"),
                              (("merge", "d"), "d: is in use by another process")):
            while not (journal.exists() and catches(first)):
                self.assertIsNone(first.poll())
            outcome = self.trunk(*command)
            self.assertEqual(outcome.code, 2, str(outcome))
            self.assert_one_line(outcome)
            self.assertRegex(outcome.err, says)
        self.assertEqual(self.succeeds("status", "d")["left"], 2)
        first.send_signal(signal.SIGINT)  # in the middle of a run of minutes
        outcome = Outcome(first)
        self.assertEqual(outcome.code, 130, str(outcome))
        self.assertRegex(outcome.err, "interrupted: 0 of 1 runs")

    def test_a_retry_counts_whichever_shard_failed(self):
        design = self.design(f'"parameters.k_muscle_N_per_m" = [10, 20]\n{SLOW_GRID}', top='store = "curves"')
        for k in (1, 2):
            self.succeeds("sweep", design, "-o", "d", "--shard", f"{k}/2", "--timeout", "0.001", codes=(3,), epoch=0)
        self.assertEqual(self.succeeds("merge", "d", codes=(3,), epoch=0)["failed"], 2)
        retry = ("sweep", design, "-o", "d", "--retry-failed")
        for simulated in (2, 0):
            again = self.succeeds(*retry, epoch=0)
            self.assertEqual((again["simulated"], again["failed"]), (simulated, 0))
        status = self.succeeds("status", "d")
        self.assertEqual((status["done"], status["failed"]), (2, 0))
        self.assertEqual(self.succeeds("merge", "d", epoch=0)["failed"], 0)
        self.succeeds("sweep", design, "-o", "never_failed", epoch=0)
        for name in ("table.csv", "sweep.h5"):
            self.assertEqual((self.folder / "d" / name).read_bytes(), (self.folder / "never_failed" / name).read_bytes())

    def test_tasks_of_an_array_share_out_all_runs(self):
        design = self.muscles(5, top='store = "summary"')
        def task(number, first, last, step, count):
            array = {"ID": number, "MIN": first, "MAX": last, "STEP": step, "COUNT": count}  # as Slurm 22.05 sets them
            environment = {f"SLURM_ARRAY_TASK_{name}": str(value) for name, value in array.items()}
            return subprocess.run([ROOT / "scripts/sweep_slurm", design, "d"], cwd=self.folder, text=True,
                                  capture_output=True, env={**os.environ, "TRUNK": PROGRAM, **environment})
        gaps = task(3, 1, 3, 1, 2)  # --array=1,3
        self.assertEqual((gaps.returncode, gaps.stdout), (2, ""))
        self.assertRegex(gaps.stderr, "2 tasks from 1 to 3: expected a range without gaps, as in --array=1-2")
        for first, last, step, count in ((0, 2, 1, 3), (4, 8, 2, 3), (7, 7, 1, 1)):
            for number in range(first, last + 1, step):
                self.assertFalse((self.folder / "d/table.csv").exists())
                outcome = task(number, first, last, step, count)
                self.assertEqual(outcome.returncode, 0, outcome)
            self.assert_table_of(5)
            shutil.rmtree(self.folder / "d")

    def assert_table_of(self, count):
        self.assertEqual([r["status"] for r in self.rows()], count * ["completed"])

    def test_a_shard_that_makes_no_sense(self):
        for shard in ("0/2", "3/2", "1", "1/", "/2", "a/b", "1/2/3", "-1/2"):
            self.refused("sweep", self.muscles(2), "-o", "d", f"--shard={shard}", says="--shard .*expected K/N")
        self.refused("merge", "d", says="d: holds no sweep")


class Stores(SweepTest):
    def both(self, store, **options):
        return self.design('"parameters.k_muscle_N_per_m" = [10, 20, 30, 40, 50]\n"time.dt_ms" = [3, 4]\n'
                           '"time.duration_s" = [0.3]\n', f"{store}.toml", top=f'store = "{store}"', **options)

    def test_side_by_side_gives_what_each_gives_alone(self):
        for store in ("full", "curves", "summary"):
            self.succeeds("sweep", self.both(store), "-o", store)
        tables = {store: (self.folder / store / "table.csv").read_bytes() for store in ("full", "curves", "summary")}
        self.assertEqual(tables["full"], tables["curves"])
        self.assertEqual(tables["full"], tables["summary"])
        self.assertEqual(len(self.finished("full")), 10)
        self.assertEqual(self.finished("curves"), {})
        with h5py.File(self.folder / "full/sweep.h5") as full, h5py.File(self.folder / "curves/sweep.h5") as curves, \
                h5py.File(self.folder / "summary/sweep.h5") as summary:
            self.assertEqual(full["curves/dV"].shape, (10, 31))
            self.assertEqual(full["curves/dV"][...].tobytes(), curves["curves/dV"][...].tobytes())
            self.assertEqual(summary["curves/dV"].shape, (10, 0))

    def test_a_summary_sweep_is_killed_and_goes_on(self):
        command = ("sweep", self.muscles(200, GRID, 'store = "summary"'), "-o", "d", "-j", "1")
        journal = self.folder / "d/journal/1-of-1"
        process = start(*command, cwd=self.folder)
        self.interrupt(process, lambda: journal.exists() and journal.stat().st_size > 5000, signal.SIGKILL)
        kept = self.succeeds("status", "d")
        self.assertTrue(0 < kept["done"] < 200, kept)
        self.assertEqual(kept["left"], 200 - kept["done"])
        with journal.open("ab") as file:
            file.write(b"half a row")
        again = self.succeeds(*command)
        self.assertEqual((again["found"], again["simulated"]), (kept["done"], 200 - kept["done"]))
        self.succeeds("sweep", command[1], "-o", "whole")
        for name in ("table.csv",):
            self.assertEqual((self.folder / "d" / name).read_bytes(), (self.folder / "whole" / name).read_bytes())

    def test_a_damaged_row_is_done_again_and_no_other(self):
        command = ("sweep", self.muscles(20, GRID, 'store = "summary"'), "-o", "d", "-j", "1")
        self.succeeds(*command)
        table, journal = (self.folder / "d/table.csv").read_bytes(), self.folder / "d/journal/1-of-1"
        data = bytearray(journal.read_bytes())
        data[len(data) // 2] ^= 0x10
        journal.write_bytes(bytes(data))
        again = self.succeeds(*command)
        self.assertEqual((again["found"], again["simulated"]), (19, 1))
        self.assertEqual(self.succeeds(*command)["found"], 20)
        self.assertEqual((self.folder / "d/table.csv").read_bytes(), table)


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
        self.refused("sweep", design, "-o", design, says="is a file; expected a folder")
        self.refused("sweep", design, "-o", "/proc/d", says="/proc/d: cannot be")
        self.refused("status", "thesis", says="thesis: holds no sweep; expected")
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
                           ('"parameters.k_muscle_N_per_m" = [10, -20]', f"s.toml:{line}: .*-20; expected .* 0 to"),
                           ('k_muscle = [10]', f"s.toml:{line}: .*full name"),
                           ('"time.dt_ms" = { from = 1, to = 2 }', f"s.toml:{line}: .*count"),
                           ('"time.dt_ms" = { from = 0, to = 2, count = 2, scale = "log" }', f"s.toml:{line}: .*log"),
                           ('"time.dt_ms" = []', f"s.toml:{line}: .*expected a list"),
                           ('"time.dt_ms" = [1', "s.toml:[67]: not valid TOML")):
            with self.subTest(grid):
                self.refused("sweep", self.design(grid + "\n"), "-o", "d", says=says)
        self.refused("sweep", self.design(GRID, scenarios=["none.toml"]), "-o", "d", says=("s.toml:3: .*none.toml",))
        self.refused("sweep", self.design(GRID, top="seed = 3"), "-o", "d", says="s.toml:4: unknown key 'seed'; expected")
        self.refused("sweep", "none.toml", "-o", "d", says="none.toml: no such file")


if __name__ == "__main__":
    unittest.main()
