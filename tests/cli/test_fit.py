"""trunk fit: what it finds, its options, what it writes and when it writes nothing."""

import random
import re
import unittest

import h5py

from support import FAST_FIT, HEALTHY, NO_LUNG, ROOT, SCENARIOS, TrunkTest, at_night, breaths, csv, scenario_with, shared_file, trace

FITTED = (0, 4)  # determined, or with an assumption; not determined is a result as well
KEPT = {"status", "parameters", "ratio", "nrmse_percent", "tidal_volume_measured_ml", "tidal_volume_error_ml",
        "peak_time_error_s", "residual_autocorrelation", "condition_number", "verdict", "baseline_nrmse_percent", "algorithm",
        "evaluations", "failed_evaluations", "breaths_used", "breaths_rejected", "wall_s"}  # of trunk.fit/1
NEW = {"schema", "grade", "gates", "headline", "results", "straight_activation", "simulations", "notes", "input"}
RESULTS = {"r_ei", "recoil_time_s", "k_muscle_over_k_elasticity", "k_elasticity", "k_muscle", "excursion_right_mm",
           "excursion_left_mm", "delta_l_mm", "delta_h_mm", "end_expiratory_above_relaxation_ml"}
OF_LUNG = {"abdominal_elastance_cmH2O_per_L", "lung_elastance_cmH2O_per_L", "respiratory_elastance_cmH2O_per_L",
           "resistance_cmH2O_s_per_L", "intrinsic_peep_cmH2O", "gastric_swing_cmH2O", "pleural_swing_cmH2O",
           "transdiaphragmatic_swing_cmH2O"}
OF_MUSCLE = {"r_ei", "recoil_time_s", "k_muscle_over_k_elasticity", "k_elasticity", "k_muscle"}  # a gate withholds them
GRADES = ("determined", "assumption", "not_determined", "not_converged")  # from best to worst


class RealTrace(TrunkTest):
    def test_subject_03(self):
        fit = self.succeeds("fit", HEALTHY, "--trace", shared_file("traces/cant_Subject03_0cmH2O_0mL.csv"),
                            "-o", "s03.h5", codes=FITTED)
        self.assertLessEqual(fit["nrmse_percent"], 1)
        self.assertEqual((fit["grade"], fit["gates"], fit["input"]), ("assumption", [], "cant_Subject03_0cmH2O_0mL.csv"))
        self.assertLessEqual(fit["simulations"], 40)
        for name in OF_MUSCLE - {"r_ei"}:
            self.assertNotEqual(fit["results"][name]["grade"], "determined", name)
        self.assertEqual(set(fit["parameters"]), {"k_elasticity", "k_muscle"})
        self.assertAlmostEqual(fit["tidal_volume_measured_ml"], 1040, delta=80)
        self.assertGreater(len(fit["verdict"]), 20)
        for estimate in (*fit["parameters"].values(), fit["ratio"]):
            self.assertLessEqual({"value", "unit", "stderr", "lower95", "upper95", "at_bound"}, set(estimate))
            self.assertTrue(0 < estimate["lower95"] < estimate["value"] < estimate["upper95"])
        self.assertAlmostEqual(fit["ratio"]["value"], fit["parameters"]["k_muscle"]["value"]
                               / fit["parameters"]["k_elasticity"]["value"], delta=1e-9)


class Contract(TrunkTest):
    """What a default fit promises, on the default trunk."""

    def fit(self, file, *options):
        fit = self.succeeds("fit", HEALTHY, "--trace", file, "-o", "f.h5", "--force", "--surface", "0", *options)
        self.assertEqual((fit["grade"], fit["gates"]), ("assumption", []))
        return fit["results"]

    @at_night
    def test_twice_the_damping_to_begin_with_changes_nothing(self):
        once, twice = (self.fit(ROOT / "reference/canterbury_subject03.csv", "--set", f"parameters.damping_N_s_per_m={damping}")
                       for damping in (14.5, 29))
        self.assertEqual(list(once), list(twice))
        for name, result in once.items():
            self.assertAlmostEqual(twice[name]["value"] / result["value"], 1, delta=0.01, msg=name)
            self.assertEqual(twice[name]["grade"], result["grade"], name)

    @at_night
    def test_odd_and_even_breaths_overlap(self):
        rng = random.Random(1)
        times, volumes = breaths(count=16, period_s=4, inspiration_s=1.6, tau_s=0.35, rate_hz=50)
        found = []
        for first in (0, 1):
            sizes = [rng.gauss(1, 0.1) for _ in range(8)]
            joined = [size * v for k, size in enumerate(sizes) for v in volumes[200 * (2 * k + first):200 * (2 * k + first + 1)]]
            self.file("half.csv", csv(times[:len(joined) + 1], joined + [0.0]))
            found.append(self.fit("half.csv"))
        for name, odd in found[0].items():
            even = found[1][name]
            self.assertLess(max(odd["lower95"], even["lower95"]), min(odd["upper95"], even["upper95"]), name)


