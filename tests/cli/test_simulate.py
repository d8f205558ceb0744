"""trunk simulate: the shipped scenarios, --set, --from, what a run leaves behind."""

import re
import unittest
from pathlib import Path

import h5py

from support import AT_REST, COARSE, HEALTHY, SCENARIOS, TrunkTest

NAMES = sorted(p.stem for p in SCENARIOS.glob("*.toml") if not p.stem.startswith("sweep_"))


class ShippedScenarios(TrunkTest):
    def run_scenario(self, name):
        return self.succeeds("simulate", SCENARIOS / f"{name}.toml", "-o", f"{name}.h5")

    def test_all_of_the_contract_are_there(self):
        self.assertLessEqual({"healthy", "healthy_no_lung", "hemiparalysis_right", "hemiparalysis_left",
                              "exercise_healthy", "exercise_hemiparalysis_right", "published_healthy",
                              "published_hemiparalysis_right"}, set(NAMES))

    def test_healthy_is_the_paper_s_subject(self):
        run = self.run_scenario("healthy")
        self.assertEqual(run["schema"], "trunk.simulate/1")
        self.assertEqual(run["status"], "completed")
        self.assertAlmostEqual(run["delta_v_ml"], 466, delta=4.66)
        self.assertEqual(run["particles"], 113)
        self.assertLessEqual(run["max_relative_volume_error"], 1e-9)
        self.assertAlmostEqual(run["end_expiratory_volume_ml"], 4760, delta=0.1)
        self.assertAlmostEqual(run["end_inspiratory_volume_ml"] - run["end_expiratory_volume_ml"],
                               run["delta_v_ml"], delta=1e-6)
        self.assertAlmostEqual(run["delta_v_percent"], 100 * run["delta_v_ml"] / run["end_expiratory_volume_ml"],
                               delta=1e-6)
        self.assertEqual(run["steps"], 4500)
        self.assertEqual(run["dt_s"], 0.001)
        for side in ("left", "right"):  # both domes descend, alike
            self.assertAlmostEqual(run[f"excursion_{side}_mm"] / run["excursion_left_mm"], 1, delta=0.02)
            self.assertGreater(run[f"excursion_{side}_mm"], 0)

    def test_all_complete_and_keep_their_volume(self):
        for name in NAMES:
            with self.subTest(name):
                run = self.run_scenario(name)
                self.assertEqual(run["status"], "completed")
                bound = 1e-13 if name.startswith("published") else 1e-9
                self.assertLessEqual(run["max_relative_volume_error"], bound)
                self.assertGreater(run["delta_v_ml"], 100)
                self.assert_pressures_are_named(run, self.folder / f"{name}.h5")

    def assert_pressures_are_named(self, run, path):
        """Every scenario has all names; without a lung there is no pleural pressure."""
        with h5py.File(path) as file:
            lung, stored = "curves/pleural_pressure" in file, set(file["measures"])
        for name in ("gastric_swing_cmH2O", "excursion_right_most_risen_mm", "excursion_left_most_risen_mm", "recoil_time_s"):
            self.assertIsNotNone(run[name], name)
            self.assertIn(name, stored)
        self.assertLessEqual(run["excursion_right_most_risen_mm"], min(0, run["excursion_right_mm"]) + 1e-9)
        self.assertGreater(run["recoil_time_s"], 0)
        for name in ("pleural_swing_cmH2O", "transdiaphragmatic_swing_cmH2O"):
            self.assertEqual((run[name] is not None, name in stored), (lung, lung), name)

    def test_fitted_scenarios_reach_the_volume_they_name(self):
        for name, volume in (("healthy_no_lung", 466), ("published_healthy", 438), ("exercise_healthy", 1200)):
            with self.subTest(name):
                self.assertAlmostEqual(self.run_scenario(name)["delta_v_ml"], volume, delta=0.01 * volume)

    def test_left_and_right_paralysis_mirror_each_other(self):
        left, right = self.run_scenario("hemiparalysis_left"), self.run_scenario("hemiparalysis_right")
        healthy = self.run_scenario("healthy")
        for of_left, of_right in (("delta_v_ml", "delta_v_ml"), ("delta_l_mm", "delta_l_mm"),
                                  ("excursion_left_mm", "excursion_right_mm"),
                                  ("excursion_right_mm", "excursion_left_mm")):
            self.assertAlmostEqual(left[of_left], right[of_right], delta=0.02 * abs(right[of_right]), msg=of_left)
        self.assertLess(right["delta_v_ml"], 0.8 * healthy["delta_v_ml"])
        self.assertLess(right["excursion_right_mm"], 0.5 * right["excursion_left_mm"])


