"""The kernel against reference/oracle.py, which solves the same equations by other means, over whole breaths."""

import re
import subprocess
import sys
import unittest

import h5py
import numpy as np

from support import HEALTHY, ROOT, SCENARIOS, TrunkTest

LIMIT_S = 300  # about 10 s on an idle core
TEXT = "parameters/scenario_toml"


class Oracle(TrunkTest):
    def ask(self, *arguments):
        return subprocess.run([sys.executable, ROOT / "reference" / "oracle.py", *arguments], cwd=self.folder,
                              capture_output=True, text=True, timeout=LIMIT_S)

    def assert_agrees(self, name, *settings, steps):
        self.succeeds("simulate", SCENARIOS / f"{name}.toml", "-o", "run.h5", *settings)
        answer = self.ask("run.h5")
        self.assertEqual(answer.returncode, 0, answer.stdout + answer.stderr)
        self.assertIn(f" {steps} steps", answer.stdout)
        apart_m = float(re.search(r"largest distance +(\S+) m", answer.stdout)[1])
        apart_ml = float(re.search(r"largest dV apart +(\S+) ml", answer.stdout)[1])
        self.assertLess(apart_m, 1e-9)
        self.assertLess(apart_ml, 1e-4)  # 1e-9 m over the 0.05 m2 of the diaphragm, and then some

    def test_variational_reaction_and_ribs(self):
        self.assert_agrees("healthy", "--set", "time.dt_ms=1", steps=4500)

    def test_published_reaction_without_ribs(self):
        self.assert_agrees("published_healthy", "--set", "time.dt_ms=1", steps=4500)

    def test_paralysis(self):
        self.assert_agrees("hemiparalysis_right", "--set", "time.dt_ms=1", steps=4500)

    def test_sees_a_millionth_of_the_muscle(self):
        """A run with another k_muscle than its scenario says is found out."""
        short = ("--set", "time.dt_ms=3", "--set", "time.duration_s=2.1")
        self.succeeds("simulate", HEALTHY, "-o", "run.h5", *short)
        self.assertEqual(self.ask("run.h5").returncode, 0)
        with h5py.File(self.folder / "run.h5") as run:
            text = run[TEXT][()]
        k_muscle = float(re.search(rb"k_muscle_N_per_m = (\S+)", text)[1])
        self.succeeds("simulate", HEALTHY, "-o", "other.h5", *short,
                      "--set", f"parameters.k_muscle_N_per_m={k_muscle * (1 + 1e-6):.17g}")
        with h5py.File(self.folder / "other.h5", "r+") as other:
            del other[TEXT]
            other[TEXT] = np.bytes_(text)
        answer = self.ask("other.h5")
        self.assertEqual(answer.returncode, 1, answer.stdout + answer.stderr)
        self.assertIn("DIFFERS", answer.stdout)
        self.assertEqual(self.ask("other.h5", "--tolerance", "1e-7").returncode, 0)

    def test_what_is_not_a_run(self):
        answer = self.ask(HEALTHY)
        self.assertEqual(answer.returncode, 2)
        self.assertRegex(answer.stderr, r"\Aoracle: [^\n]*not a run[^\n]*\n\Z")


if __name__ == "__main__":
    unittest.main()