class OnePosterior(TrunkTest):
    TRACE = str(ROOT / "reference/canterbury_subject03.csv")

    def fit(self, *options, scenario):
        return self.succeeds("fit", scenario, "--trace", self.TRACE, "-o", "f.h5", "--force", "--surface", "0", *options)["results"]

    def test_a_prior_narrows_the_interval_that_it_moves(self):
        for scenario, mean in ((HEALTHY, 1930), (NO_LUNG, 4000)):
            with self.subTest(scenario):
                self.check_a_prior(scenario, mean)

    def check_a_prior(self, scenario, mean):
        found = self.fit("--prior", f"k_elasticity={mean}:1.1", scenario=scenario)["k_elasticity"]
        self.assertTrue(found["lower95"] < found["value"] < found["upper95"])
        self.assertAlmostEqual(found["value"], mean, delta=0.15 * mean)
        self.assertLess(found["upper95"] / found["lower95"], 1.1 ** (2 * 2.5))  # the prior alone: 1.1^3.92
        with h5py.File(self.folder / "f.h5") as file:  # what predictions rest on
            names = [name.decode() for name in file["draws/parameter"]]
            drawn = sorted(file["draws/value"][:, names.index("k_elasticity")])
        # Of 64 draws, three are expected outside.
        self.assertTrue(found["lower95"] < drawn[3] and drawn[-4] < found["upper95"], drawn)

    def test_a_muscle_held_at_its_fitted_value_gives_the_same_tissue(self):
        for scenario, narrower in ((NO_LUNG, 0.5), (HEALTHY, 0.7)):  # a lung's stiffness adds to the tissue's
            free = self.fit(scenario=scenario)
            held = self.fit("--fix", f"k_muscle={free['k_muscle']['value']}", scenario=scenario)["k_elasticity"]
            self.assertAlmostEqual(held["value"] / free["k_elasticity"]["value"], 1, delta=0.02)
            wide = free["k_elasticity"]["upper95"] / free["k_elasticity"]["lower95"]
            self.assertLess(held["upper95"] / held["lower95"], narrower * wide)


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
        self.assertEqual((KEPT | NEW) - set(fit), set())
        self.assertNotIn("identifiable", fit)
        self.assertEqual((fit["schema"], fit["breaths_used"], fit["breaths_rejected"]), ("trunk.fit/2", 5, 0))
        self.assertEqual(set(fit["results"]), RESULTS | OF_LUNG)
        for name, result in fit["results"].items():
            shares = {"shares"} if name in OF_MUSCLE | OF_LUNG | {"end_expiratory_above_relaxation_ml"} else set()
            self.assertEqual(set(result), shares | {"value", "unit", "lower95", "upper95", "grade", "assumption", "reason",
                                                    "meaning"})
            if shares:
                self.assertAlmostEqual(sum(result["shares"].values()), 1, msg=name)
            self.assertIn(result["grade"], GRADES)
            self.assertGreater(len(result["meaning"]), 20, name)
            self.assertNotIn("\n", result["meaning"])
            self.assertTrue(result["lower95"] <= result["value"] <= (result["upper95"] or float("inf")), name)
            if result["grade"] == "assumption":
                self.assertIsNotNone(result["assumption"], name)
            if result["grade"] == "not_determined":
                self.assertIsNotNone(result["reason"], name)
        self.assertLessEqual(len(fit["headline"]), 8)
        self.assertEqual(fit["grade"], max((fit["results"][name]["grade"] for name in fit["headline"]), key=GRADES.index))
        self.assertEqual(outcome.code, 4 if fit["grade"] == "not_determined" else 0)
        self.assertEqual(set(fit["straight_activation"]), {"recoil_time_s", "k_muscle_over_k_elasticity", "k_elasticity",
                                                           "k_muscle", "nrmse_percent"})
        self.assertEqual((fit["input"], fit["gates"]), ("t.csv", []))
        self.assertTrue(0 < fit["simulations"] <= fit["evaluations"])
        self.assertAlmostEqual(fit["results"]["k_muscle_over_k_elasticity"]["value"], fit["ratio"]["value"], delta=1e-12)
        for name, estimate in fit["parameters"].items():  # a number has one interval wherever it stands
            self.assertEqual([estimate[end] for end in ("value", "lower95", "upper95")],
                             [fit["results"][name][end] for end in ("value", "lower95", "upper95")])
        self.assertLess(fit["nrmse_percent"], 5)
        by_trace = self.succeeds("fit", NO_LUNG, "--trace", "t.csv", "-o", "f.h5", *FAST_FIT, "--timing", "trace", "--force",
                                 codes=FITTED)
        self.assertLess(by_trace["baseline_nrmse_percent"], 0.5)  # the trace is that model's own

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
                              (("--fix", "k_elasticity=-4000"), "--fix k_elasticity=-4000: -4000 N/m is out of bounds; expected 20 to 100000 N/m"),
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
        self.assertEqual((fit["grade"], fit["headline"], fit["input"]), ("assumption", ["k_muscle"], None))
        muscle = fit["results"]["k_muscle"]
        self.assertEqual((muscle["value"], muscle["lower95"]), (fit["parameters"]["k_muscle"]["value"], None))
        self.assertRegex(muscle["assumption"], "as in the scenario")
        self.assertRegex(fit["verdict"], "One tidal volume gives k_muscle")
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
        self.assertEqual((fit["status"], fit["grade"], fit["results"]), ("not_converged", "not_converged", {}))
        self.assertRegex(fit["verdict"], "search did not end")
        self.assertEqual(self.succeeds("inspect", "f.h5")["grade"], "not_converged")

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


