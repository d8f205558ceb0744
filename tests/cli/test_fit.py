"""trunk fit: what it finds, its options, what it writes and when it writes nothing."""

import re
import signal
import unittest

from support import (FAST_FIT, HEALTHY, TrunkTest, breaths, catches, csv, scenario_with,
                     shared_file, start, trace)

FITTED = (0, 4)  # converged; not identifiable is a result as well


class RealTrace(TrunkTest):
    def test_subject_03(self):
        fit = self.succeeds("fit", HEALTHY, "--trace", shared_file("traces/cant_Subject03_0cmH2O_0mL.csv"),
                            "-o", "s03.h5", codes=FITTED)
        self.assertLessEqual(fit["nrmse_percent"], 10)
        self.assertEqual(set(fit["parameters"]), {"k_elasticity", "k_muscle"})
        self.assertAlmostEqual(fit["tidal_volume_measured_ml"], 1040, delta=80)
        self.assertGreater(len(fit["verdict"]), 20)
        for estimate in (*fit["parameters"].values(), fit["ratio"]):
            self.assertLessEqual({"value", "unit", "stderr", "lower95", "upper95", "at_bound"}, set(estimate))
            self.assertTrue(0 < estimate["lower95"] < estimate["value"] < estimate["upper95"])
        self.assertAlmostEqual(fit["ratio"]["value"], fit["parameters"]["k_muscle"]["value"]
                               / fit["parameters"]["k_elasticity"]["value"], delta=1e-9)


