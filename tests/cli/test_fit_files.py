"""trunk fit: what it reads and leaves without being told, and after an interruption."""

import re
import signal
import unittest

from many_fits import FITTED
from support import FAST_FIT, HEALTHY, TrunkTest, catches, scenario_with, start, trace


class Interrupted(TrunkTest):
    OPTIONS = ("fit", HEALTHY, "--trace", "t.csv", "-o", "f.h5", "--set", "time.dt_ms=1")

    def setUp(self):
        super().setUp()
        self.file("t.csv", trace(period_s=6, inspiration_s=2, tau_s=0.5, rate_hz=20))

    def simulating(self, process):
        """Whether the fit has simulated something by now."""
        ledger = self.folder / "f.h5.ledger"
        return catches(process) and ledger.exists() and ledger.stat().st_size > 40_000

    def test_ctrl_c_leaves_what_the_same_command_goes_on_from(self):
        whole = self.succeeds(*self.OPTIONS, codes=FITTED)
        (self.folder / "f.h5").unlink()
        before = self.contents()
        for sign in (signal.SIGINT, signal.SIGTERM):
            process = start(*self.OPTIONS, "--save-scenario", "s.toml", cwd=self.folder)
            outcome = self.interrupt(process, lambda: self.simulating(process), sign)
            self.assertEqual(outcome.code, 130, str(outcome))
            self.assertEqual(outcome.out, "")
            self.assertRegex(outcome.err, r"interrupted: only f.h5.ledger was written; the same command goes on from it\n\Z")
            self.assertEqual(set(self.contents()) - set(before), {str(self.folder / "f.h5.ledger")})
        self.assert_same_fit(whole, self.succeeds(*self.OPTIONS, codes=FITTED))

    def test_kill_9_loses_nothing(self):
        whole = self.succeeds(*self.OPTIONS, codes=FITTED)
        (self.folder / "f.h5").unlink()
        process = start(*self.OPTIONS, cwd=self.folder)
        self.interrupt(process, lambda: self.simulating(process), signal.SIGKILL)
        self.assertFalse((self.folder / "f.h5").exists())
        self.assert_same_fit(whole, self.succeeds(*self.OPTIONS, codes=FITTED))

    def assert_same_fit(self, whole, resumed):
        """Bit for bit, with fewer simulations, and the ledger gone."""
        self.assertGreater(resumed["replayed"], 0)
        self.assertLess(resumed["simulated"], whole["simulated"])
        self.assertEqual(resumed["evaluations"], whole["evaluations"])
        for fit in (whole, resumed):
            for key in ("wall_s", "simulated", "replayed"):
                del fit[key]
        self.assertEqual(resumed, whole)
        self.assertEqual([p.name for p in self.folder.glob("f.h5*")], ["f.h5"])

    def test_another_command_does_not_take_over(self):
        process = start(*self.OPTIONS, cwd=self.folder)
        self.interrupt(process, lambda: self.simulating(process), signal.SIGKILL)
        other = self.succeeds(*self.OPTIONS, "--set", "parameters.damping_N_s_per_m=21", codes=FITTED)
        self.assertEqual(other["replayed"], 0)