class Shown(TrunkTest):
    """What a person sees."""

    def setUp(self):
        super().setUp()
        self.file("t.csv", trace(count=6))

    def lines(self, *options, text=None):
        if text:
            self.file("t.csv", text)
        outcome = self.trunk("fit", HEALTHY, "--trace", "t.csv", "-o", "f.h5", "--force", *FAST_FIT, *options)
        self.assertIn(outcome.code, FITTED, str(outcome))
        return outcome.out.splitlines()

    def test_at_most_eight_numbers_each_with_interval_grade_and_meaning(self):
        lines = self.lines()
        self.assertRegex(lines[0], r"\A6 breaths used, 0 rejected; tidal volume \d+ ml, 1\.50 s a breath\Z")
        self.assertRegex(lines[1], r"value \(95 % interval\) +grade +straight lines\Z")
        rows = [i for i, line in enumerate(lines) if re.match(r"  \w.* \([\d.]+ to ([\d.]+|no limit)\)", line)]
        self.assertEqual(len(rows), 8, "\n".join(lines))
        for i in rows:
            self.assertRegex(lines[i], r"(determined|assumes \([\d, ]+\)|not determined (\(\d+\)|\*))")
            self.assertRegex(lines[i + 1], r"\A      \w[^\d]{20,}\w+")  # what it means
        self.assertRegex(lines[rows[1]], r"\A  recoil time .* s +assumes")
        fit = self.succeeds("inspect", "f.h5")
        self.assertIn(fit["verdict"], lines[-2])
        self.assertEqual(lines[-1], "Written to f.h5")
        for number in range(1, 4):
            self.assertEqual(sum(line.startswith(f"  ({number}) ") for line in lines), 1)
        self.assertLess(max(len(line) for line in lines[:-2]), 120)

    def test_digits_end_where_the_interval_does(self):
        line = next(line for line in self.lines() if line.startswith("  recoil time"))
        value, low, high = (float(v) for v in re.search(r"([\d.]+) \(([\d.]+) to ([\d.]+)\) s", line).groups())
        known = self.succeeds("inspect", "f.h5")["results"]["recoil_time_s"]
        side = min(known["value"] - known["lower95"], known["upper95"] - known["value"])
        for shown, exact in ((value, known["value"]), (low, known["lower95"]), (high, known["upper95"])):
            self.assertAlmostEqual(shown, exact, delta=0.06 * side)
        self.assertLessEqual(len(re.search(r"recoil time +([\d.]+)", line)[1].replace(".", "").lstrip("0")), 3)

    def test_details_show_parameters_and_search(self):
        plain, detailed = "\n".join(self.lines()), "\n".join(self.lines("--details"))
        for word in ("std error", "activation: onset", "joint 95 % region: k_elasticity", "simulations of the trunk",
                     "one-compartment model"):
            self.assertNotIn(word, plain)
            self.assertIn(word, detailed)

    def test_a_gate_withholds_and_says_why_once(self):
        lines = self.lines(text=trace(count=6, tidal_ml=40))  # 0.8 % of this trunk's end-expiratory volume
        self.assertEqual(sum("withheld " in line for line in lines), 5, "\n".join(lines))
        self.assertEqual("\n".join(lines).count("this trunk is an adult's of 4760 ml"), 1)
        self.assertRegex(lines[-2], r"\A\* ")
        self.assertRegex(next(line for line in lines if "recoil time" in line), r"withheld +not determined \*")