class Options(TrunkTest):
    def test_set_reaches_the_result(self):
        run = self.succeeds("simulate", HEALTHY, "-o", "a.h5", *COARSE, "--set", "parameters.k_muscle_N_per_m=60",
                            "--set", "paralysis.side=right")
        self.assertEqual((run["steps"], run["dt_s"]), (100, 0.003))
        weaker = self.succeeds("simulate", HEALTHY, "-o", "b.h5", *COARSE, "--set", "paralysis.side=right")
        self.assertGreater(run["delta_v_ml"], 1.5 * weaker["delta_v_ml"])
        self.assertLess(run["excursion_right_mm"], run["excursion_left_mm"])
        self.assertEqual(self.succeeds("inspect", "a.h5")["parameters"]["k_muscle"]["value"], 60)

    def test_unknown_or_wrong_settings(self):
        for setting, says in (("parameters.k_muscle=30", "parameters.k_muscle_N_per_m"),
                              ("bogus.key=1", "unknown key 'bogus.key'"),
                              ("parameters.k_muscle_N_per_m=strong", "strong.*expected a number of N"),
                              ("parameters.k_muscle_N_per_m=nan", "expected a number"),
                              ("parameters.k_muscle_N_per_m", "key=value"),
                              ("paralysis.side=middle", "middle.*\"right\""),
                              ("tissue.ribs=perhaps", "perhaps.*true or false"),
                              ("geometry.half_width_mm=0.16", "0.16; expected .*50 to 400")):
            with self.subTest(setting):
                self.refused("simulate", HEALTHY, "-o", "a.h5", "--set", setting, says=says)

    def test_parameters_from_a_run(self):
        self.succeeds("simulate", HEALTHY, "-o", "a.h5", *COARSE, "--set", "parameters.k_muscle_N_per_m=47")
        self.succeeds("simulate", HEALTHY, "-o", "b.h5", "--from", "a.h5", "--set", "time.dt_ms=3")
        self.assertEqual(self.succeeds("inspect", "b.h5")["parameters"]["k_muscle"]["value"], 47)
        self.refused("simulate", HEALTHY, "-o", "c.h5", "--from", "none.h5", says="none.h5: no such file")
        self.refused("simulate", HEALTHY, "-o", "c.h5", "--from", HEALTHY, says="not an HDF5 file; expected")

    def test_set_wins_over_from(self):
        """What is typed on the command line is what is simulated."""
        self.succeeds("simulate", HEALTHY, "-o", "a.h5", *COARSE, "--set", "parameters.k_muscle_N_per_m=47")
        run = self.succeeds("simulate", HEALTHY, "-o", "b.h5", "--from", "a.h5", *COARSE,
                            "--set", "parameters.k_muscle_N_per_m=55")
        self.assertEqual(self.succeeds("inspect", "b.h5")["parameters"]["k_muscle"]["value"], 55)
        self.assertEqual(run["steps"], 100)

    def test_two_runs_are_the_same_file(self):
        files = []
        for _ in range(2):
            self.succeeds("simulate", HEALTHY, "-o", "a.h5", *COARSE, "--force", epoch=0)
            files.append((self.folder / "a.h5").read_bytes())
        self.assertEqual(files[0], files[1])

    def test_a_run_that_diverges_is_told_and_kept(self):
        """10 tons on every particle of the tendon: numbers that mean nothing are not shown as results."""
        own = self.file("own.toml", f'extends = "{HEALTHY}"\n[[force]]\nregion = "central_tendon"\n'
                                    "direction = [0, 0, 1]\nevents_N = [[0, 0], [0.1, 100000]]\n")
        outcome = self.trunk("simulate", own, "-o", "a.h5", *AT_REST, "--json")
        self.assertEqual(outcome.code, 3, str(outcome))
        run = outcome.json()
        self.assertIn(run["status"], ("diverged", "volume_lost"))
        self.assertRegex(run["message"], r"diverged|volume")
        self.assertEqual(self.succeeds("inspect", "a.h5")["status"], run["status"])
        self.assert_no_part()
        self.assertIsNone(run["delta_v_ml"])  # 0 ml would be read as a breath of 0 ml

    def test_an_existing_result_stays(self):
        self.succeeds("simulate", HEALTHY, "-o", "a.h5", *COARSE)
        self.refused("simulate", HEALTHY, "-o", "a.h5", *COARSE, says=("a.h5", "exists", "--force"))
        before = (self.folder / "a.h5").stat().st_ino
        self.succeeds("simulate", HEALTHY, "-o", "a.h5", *COARSE, "--force")
        self.assertNotEqual((self.folder / "a.h5").stat().st_ino, before)

    def test_force_does_not_replace_the_input(self):
        own = self.file("own.toml", Path(HEALTHY).read_text())
        self.refused("simulate", own, "-o", own, *COARSE, "--force", says="own.toml")