class SavedScenario(TrunkTest):
    def fit(self, scenario, *options):
        return self.succeeds("fit", scenario, "--tidal-volume-ml", "300", "-o", "f.h5", *options)

    def test_is_whole_and_reaches_the_volume(self):
        value = self.fit(HEALTHY, "--save-scenario", "s.toml")["parameters"]["k_muscle"]["value"]
        text = (self.folder / "s.toml").read_text()
        self.assertNotIn("extends", text)
        saved = float(re.search(r"^k_muscle_N_per_m = ([\d.]+)$", text, re.M)[1])
        self.assertAlmostEqual(saved / value, 1, delta=1e-5)
        self.assertAlmostEqual(self.succeeds("simulate", "s.toml", "-o", "r.h5")["delta_v_ml"], 300, delta=1)

    def assert_saved_or_refused(self, scenario, saved):
        """Either a scenario that reaches the volume, or a refusal before anything was done."""
        before = self.contents()
        outcome = self.trunk("fit", scenario, "--tidal-volume-ml", "300", "-o", "f.h5", "--save-scenario", saved)
        if outcome.code == 2:
            self.assert_one_line(outcome)
            self.assertEqual(self.contents(), before, "refused, but something was written: " + outcome.err)
        else:
            self.assertEqual(outcome.code, 0, str(outcome))
            self.assertAlmostEqual(self.succeeds("simulate", saved, "-o", "r.h5")["delta_v_ml"], 300, delta=1)

    def test_a_value_that_another_file_sets(self):
        self.file("base.toml", scenario_with())
        self.file("own.toml", 'extends = "base.toml"\ntitle = "own"\n')
        self.assert_saved_or_refused("own.toml", "s.toml")

    def test_into_another_folder(self):
        self.file("base.toml", scenario_with())
        self.file("own.toml", 'extends = "base.toml"\n[parameters]\nk_muscle_N_per_m = 30\n')
        (self.folder / "elsewhere").mkdir()
        self.assert_saved_or_refused("own.toml", "elsewhere/s.toml")

    def test_all_parameters_on_one_line(self):
        self.file("base.toml", scenario_with())
        self.file("own.toml", 'extends = "base.toml"\n'
                              "parameters = { damping_N_s_per_m = 20, k_muscle_N_per_m = 30 }  # mine\n")
        self.assert_saved_or_refused("own.toml", "s.toml")


class WithoutScenario(TrunkTest):
    """A trace alone is fitted with the scenario that comes with the program, from any folder."""

    def setUp(self):
        super().setUp()
        (self.folder / "elsewhere").mkdir()
        self.file("elsewhere/t.csv", trace())

    def test_takes_the_shipped_one_and_says_so(self):
        whole = self.succeeds("fit", HEALTHY, "--trace", "elsewhere/t.csv", "-o", "f.h5", *FAST_FIT, codes=FITTED)
        for name, files in (("a.h5", ["elsewhere/t.csv"]), ("b.h5", ["--trace", "elsewhere/t.csv"])):
            outcome = self.trunk("fit", *files, "-o", name, *FAST_FIT, "--json")
            self.assertRegex(outcome.err, r"\Anote: no scenario is named, so trunk takes \S*scenarios/healthy\.toml\n\Z")
            fit = outcome.json()
            del fit["wall_s"]
            self.assertEqual(fit, {key: value for key, value in whole.items() if key != "wall_s"})
            inputs = self.succeeds("inspect", name)["provenance"]["input_sha256"]
            self.assertIn("healthy.toml", str(inputs))
            self.assertIn("t.csv", str(inputs))

    def test_one_number(self):
        fit = self.succeeds("fit", "--tidal-volume-ml", "300", "-o", "f.h5", *FAST_FIT)
        self.assertEqual(set(fit["parameters"]), {"k_muscle"})

    def test_check_does_the_same(self):
        for files in (["elsewhere/t.csv"], ["--trace", "elsewhere/t.csv"]):
            checked = self.succeeds("check", *files)
            self.assertEqual((checked["particles"], checked["breaths_used"]), (113, 5))
            self.assertRegex(checked["scenario"], r"scenarios/healthy\.toml$")
            self.assertRegex(checked["notes"][0], "no scenario is named")
        self.refused("check", "elsewhere/t.csv", "--fix", "k_elasticity=2", says="--fix k_elasticity=2: .*expected 20 to")

    def test_two_traces_are_refused(self):
        for command in (("fit", "a.csv", "--trace", "b.csv", "-o", "f.h5"), ("check", "a.csv", "--trace", "b.csv")):
            self.refused(*command, says=r"a\.csv: is taken as a trace, .*\.toml, .*b\.csv; expected one trace")
        self.refused("fit", "a.csv", "--cohort", "list.csv", "-o", "d", says=r"a\.csv: is taken as a trace.*list\.csv")
        self.refused("fit", "elsewhere/t.csv", "--tidal-volume-ml", "500", "-o", "f.h5", says="one of the two")

    def test_an_error_is_one_line(self):
        self.refused("fit", "none.csv", "-o", "f.h5", says="none.csv")
        self.refused("fit", "none.toml", "--trace", "elsewhere/t.csv", "-o", "f.h5", says="none.toml")
        self.refused("fit", "-o", "f.h5", says="--trace FILE or --tidal-volume-ml")


if __name__ == "__main__":
    unittest.main()