class Gated(TrunkTest):
    """A recording that is no breathing of this trunk gives no stiffness, wherever one looks."""

    def setUp(self):
        super().setUp()
        self.file("t.csv", trace(count=6, tidal_ml=40))
        self.json = self.succeeds("fit", HEALTHY, "--trace", "t.csv", "-o", "f.h5", *FAST_FIT, codes=(4,))

    def test_json(self):
        self.assertEqual((self.json["gates"], self.json["grade"], self.json["status"]),
                         (["subject_size"], "not_determined", "not_identifiable"))
        self.assertIn("4760 ml", self.json["verdict"])
        for name in OF_MUSCLE:
            result = self.json["results"][name]
            self.assertEqual([result[key] for key in ("value", "lower95", "upper95", "grade")], [None] * 3 + ["not_determined"])
            self.assertIn("4760 ml", result["reason"])
        for estimate in (*self.json["parameters"].values(), self.json["ratio"]):
            self.assertEqual([estimate[key] for key in ("value", "stderr", "lower95", "upper95", "naive_lower95")], [None] * 5)
        for name in ("recoil_time_s", "k_elasticity", "k_muscle"):
            self.assertIsNone(self.json["straight_activation"][name]["value"])
        self.assertEqual({"profiles", "surface", "bootstrap"} & set(self.json), set())

    def test_file(self):
        kept = self.succeeds("inspect", "f.h5")
        self.assertEqual((kept["gates"], kept["grade"]), (["subject_size"], "not_determined"))
        for result in self.json["results"].values():  # files spell units as UDUNITS does
            result["unit"] = re.sub(r"/(\w+)$", r" \1-1", result["unit"])
            result.pop("shares", None)  # the file has them as a text, rests_on
        self.assertEqual(kept["results"], self.json["results"])
        text = self.trunk("inspect", "f.h5").out
        self.assertEqual(text.count("gate subject_size: a tidal volume of"), 1)
        self.assertRegex(text, r"recoil_time_s +withheld, not_determined: gate subject_size\n")

    def test_goes_before_a_search_that_did_not_end(self):
        fit = self.succeeds("fit", HEALTHY, "--trace", "t.csv", "-o", "g.h5", *FAST_FIT, "--max-evaluations", "5", codes=(4,))
        self.assertEqual((fit["grade"], fit["gates"]), ("not_determined", ["subject_size"]))
        self.assertIn("4760 ml", fit["verdict"])

    def test_nothing_else_is_made_of_it(self):
        paralysed = str(SCENARIOS / "hemiparalysis_right.toml")
        outcome = self.trunk("fit", HEALTHY, "--trace", "t.csv", "-o", "g.h5", *FAST_FIT, "--breath", "each", "--predict",
                             paralysed, "--json")
        self.assertEqual((outcome.json().get("predictions", {}), outcome.json().get("breaths", [])), ({}, []))
        self.assertIn("no single breath is fitted and no other scenario is predicted", outcome.err)
        self.assertNotIn("(by profile)", self.trunk("fit", HEALTHY, "--trace", "t.csv", "-o", "h.h5", *FAST_FIT, "--details").out)

        simulated = self.trunk("simulate", paralysed, "--from", "f.h5", "-o", "r.h5", "--json", *FAST_FIT)
        self.assertRegex(simulated.err, "note: a gate stopped the fit f.h5, so this simulation tells nothing of the subject")
        self.assertNotIn("delta_v_ml_lower95", simulated.json())
        self.refused("fit", HEALTHY, "--trace", "t.csv", "-o", "k.h5", "--fix", "k_elasticity=@f.h5",
                     says="f.h5 withholds k_elasticity: a tidal volume of")
        self.file("s.toml", f'schema = "trunk.sweep/1"\nscenarios = ["{HEALTHY}"]\nsubjects = ["f.h5"]\n')
        self.refused("sweep", "s.toml", "-o", "d", says="f.h5: a gate stopped this fit: a tidal volume of")
        self.assertIn("not to be fitted as it is", self.trunk("check", HEALTHY, "--trace", "t.csv").out)


if __name__ == "__main__":
    unittest.main()
