"""What a fit predicts of another scenario, from its file and with a sweep."""

import csv as tables
import io
import math
import random
import unittest

import h5py

from many_fits import FITTED, ONE, PARALYSED, QUICK, noisy
from support import COARSE, FAST_FIT, HEALTHY, NO_LUNG, ROOT, TrunkTest, at_night, csv, trace


class Prediction(TrunkTest):
    def no_lung(self):
        """The trunk without a lung, and its right-paralysed twin."""
        return NO_LUNG, self.file("hemiparalysis_right.toml", f'extends = "{NO_LUNG}"\n[paralysis]\nside = "right"\n'
                                  "stiffness_factor = 0.5\n")

    def predicted(self, *options, text=None, output="f.h5", of=HEALTHY, scenario=PARALYSED, structural=False):
        self.file("t.csv", text or trace())
        fit = self.succeeds("fit", of, "--trace", "t.csv", "-o", output, "--scenario", scenario, "--force",
                            *options, *(() if structural else ("--no-structural",)), codes=FITTED)
        return fit["predictions"]["hemiparalysis_right"]

    def test_has_a_second_interval_over_choices_of_the_model(self):
        p = self.predicted(*ONE, "--draws", "16", structural=True)
        run = self.succeeds("simulate", PARALYSED, "-o", "r.h5", "--from", "f.h5", "--set", "time.dt_ms=3")
        names = [name for name, number in p.items() if isinstance(number, dict)]
        for name in names:
            for end in ("structural_lower95", "structural_upper95"):
                self.assertAlmostEqual(run[f"{name}_{end}"], p[name][end], delta=1e-9 * max(1, abs(p[name][end])), msg=name)
            self.assertEqual(run["structural_shares"][name], p[name]["structural_shares"])
        ratio, dome = p["ratio_percent"], p["excursion_right_mm"]
        self.assertTrue(ratio["structural_lower95"] < ratio["value"] < ratio["structural_upper95"])
        self.assertGreater(ratio["structural_upper95"] - ratio["structural_lower95"], 2)
        self.assertAlmostEqual(sum(dome["structural_shares"].values()), 1)
        self.assertIsNone(p["own_delta_v_ml"]["structural_shares"])  # the refit keeps it
        ranges = {c["name"]: tuple(round(c[end], 9) for end in ("low", "value", "high")) for c in p["structural_choices"]}
        with h5py.File(self.folder / "f.h5") as stored:  # about what was fitted
            wall = dict(zip(stored["parameters/name"].asstr()[()], stored["parameters/best"][()]))["abdomen_stiffness_factor"]
        self.assertEqual(ranges["abdominal_wall"], tuple(round(factor * wall, 9) for factor in (0.625, 1, 1.6)))
        self.assertEqual(ranges["mesh"], (1, 1, 2))
        self.assertEqual((p["structural_notes"], run["structural_choices"]), ([], p["structural_choices"]))
        for file, group in (("r.h5", ""), ("f.h5", "predictions/hemiparalysis_right/")):
            with h5py.File(self.folder / file) as stored:
                structure = stored[group + "structure"]
                at = [name.decode() for name in structure["measure"]].index("excursion_right_mm")
                kept = dict(zip([name.decode() for name in structure["choice"]], structure["share"][at]))
                self.assertEqual(kept, dome["structural_shares"])
        with h5py.File(self.folder / "r.h5") as stored:
            self.assertEqual(stored["intervals/delta_l_mm_structural_upper95"][()], run["delta_l_mm_structural_upper95"])
        self.succeeds("export", "f.h5", "--csv", "out")
        rows = {r["choice"]: r for r in tables.DictReader(io.StringIO((self.folder / "out/structure_hemiparalysis_right.csv").read_text()))}
        self.assertEqual(float(rows["mesh"]["share_excursion_right_mm"]), dome["structural_shares"]["mesh"])
        self.succeeds("report", "f.h5", "-o", "f.html")
        self.assertIn("ratio_percent_structural_upper95", (self.folder / "f.html").read_text(encoding="utf-8"))
        without = self.succeeds("simulate", PARALYSED, "-o", "s.h5", "--from", "f.h5", "--set", "time.dt_ms=3", "--no-structural")
        self.assertEqual({key: value for key, value in run.items() if "structural" not in key and key != "wall_s"},
                         {key: value for key, value in without.items() if key != "wall_s"})

    def test_best_is_the_simulation_from_the_fit_and_within_its_interval(self):
        healthy, paralysed = self.no_lung()
        p = self.predicted(*QUICK, text=noisy(5), of=healthy, scenario=paralysed)
        run, own = (self.succeeds("simulate", scenario, "-o", name, "--from", "f.h5", "--set", "time.dt_ms=3",
                                  "--set", "time.duration_s=1.5", "--set", "time.start=periodic")
                    for scenario, name in ((paralysed, "r.h5"), (healthy, "o.h5")))
        volume, ratio = p["delta_v_ml"], p["ratio_percent"]
        self.assertAlmostEqual(volume["value"], run["delta_v_ml"], delta=0.2)  # the breath lasts not quite 1.5 s
        self.assertAlmostEqual(p["own_delta_v_ml"]["value"], own["delta_v_ml"], delta=0.2)
        self.assertAlmostEqual(ratio["value"], 100 * volume["value"] / p["own_delta_v_ml"]["value"], places=6)
        self.assertEqual((p["draws"], p["failed"], p["scenario"]), (64, 0, paralysed))
        for one in (volume, ratio, p["own_delta_v_ml"]):
            self.assertTrue(one["lower95"] < one["value"] < one["upper95"], one)
            self.assertTrue(one["lower95"] < one["median"] < one["upper95"], one)
        width = lambda one: (one["upper95"] - one["lower95"]) / one["value"]
        self.assertLess(width(ratio), 0.5 * width(volume))  # draw by draw: what both breaths share cancels

    def test_widens_with_the_noise_and_covers_the_truth(self):
        """The trace is the simulator's own, so that noise is all that is uncertain."""
        settings = [text for key, value in (("time.dt_ms", 3), ("time.duration_s", 2), ("time.start", "periodic"), ("activation.rise_s", 0.6),
                                            ("activation.fast_fall_s", 0.2), ("activation.slow_fall_s", 0.7))
                    for text in ("--set", f"{key}={value}")]
        healthy, paralysed = self.no_lung()  # with one, the scale of forces is uncertain as well
        self.succeeds("simulate", healthy, "-o", "own.h5", *settings)
        truth = self.succeeds("simulate", paralysed, "-o", "paralysed.h5", *settings)["delta_v_ml"]
        with h5py.File(self.folder / "own.h5") as run:
            volume = run["curves/dV_model"][:-1:3]  # every 9 ms
        widths = []
        for deviation in (8, 40):
            rng = random.Random(1)
            volumes = [v + rng.gauss(0, deviation) for v in list(volume) * 5]
            p = self.predicted(*settings, "--timing", "scenario", "--fix", "k_elasticity=4000",
                               of=healthy, scenario=paralysed, text=csv([0.009 * i for i in range(len(volumes))], volumes))["delta_v_ml"]
            widths.append(p["upper95"] - p["lower95"])
            self.assertLess(p["lower95"], truth)
            self.assertGreater(p["upper95"], truth)
        self.assertGreater(widths[1], 1.5 * widths[0], widths)

    @at_night
    def test_interval_is_that_of_k_muscle_where_nothing_else_is_uncertain(self):
        self.file("t.csv", noisy(10))
        fit = self.succeeds("fit", HEALTHY, "--trace", "t.csv", "-o", "f.h5", "--predict", PARALYSED, "--draws", "300",
                            "--no-structural", *ONE, codes=FITTED)
        muscle, p = fit["parameters"]["k_muscle"], fit["predictions"]["hemiparalysis_right"]
        with h5py.File(self.folder / "f.h5") as file:
            duration = file["best_run/curves/time"][-1]  # not quite 1.5 s
        self.assertEqual(fit["degrees_of_freedom"], 4)  # of 5 breaths: Student's t reaches 2.776 deviations
        # The interval of k_muscle holds the error of the gain as well, which a prediction does not.
        factor = math.exp(2.776 * muscle["stderr"] / muscle["value"])
        for end, value in (("lower95", muscle["value"] / factor), ("upper95", muscle["value"] * factor)):
            run = self.succeeds("simulate", PARALYSED, "-o", "r.h5", "--from", "f.h5", "--force", "--set", "time.dt_ms=3",
                                "--set", f"time.duration_s={duration}", "--set", "time.start=periodic", "--set",
                                f"parameters.k_muscle_N_per_m={value}")
            reach = p["delta_v_ml"]["upper95"] - p["delta_v_ml"]["lower95"]
            self.assertAlmostEqual(p["delta_v_ml"][end], run["delta_v_ml"], delta=0.05 * reach)

    def test_a_stored_fit_predicts_the_same_without_a_fit(self):
        fine = ("--set", "time.dt_ms=1")  # the stiffest draw needs it
        p = self.predicted(*QUICK, *fine, "--draws", "32", text=noisy(5))
        run = self.succeeds("simulate", PARALYSED, "-o", "r.h5", "--from", "f.h5", *fine, "--no-structural")
        names = [name for name, number in p.items() if isinstance(number, dict)]
        self.assertLessEqual({"delta_v_percent", "excursion_right_mm", "delta_l_mm", "delta_h_mm", "ratio_percent",
                              "end_expiratory_above_relaxation_ml"}, set(names))
        for name in names:
            for key, end in (("value", ""), ("lower95", "_lower95"), ("upper95", "_upper95")):
                self.assertAlmostEqual(run[name + end], p[name][key], delta=1e-9 * max(1, abs(p[name][key])), msg=name + end)
        self.assertEqual((run["draws"], run["failed_draws"]), (32, 0))
        with h5py.File(self.folder / "r.h5") as file:
            self.assertEqual(file["intervals/delta_l_mm_upper95"][()], run["delta_l_mm_upper95"])
        self.assertTrue(self.succeeds("replay", "r.h5", "--tolerance", "0")["same"])
        self.succeeds("export", "r.h5", "--csv", "out")
        ends = {r["name"]: float(r["value"]) for r in tables.DictReader(io.StringIO((self.folder / "out/intervals.csv").read_text()))}
        self.assertEqual(ends["delta_l_mm_upper95"], run["delta_l_mm_upper95"])

    def drawn(self, scenario):
        """The results of a fit, and what its draws say of each parameter."""
        fit = self.succeeds("fit", scenario, "--trace", ROOT / "reference/constructed_trace.csv", "-o", "f.h5", "--surface", "0",
                            "--draws", "1000", codes=FITTED)
        with h5py.File(self.folder / "f.h5") as file:
            names = [name.decode() for name in file["draws/parameter"]]
            values = {name: file["draws/value"][:, i] for i, name in enumerate(names)}
        values["k_muscle_over_k_elasticity"] = values["k_muscle"] / values["k_elasticity"]
        return fit["results"], values

    def assert_intervals_are_of_the_draws(self, results, values):
        for name, drawn in values.items():
            with self.subTest(name):
                low, high = sorted(drawn)[25], sorted(drawn)[974]
                told = math.log(results[name]["upper95"] / results[name]["lower95"])
                self.assertAlmostEqual(math.log(high / low), told, delta=0.1 * told)
                self.assertAlmostEqual(math.log(low / results[name]["lower95"]), 0, delta=0.1 * told)

    def test_draws_have_the_intervals_of_the_fit(self):
        results, values = self.drawn(NO_LUNG)
        recoil = results["recoil_time_s"]["value"] * results["k_elasticity"]["value"] / values["k_elasticity"]
        self.assert_intervals_are_of_the_draws(results, {"recoil_time_s": recoil} | {
            name: values[name] for name in ("k_muscle_over_k_elasticity", "k_elasticity", "k_muscle")})

    @at_night
    def test_draws_of_a_trunk_with_a_lung_have_the_intervals_of_the_fit(self):
        results, values = self.drawn(HEALTHY)
        self.assert_intervals_are_of_the_draws(results, {
            "lung_elastance_cmH2O_per_L": values["lung_elastance"], "resistance_cmH2O_s_per_L": values["resistance"],
            "k_elasticity": values["k_elasticity"], "k_muscle": values["k_muscle"]})

    def test_draws_keep_the_volume_where_priors_alone_know_the_scale_of_forces(self):
        fit = self.succeeds("fit", HEALTHY, "--trace", ROOT / "reference/constructed_trace.csv", "-o", "f.h5", codes=FITTED)
        with h5py.File(self.folder / "f.h5") as file:
            names = [name.decode() for name in file["draws/parameter"]]
            elasticity = sorted(file["draws/value"][:, names.index("k_elasticity")])
        self.assertGreater(elasticity[-2] / elasticity[1], 4)
        run = self.succeeds("simulate", HEALTHY, "-o", "r.h5", "--from", "f.h5", "--no-structural")
        told = fit["results"]["excursion_right_mm"]
        spread = (told["upper95"] - told["lower95"]) / told["value"]
        for end in ("lower95", "upper95"):
            self.assertAlmostEqual(run[f"delta_v_ml_{end}"] / run["delta_v_ml"], 1, delta=0.6 * spread)

    def test_what_is_set_has_no_spread(self):
        healthy, paralysed = self.no_lung()
        self.predicted(*ONE, "--draws", "16", of=healthy, scenario=paralysed)
        run = self.succeeds("simulate", paralysed, "-o", "r.h5", "--from", "f.h5", "--set", "time.dt_ms=3", "--no-structural",
                            "--set", "parameters.k_muscle_N_per_m=20")
        self.assertEqual(run["delta_v_ml_lower95"], run["delta_v_ml_upper95"])  # k_muscle was all that is uncertain
        self.assertAlmostEqual(run["delta_v_ml_lower95"], run["delta_v_ml"], places=6)

    def test_a_subject_of_a_sweep_breathes_as_in_its_fit(self):
        self.predicted(*ONE, "--draws", "0")
        self.file("s.toml", f'scenarios = ["{PARALYSED}", "{HEALTHY}"]\nsubjects = ["f.h5"]\nstore = "summary"\n[grid]\n"time.dt_ms" = [3]\n')
        self.succeeds("sweep", "s.toml", "-o", "d")
        rows = list(tables.DictReader(io.StringIO((self.folder / "d/table.csv").read_text())))
        for row, scenario in zip(rows, (PARALYSED, HEALTHY), strict=True):
            alone = self.succeeds("simulate", scenario, "-o", "r.h5", "--force", "--from", "f.h5", "--set", "time.dt_ms=3")
            self.assertEqual(float(row["delta_v_ml"]), alone["delta_v_ml"])
            self.assertNotEqual(float(row["end_expiratory_above_relaxation_ml"]), 0.0)

    @at_night
    def test_a_row_of_a_sweep_has_the_intervals_of_the_run_alone(self):
        self.predicted(*QUICK, "--set", "time.dt_ms=1", "--draws", "16", text=noisy(5))
        top = f'scenarios = ["{PARALYSED}"]\nsubjects = ["f.h5"]\n'
        grid = '[grid]\n"parameters.damping_N_s_per_m" = [12, 15]\n"time.dt_ms" = [1]\n'
        designs = {"all": 'store = "summary"\n', "off": 'store = "summary"\n', "whole": 'store = "full"\n'}
        for name, store in designs.items():
            self.file(f"{name}.toml", top + store + grid + ("[output]\nintervals = false\n" if name == "off" else ""))
        table = lambda folder: (self.folder / folder / "table.csv").read_text()
        rows = lambda folder: list(tables.DictReader(io.StringIO(table(folder))))
        outcome = self.trunk("sweep", "all.toml", "-o", "all")
        self.assertIn("up to 16 draws", outcome.err)
        for row, damping in zip(rows("all"), (12, 15), strict=True):
            alone = self.succeeds("simulate", PARALYSED, "-o", "r.h5", "--force", "--from", "f.h5", "--no-structural",
                                  "--set", "time.dt_ms=1", "--set", f"parameters.damping_N_s_per_m={damping}")
            self.assertGreater(alone["delta_v_ml_upper95"], alone["delta_v_ml_lower95"])
            for name in ("delta_v_ml", "excursion_right_mm", "delta_h_mm", "end_expiratory_above_relaxation_ml"):
                for end in ("", "_lower95", "_upper95"):
                    self.assertEqual(float(row[name + end]), alone[name + end], name + end)
            self.assertEqual(float(row["failed_draws"]), 0)
        with h5py.File(self.folder / "all/sweep.h5") as file:
            self.assertEqual(list(file["table/delta_h_mm_upper95"]), [float(r["delta_h_mm_upper95"]) for r in rows("all")])

        self.assertEqual(self.trunk("sweep", "off.toml", "-o", "off").err, "")
        without = rows("off")
        self.assertEqual(without, [{key: row[key] for key in without[0]} for row in rows("all")])
        self.assertFalse([key for key in without[0] if key.endswith("95") or key == "failed_draws"])

        for part in ("2/2", "1/2"):
            self.succeeds("sweep", "all.toml", "-o", "shards", "--shard", part)
        self.succeeds("merge", "shards")
        self.assertEqual(table("shards"), table("all"))

        self.succeeds("sweep", "whole.toml", "-o", "whole")
        by_rows = table("whole")
        for row, other in zip(rows("whole"), rows("all"), strict=True):
            self.assertEqual(row, other)
        journal = self.folder / "whole/journal/1-of-1"
        journal.write_bytes(journal.read_bytes()[:-100])  # a crash between a run's file and its row
        again = self.succeeds("sweep", "whole.toml", "-o", "whole")
        self.assertEqual((again["found"], again["simulated"]), (2, 0))
        self.assertEqual(table("whole"), by_rows)

        self.succeeds("simulate", HEALTHY, "-o", "run.h5", *COARSE)
        self.file("run.toml", f'scenarios = ["{PARALYSED}"]\nsubjects = ["run.h5", "f.h5"]\nstore = "summary"\n' + grid.replace("12, 15", "15"))
        self.succeeds("sweep", "run.toml", "-o", "mixed")
        mixed = rows("mixed")
        self.assertEqual({row["delta_v_ml_lower95"] for row in mixed if row["subject"] == "run.h5"}, {""})
        self.assertEqual([row["delta_v_ml_lower95"] for row in mixed if row["subject"] == "f.h5"],
                         [rows("all")[1]["delta_v_ml_lower95"]])

    def test_is_kept_with_the_fit(self):
        self.predicted(*ONE, "--draws", "16")
        kept = {d["path"]: d["shape"] for d in self.succeeds("inspect", "f.h5")["datasets"]}
        self.assertEqual(kept["predictions/hemiparalysis_right/delta_v_draws"], [16])
        self.assertIn("predictions/hemiparalysis_right/ratio_percent_lower95", kept)
        self.assertEqual(kept["draws/value"][0], 16)

    def test_without_draws_there_is_no_interval(self):
        p = self.predicted(*ONE, "--draws", "0")
        self.assertEqual((p["draws"], p["delta_v_ml"]["lower95"], p["ratio_percent"]["upper95"]), (0, None, None))
        self.assertGreater(p["delta_v_ml"]["value"], 100)
        self.file("t.csv", trace())
        fit = self.succeeds("fit", HEALTHY, "--tidal-volume-ml", "300", "-o", "g.h5", "--predict", PARALYSED,
                            *FAST_FIT, codes=FITTED)  # one number has no uncertainty to carry
        self.assertIsNone(fit["predictions"]["hemiparalysis_right"]["delta_v_ml"]["lower95"])

    def test_another_trunk_is_pointed_out(self):
        self.file("wide.toml", f'extends = "{PARALYSED}"\n[geometry]\nhalf_width_mm = 170\n')
        self.file("t.csv", trace())
        outcome = self.trunk("fit", HEALTHY, "--trace", "t.csv", "-o", "f.h5", "--predict", "wide.toml",
                             "--predict", PARALYSED, "--draws", "0", *ONE)
        self.assertEqual(outcome.err.count("another shape"), 1)
        self.assertRegex(outcome.err, "note: wide.toml: .*another shape")

    def test_what_cannot_be_predicted_is_refused_before_the_fit(self):
        self.file("t.csv", trace())
        self.file("bad.toml", 'extends = "none.toml"\n')
        for options, says in ((("--predict", "bad.toml"), "none.toml"), (("--predict", "absent.toml"), "absent.toml"),
                              (("--predict", PARALYSED, "--predict", PARALYSED), "names that differ")):
            with self.subTest(options):
                self.refused("fit", HEALTHY, "--trace", "t.csv", "-o", "f.h5", *ONE, *options, says=says)


if __name__ == "__main__":
    unittest.main()