class BreathingThatRepeats(TrunkTest):
    QUICK = ("--set", "time.duration_s=1.5", "--set", "activation.rise_s=0.5", "--set", "activation.slow_fall_s=0.4",
             "--set", "time.dt_ms=3")
    LEVEL = "end_expiratory_above_relaxation_ml"

    def test_the_volume_above_relaxation_is_a_result(self):
        rest = self.succeeds("simulate", HEALTHY, "-o", "rest.h5", *self.QUICK, *AT_REST)
        run = self.succeeds("simulate", HEALTHY, "-o", "run.h5", *self.QUICK, "--set", "time.start=periodic")
        self.assertEqual(rest[self.LEVEL], 0)
        self.assertGreater(run[self.LEVEL], 20)
        self.assertAlmostEqual(run["end_expiratory_volume_ml"] - rest["end_expiratory_volume_ml"], run[self.LEVEL],
                               delta=1e-6)
        self.assertLess(run["delta_v_ml"], rest["delta_v_ml"])
        self.assertEqual(run["steps"], rest["steps"])
        self.assertEqual(self.succeeds("inspect", "run.h5")["measures"][self.LEVEL],
                         {"value": run[self.LEVEL], "unit": "ml"})
        self.assertRegex(self.trunk("inspect", "run.h5").out, rf"{self.LEVEL} +{run[self.LEVEL]:.6g} ml")
        self.succeeds("replay", "run.h5", "--tolerance", "0")
        self.succeeds("replay", "rest.h5", "--tolerance", "0")
        self.assertIn(f"measures {self.LEVEL}", re.sub(" +", " ", self.trunk("diff", "rest.h5", "run.h5").out))

    def test_a_file_says_how_its_breath_starts(self):
        """A scenario that says nothing starts at rest, and its text still says nothing."""
        own = self.file("own.toml", 'schema = "trunk.scenario/1"\n')
        for settings, says in (((), None), (("--set", "time.start=rest"), "rest"),
                               (("--set", "time.start=periodic"), "periodic")):
            run = self.succeeds("simulate", own, "-o", "a.h5", "--force", *self.QUICK, *settings)
            self.assertEqual(run[self.LEVEL] > 0, says == "periodic")
            with h5py.File(self.folder / "a.h5") as file:
                text = file["parameters/scenario_toml"][()].decode()
            self.assertEqual(re.findall(r'(?m)^start = "(\w+)"', text), [says] if says else [])

    def test_a_step_is_chosen_for_it(self):
        run = self.succeeds("simulate", HEALTHY, "-o", "a.h5", "--set", "time.start=periodic", "--set",
                            "time.dt_ms=auto")
        exact = self.succeeds("simulate", HEALTHY, "-o", "b.h5", "--set", "time.start=periodic", "--set",
                              "time.dt_ms=0.5")
        self.assertGreater(run["dt_s"], 0.002)
        self.assertAlmostEqual(run[self.LEVEL], exact[self.LEVEL], delta=1e-3 * exact["delta_v_ml"])
        self.assertAlmostEqual(run["delta_v_ml"], exact["delta_v_ml"], delta=1e-3 * exact["delta_v_ml"])

    def test_what_cannot_repeat(self):
        periodic = ("--set", "time.start=periodic")
        for settings, says in ((("parameters.damping_N_s_per_m=0",), "never forgets"),
                               (("parameters.damping_N_s_per_m=0", "time.dt_ms=auto"), "never forgets"),
                               (("parameters.k_elasticity_N_per_m=10",), "takes 4.. s to forget"),
                               (("time.start=often",), '"rest", "periodic"')):
            every = [part for setting in settings for part in ("--set", setting)]
            self.refused("simulate", HEALTHY, "-o", "a.h5", *periodic, *every, says=says)
        own = self.file("own.toml", f'extends = "{HEALTHY}"\nabdominal_volume_fraction = [[0, 1], [1, 1.01]]\n')
        self.refused("simulate", own, "-o", "a.h5", *periodic, says="cannot repeat")

    def test_one_that_fails_before_its_breath_is_kept(self):
        own = self.file("own.toml", f'extends = "{HEALTHY}"\n[[force]]\nregion = "central_tendon"\n'
                                    "direction = [0, 0, 1]\nevents_N = [[0, 100000]]\n")
        outcome = self.trunk("simulate", own, "-o", "a.h5", "--set", "time.start=periodic", "--json")
        self.assertEqual(outcome.code, 3, str(outcome))
        self.assertIn(outcome.json()["status"], ("diverged", "volume_lost"))
        self.assertIsNone(outcome.json()[self.LEVEL])
        self.assertEqual(self.succeeds("inspect", "a.h5")["status"], outcome.json()["status"])
        self.succeeds("replay", "a.h5", "--tolerance", "0")