class Fit(TrunkTest):
    def setUp(self):
        super().setUp()
        self.file("t.csv", trace())

    def fit(self, *options, output="f.h5", codes=FITTED, **more):
        return self.succeeds("fit", HEALTHY, "--trace", "t.csv", "-o", output, *FAST_FIT, *options, codes=codes, **more)

    def refuses(self, *options, says):
        return self.refused("fit", HEALTHY, "--trace", "t.csv", "-o", "f.h5", *FAST_FIT, *options, says=says)

    def test_keys_of_the_contract_and_exit_code(self):
        outcome = self.trunk("fit", HEALTHY, "--trace", "t.csv", "-o", "f.h5", *FAST_FIT, "--json")
        fit = outcome.json()
        self.assertLessEqual({"schema", "status", "parameters", "ratio", "nrmse_percent", "tidal_volume_measured_ml",
                              "tidal_volume_error_ml", "peak_time_error_s", "residual_autocorrelation",
                              "condition_number", "identifiable", "verdict", "baseline_nrmse_percent", "algorithm",
                              "evaluations", "failed_evaluations", "breaths_used", "breaths_rejected", "wall_s"}, set(fit))
        self.assertEqual((fit["schema"], fit["breaths_used"], fit["breaths_rejected"]), ("trunk.fit/1", 5, 0))
        self.assertEqual(outcome.code, 0 if fit["identifiable"] else 4)
        self.assertLess(fit["nrmse_percent"], 5)
        self.assertLess(fit["baseline_nrmse_percent"], 1)  # the trace is that model's own

    def test_the_tidal_volume_is_the_one_breaths_shows(self):
        shown = self.succeeds("breaths", "t.csv")["tidal_volume_ml"]
        self.assertAlmostEqual(shown, 500, delta=5)
        self.assertAlmostEqual(self.fit("--fix", "k_elasticity=4000")["tidal_volume_measured_ml"], shown, delta=0.01 * shown)

    def test_a_spelling_of_the_trace_changes_nothing(self):
        plain = self.fit()
        self.file("t.csv", "\ufeff" + csv(*breaths(), "time_s;volume_ml", ";", comma=True))
        spelt = self.fit("--force")
        for fit in (plain, spelt):
            del fit["wall_s"]
        self.assertEqual(plain, spelt)

    def test_two_fits_are_the_same_file(self):
        files = []
        for _ in range(2):
            self.fit("--force", "--max-evaluations", "20", codes=(0, 3, 4), epoch=0)
            files.append((self.folder / "f.h5").read_bytes())
        self.assertEqual(files[0], files[1])

    def test_free_and_fixed_parameters(self):
        both = self.fit("--fix", "k_elasticity=3500", "--free", "k_muscle,damping", output="a.h5")
        self.assertEqual(set(both["parameters"]), {"k_muscle", "damping"})
        kept = self.succeeds("inspect", "a.h5")["parameters"]
        self.assertEqual((kept["k_elasticity"]["value"], kept["k_elasticity"]["free"]), (3500, False))
        one = self.fit("--fix", "k_elasticity=@a.h5", output="b.h5")  # calibrate once, then refit the muscle
        self.assertEqual(set(one["parameters"]), {"k_muscle"})
        self.assertEqual(self.succeeds("inspect", "b.h5")["parameters"]["k_elasticity"]["value"], 3500)
        self.succeeds("simulate", HEALTHY, "-o", "r.h5", "--from", "b.h5", "--set", "time.dt_ms=3")
        self.assertEqual(self.succeeds("inspect", "r.h5")["parameters"]["k_muscle"]["value"],
                         one["parameters"]["k_muscle"]["value"])

    def test_names_and_values_that_are_wrong(self):
        for options, says in ((("--free", "strength"), "'strength'.*; expected one of k_elasticity, k_muscle"),
                              (("--free", "k_muscle,k_muscle"), "'k_muscle'.* twice"),
                              (("--fix", "strength=3"), "--fix strength=3: .*'strength'.*; expected one of"),
                              (("--fix", "k_elasticity"), "expected name=value"),
                              (("--fix", "k_elasticity=soft"), "k_elasticity=soft: 'soft' is not a number; expected name=value"),
                              (("--fix", "k_elasticity=-4000"), "--fix k_elasticity=-4000: -4000 N/m is out of bounds; expected 400 to 16000 N/m"),
                              (("--fix", "k_elasticity=@none.h5"), "none.h5: no such file.*named in --fix k_elasticity=@none.h5"),
                              (("--fix", "k_elasticity=@t.csv"), "t.csv: is not an HDF5 file; expected"),
                              (("--fix", "k_muscle=3", "--fix", "k_elasticity=4000"), "no parameter is free"),
                              (("--fix", "k_muscle=3", "--free", "k_muscle"), "both free and fixed"),
                              (("--algorithm", "guess"), "'guess'; expected bobyqa"),
                              (("--max-evaluations", "0"), "--max-evaluations: '0' found"),
                              (("--tidal-volume-ml", "500"), "one of the two"),
                              (("--breath", "6"), r"t.csv: there is no breath 6; expected 1 to 5"),
                              (("--breath", "0"), "--breath 0: this does not name a breath; expected mean"),
                              (("--breath", "-1"), "--breath -1: this does not name a breath; expected mean"),
                              (("--breath", "third"), "--breath third: this does not name a breath; expected mean"),
                              (("--signal", "belt"), "t.csv:1: .*'belt'"),
                              (("--save-scenario", "none/s.toml"), "none/s.toml: .*folder")):
            with self.subTest(" ".join(options)):
                self.refuses(*options, says=says)

    def test_timing_that_the_trace_would_overwrite_is_refused(self):
        self.refuses("--set", "activation.rise_s=1", says="--timing scenario")
        kept = self.fit("--set", "activation.rise_s=1", "--keep-timing")
        self.assertEqual((kept["activation"]["rise_s"], kept["activation"]["from_trace"]), (1, False))

    def test_a_trace_upside_down_is_pointed_out_and_turned(self):
        time, volume = breaths()
        self.file("down.csv", csv(time, [-v for v in volume], "time_s,volume_ml", ","))
        self.assertIn("--invert", self.trunk("breaths", "down.csv").err)
        plain, turned = (self.succeeds("breaths", *options) for options in (["t.csv"], ["down.csv", "--invert"]))
        self.assertAlmostEqual(turned["tidal_volume_ml"], plain["tidal_volume_ml"], places=6)

    def test_one_breath(self):
        times, volumes = breaths()
        self.file("t.csv", csv(times, [1.3 * v if 3.0 <= t < 4.5 else v for t, v in zip(times, volumes)]))
        fit = self.fit("--breath", "3", "--fix", "k_elasticity=4000")
        self.assertEqual(fit["breaths_used"], 1)
        self.assertAlmostEqual(fit["tidal_volume_measured_ml"], 650, delta=7)

    def test_an_error_is_one_line_though_notes_precede_it(self):
        times, volumes = breaths()
        self.file("t.csv", csv(times, [v + 30 * t for t, v in zip(times, volumes)]))
        self.refuses("--breath", "99", says="breath 99")

    def test_one_number_instead_of_a_trace(self):
        own = self.file("own.toml", scenario_with())
        fit = self.succeeds("fit", own, "--tidal-volume-ml", "300", "-o", "f.h5")
        self.assertEqual(set(fit["parameters"]), {"k_muscle"})
        self.assertIsNone(fit["parameters"]["k_muscle"]["stderr"])
        run = self.succeeds("simulate", own, "-o", "r.h5", "--from", "f.h5")
        self.assertAlmostEqual(run["delta_v_ml"], 300, delta=1)
        for volume in ("5", "-300", "0.3", "nan"):
            self.refused("fit", HEALTHY, "--tidal-volume-ml", volume, "-o", "g.h5", says="expected a number from 10 to 10000")
        self.refused("fit", HEALTHY, "-o", "g.h5", says="--trace FILE or --tidal-volume-ml")

    def test_what_is_not_known_is_not_called_nan(self):
        own = self.file("own.toml", scenario_with())
        shown = self.trunk("fit", own, "--tidal-volume-ml", "300", "-o", "f.h5").out
        for text in (shown, self.trunk("inspect", "f.h5").out):
            self.assertRegex(text, "k_muscle")
            self.assertNotRegex(text, r"\bnan\b")

    def test_too_few_evaluations_is_told(self):
        fit = self.fit("--max-evaluations", "5", codes=(3,))
        self.assertEqual((fit["status"], fit["identifiable"]), ("not_converged", False))
        self.assertRegex(fit["verdict"], "did not converge: 5 evaluations were not enough")
        self.assertEqual(self.succeeds("inspect", "f.h5")["status"], "not_converged")

    def test_an_existing_result_stays(self):
        self.file("f.h5", "years of work")
        self.refuses(says=("f.h5: exists", "--force"))
        self.file("s.toml", "years of work")
        self.refused("fit", HEALTHY, "--trace", "t.csv", "-o", "g.h5", "--save-scenario", "s.toml", says="s.toml: exists")

    def test_force_does_not_replace_the_trace(self):
        self.refused("fit", HEALTHY, "--trace", "t.csv", "-o", "t.csv", *FAST_FIT, "--force", says="t.csv")

    def test_two_outputs_of_one_name(self):
        own = self.file("own.toml", scenario_with())
        self.refused("fit", own, "--tidal-volume-ml", "300", "-o", "f.h5", "--save-scenario", "./f.h5", says="f.h5")


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
        self.refused("check", "elsewhere/t.csv", "--fix", "k_elasticity=2", says="--fix k_elasticity=2: .*expected 400 to")

    def test_two_traces_are_refused(self):
        for command in (("fit", "a.csv", "--trace", "b.csv", "-o", "f.h5"), ("check", "a.csv", "--trace", "b.csv")):
            self.refused(*command, says=r"a\.csv: is taken as a trace, .*\.toml, .*b\.csv; expected one trace")
        self.refused("fit", "a.csv", "--cohort", "list.csv", "-o", "d", says=r"a\.csv: is taken as a trace.*list\.csv")
        self.refused("fit", "elsewhere/t.csv", "--tidal-volume-ml", "500", "-o", "f.h5", says="one of the two")

    def test_an_error_is_one_line(self):
        self.refused("fit", "none.csv", "-o", "f.h5", says="none.csv")
        self.refused("fit", "none.toml", "--trace", "elsewhere/t.csv", "-o", "f.h5", says="none.toml")
        self.refused("fit", "-o", "f.h5", says="--trace FILE or --tidal-volume-ml")


class Interrupted(TrunkTest):
    OPTIONS = ("fit", HEALTHY, "--trace", "t.csv", "-o", "f.h5", *FAST_FIT)

    def setUp(self):
        super().setUp()
        self.file("t.csv", trace(period_s=6, inspiration_s=2, tau_s=0.5, rate_hz=20))

    def simulating(self, process):
        """Whether the fit has simulated something by now."""
        ledger = self.folder / "f.h5.ledger"
        return catches(process) and ledger.exists() and ledger.stat().st_size > 80_000

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


if __name__ == "__main__":
    unittest.main()