class ChosenTimeStep(TrunkTest):
    def test_auto_is_longer_and_as_good(self):
        chosen = self.succeeds("simulate", HEALTHY, "-o", "a.h5", "--set", "time.dt_ms=auto")
        fine = self.succeeds("simulate", HEALTHY, "-o", "f.h5", "--set", "time.dt_ms=0.25")
        self.assertEqual(chosen["dt_chosen"], "auto")
        self.assertGreaterEqual(chosen["dt_s"], 0.002)
        self.assertLess(chosen["dt_s"], chosen["dt_stable_s"])
        self.assertLessEqual(chosen["dt_estimated_error_percent"], 0.1)
        self.assertAlmostEqual(chosen["delta_v_ml"] / fine["delta_v_ml"], 1, delta=1e-3)
        self.assertNotIn("dt_chosen", fine)

    def test_the_choice_is_in_the_file_and_gives_the_same_again(self):
        first = self.succeeds("simulate", HEALTHY, "-o", "a.h5", "--set", "time.dt_ms=auto")
        with h5py.File(self.folder / "a.h5") as file:
            text = file["parameters/scenario_toml"][()].decode()
        self.assertIn('"auto" chose', text)
        self.assertAlmostEqual(float(re.search(r"\ndt_ms = (\S+)\n", text)[1]), 1e3 * first["dt_s"], delta=1e-12)
        (self.folder / "again.toml").write_text(text)
        again = self.succeeds("simulate", "again.toml", "-o", "b.h5")
        self.assertEqual((again["delta_v_ml"], again["dt_s"]), (first["delta_v_ml"], first["dt_s"]))

    def test_check_leaves_it_open(self):
        found = self.succeeds("check", HEALTHY, "--set", "time.dt_ms=auto")
        self.assertNotIn("steps", found)
        self.refused("check", HEALTHY, "--set", "time.dt_ms=automatic", says='or "auto"')


if __name__ == "__main__":
    unittest.main()
