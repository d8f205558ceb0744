"""Many fits: a muscle a breath, a cohort from a list, and what a fit predicts of another scenario."""

import csv as tables
import io
import math
import random
import unittest

import h5py

from support import COARSE, FAST_FIT, HEALTHY, ROOT, SCENARIOS, TrunkTest, breaths, csv, trace

PARALYSED = str(SCENARIOS / "hemiparalysis_right.toml")
FITTED = (0, 4)
QUICK = (*FAST_FIT, "--timing", "trace", "--surface", "0")  # 5 breaths of 1.5 s, 500 steps each
ONE = (*QUICK, "--fix", "k_elasticity=4000")


def noisy(deviation_ml, seed=1):
    rng = random.Random(seed)
    times, volumes = breaths()
    return csv(times, [v + rng.gauss(0, deviation_ml) for v in volumes])


class Prediction(TrunkTest):
    def predicted(self, *options, text=None, output="f.h5", scenario=PARALYSED, structural=False):
        self.file("t.csv", text or trace())
        fit = self.succeeds("fit", HEALTHY, "--trace", "t.csv", "-o", output, "--scenario", scenario, "--force",
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
        self.assertEqual((ranges["abdominal_wall"], ranges["mesh"]), ((0.5, 0.8, 1.28), (1, 1, 2)))
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
        p = self.predicted(*QUICK, text=noisy(5))
        run, own = (self.succeeds("simulate", scenario, "-o", name, "--from", "f.h5", "--set", "time.dt_ms=3",
                                  "--set", "time.duration_s=1.5", "--set", "time.start=periodic")
                    for scenario, name in ((PARALYSED, "r.h5"), (HEALTHY, "o.h5")))
        volume, ratio = p["delta_v_ml"], p["ratio_percent"]
        self.assertAlmostEqual(volume["value"], run["delta_v_ml"], delta=0.2)  # the breath lasts not quite 1.5 s
        self.assertAlmostEqual(p["own_delta_v_ml"]["value"], own["delta_v_ml"], delta=0.2)
        self.assertAlmostEqual(ratio["value"], 100 * volume["value"] / p["own_delta_v_ml"]["value"], places=6)
        self.assertEqual((p["draws"], p["failed"], p["scenario"]), (64, 0, PARALYSED))
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
        self.succeeds("simulate", HEALTHY, "-o", "own.h5", *settings)
        truth = self.succeeds("simulate", PARALYSED, "-o", "paralysed.h5", *settings)["delta_v_ml"]
        with h5py.File(self.folder / "own.h5") as run:
            volume = run["curves/dV_model"][:-1:3]  # every 9 ms
        widths = []
        for deviation in (8, 40):
            rng = random.Random(1)
            volumes = [v + rng.gauss(0, deviation) for v in list(volume) * 5]
            p = self.predicted(*settings, "--timing", "scenario", "--fix", "k_elasticity=4000",
                               text=csv([0.009 * i for i in range(len(volumes))], volumes))["delta_v_ml"]
            widths.append(p["upper95"] - p["lower95"])
            self.assertLess(p["lower95"], truth)
            self.assertGreater(p["upper95"], truth)
        self.assertGreater(widths[1], 1.5 * widths[0], widths)

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
        p = self.predicted(*QUICK, "--draws", "32", text=noisy(5))
        run = self.succeeds("simulate", PARALYSED, "-o", "r.h5", "--from", "f.h5", "--set", "time.dt_ms=3", "--no-structural")
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

    def test_draws_have_the_intervals_of_the_fit(self):
        fit = self.succeeds("fit", HEALTHY, "--trace", ROOT / "reference/constructed_trace.csv", "-o", "f.h5", "--surface", "0",
                            "--draws", "300", codes=FITTED)
        with h5py.File(self.folder / "f.h5") as file:
            names = [name.decode() for name in file["draws/parameter"]]
            elasticity, muscle = (file["draws/value"][:, names.index(name)] for name in ("k_elasticity", "k_muscle"))
        results = fit["results"]
        recoil = results["recoil_time_s"]["value"] * results["k_elasticity"]["value"] / elasticity
        for name, drawn in (("recoil_time_s", recoil), ("k_muscle_over_k_elasticity", muscle / elasticity),
                            ("k_elasticity", elasticity), ("k_muscle", muscle)):
            with self.subTest(name):
                low, high = sorted(drawn)[25], sorted(drawn)[974]
                told = math.log(results[name]["upper95"] / results[name]["lower95"])
                self.assertAlmostEqual(math.log(high / low), told, delta=0.1 * told)
                self.assertAlmostEqual(math.log(low / results[name]["lower95"]), 0, delta=0.1 * told)

    def test_what_is_set_has_no_spread(self):
        self.predicted(*ONE, "--draws", "16")
        run = self.succeeds("simulate", PARALYSED, "-o", "r.h5", "--from", "f.h5", "--set", "time.dt_ms=3", "--no-structural",
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

    def test_a_row_of_a_sweep_has_the_intervals_of_the_run_alone(self):
        self.predicted(*QUICK, "--draws", "16", text=noisy(5))
        top = f'scenarios = ["{PARALYSED}"]\nsubjects = ["f.h5"]\n'
        grid = '[grid]\n"parameters.damping_N_s_per_m" = [20, 25]\n"time.dt_ms" = [3]\n'
        designs = {"all": 'store = "summary"\n', "off": 'store = "summary"\n', "whole": 'store = "full"\n'}
        for name, store in designs.items():
            self.file(f"{name}.toml", top + store + grid + ("[output]\nintervals = false\n" if name == "off" else ""))
        table = lambda folder: (self.folder / folder / "table.csv").read_text()
        rows = lambda folder: list(tables.DictReader(io.StringIO(table(folder))))
        outcome = self.trunk("sweep", "all.toml", "-o", "all")
        self.assertIn("up to 16 draws", outcome.err)
        for row, damping in zip(rows("all"), (20, 25), strict=True):
            alone = self.succeeds("simulate", PARALYSED, "-o", "r.h5", "--force", "--from", "f.h5", "--no-structural",
                                  "--set", "time.dt_ms=3", "--set", f"parameters.damping_N_s_per_m={damping}")
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
        self.file("run.toml", f'scenarios = ["{PARALYSED}"]\nsubjects = ["run.h5", "f.h5"]\nstore = "summary"\n' + grid.replace("20, 25", "25"))
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


class EachBreath(TrunkTest):
    HEIGHTS = (1.0, 1.3, 0.8, 1.0, 1.3, 0.8)

    def setUp(self):
        super().setUp()
        times, volumes = breaths(count=6)
        self.file("t.csv", csv(times, [v * self.HEIGHTS[min(int(t / 1.5), 5)] for t, v in zip(times, volumes)]))

    def fit(self, *options):
        return self.succeeds("fit", HEALTHY, "--trace", "t.csv", "-o", "f.h5", "--force", "--breath", "each", *options,
                             codes=FITTED)

    def test_muscle_follows_the_height_of_each_breath(self):
        for timing in ("trace", "joint"):
            with self.subTest(timing):
                fit = self.fit(*FAST_FIT, "--surface", "0", "--fix", "k_elasticity=4000", "--timing", timing)
                rows = fit["breaths"]
                self.assertEqual([r["number"] for r in rows], [1, 2, 3, 4, 5, 6])
                mean = sum(self.HEIGHTS) / 6
                for row, height in zip(rows, self.HEIGHTS):
                    self.assertEqual(row["status"], "converged")
                    self.assertAlmostEqual(row["onset_s"], 1.5 * (row["number"] - 1), delta=0.05)
                    self.assertAlmostEqual(row["tidal_volume_ml"], 500 * height, delta=8)
                    muscle, wanted = row["k_muscle"], height / mean * fit["parameters"]["k_muscle"]["value"]
                    self.assertAlmostEqual(muscle["value"] / wanted, 1, delta=0.04)
                    self.assertTrue(0 < muscle["lower95"] < muscle["value"] < muscle["upper95"])
                    self.assertLess(row["nrmse_percent"], 5)
                    self.assertTrue(1 <= row["evaluations"] and 0 < row["latency_ms"] < 60000)
                self.assertLess(rows[2]["k_muscle"]["value"], rows[0]["k_muscle"]["value"])

    def test_what_the_mean_found_is_held(self):
        """Alike breaths have the muscle of the mean, with everything else free in the mean fit at its value there."""
        self.file("t.csv", trace())
        fit = self.fit(*QUICK, "--free", "k_elasticity,k_muscle")
        self.assertNotAlmostEqual(fit["parameters"]["k_elasticity"]["value"], 4000, delta=100)  # not the scenario's
        for row in fit["breaths"]:
            self.assertAlmostEqual(row["k_muscle"]["value"] / fit["parameters"]["k_muscle"]["value"], 1, delta=0.03)

    def test_is_kept_with_the_fit(self):
        fit = self.fit(*ONE)
        kept = {d["path"]: d["shape"] for d in self.succeeds("inspect", "f.h5")["datasets"]}
        for name in ("k_muscle", "k_muscle_lower95", "onset_s", "latency_ms", "status"):
            self.assertEqual(kept["breaths/" + name], [len(fit["breaths"])])

    def test_needs_breaths_and_a_muscle_to_fit(self):
        for options, says in ((("--trace", "t.csv", "--fix", "k_muscle=20"), "k_muscle is what it fits"),
                              (("--tidal-volume-ml", "300"), "--breath each: .*; expected a trace")):
            self.refused("fit", HEALTHY, *options, "-o", "g.h5", *FAST_FIT, "--breath", "each", says=says)


class Cohort(TrunkTest):
    def setUp(self):
        super().setUp()
        (self.folder / "in").mkdir()
        self.file("in/a.csv", trace(tidal_ml=400))
        self.file("in/b.csv", trace(tidal_ml=600))
        self.file("in/broken.csv", "time_s,volume_ml\n0,1\n1,two\n")

    def list(self, text, name="in/list.csv"):
        return self.file(name, text)

    def cohort(self, *options, codes=FITTED, options_for_all=ONE):
        return self.succeeds("fit", HEALTHY, "--cohort", "in/list.csv", "-o", "d", *options_for_all, *options, codes=codes)

    def rows(self):
        return {r["subject"]: r for r in tables.DictReader(io.StringIO((self.folder / "d/cohort.csv").read_text()))}

    def fits(self):
        return {p.name: (p.stat().st_ino, p.stat().st_mtime_ns) for p in (self.folder / "d").glob("*.h5")}

    def test_one_broken_trace_stops_no_other(self):
        self.list("subject,trace\nA,a.csv\nX,broken.csv\nB,b.csv\nY,absent.csv\n")
        result = self.cohort("--predict", PARALYSED, codes=(3,))
        self.assertEqual((result["schema"], result["failed"], result["found"]), ("trunk.cohort/2", 2, 0))
        by_name = {s["subject"]: s for s in result["subjects"]}
        self.assertEqual(list(by_name), ["A", "X", "B", "Y"])
        self.assertRegex(by_name["X"]["error"], r"\Ain/broken.csv: 2 samples found; [^\n]*")
        self.assertRegex(by_name["Y"]["error"], r"absent.csv")
        rows = self.rows()
        self.assertEqual(set(self.fits()), {"A.h5", "B.h5"})
        for name, file in (("A", "in/a.csv"), ("B", "in/b.csv")):
            alone = self.succeeds("fit", HEALTHY, "--trace", file, "-o", name + ".h5", *ONE, "--predict", PARALYSED,
                                  codes=FITTED)
            for key in ("status", "grade", "gates", "headline", "results", "parameters", "verdict", "predictions"):
                self.assertEqual(by_name[name][key], alone[key])
            row, p = rows[name], alone["predictions"]["hemiparalysis_right"]
            self.assertEqual([row[key] for key in ("status", "grade", "gates", "error")], [alone["status"], alone["grade"], "", ""])
            self.assertGreaterEqual(len(alone["headline"]), 5)
            for result in alone["headline"]:
                for end in ("", "_lower95", "_upper95"):
                    self.assertEqual(float(row[result + end]), alone["results"][result][end.strip("_") or "value"], result)
                self.assertEqual(row[result + "_grade"], alone["results"][result]["grade"])
            self.assertEqual(float(row["nrmse_percent"]), alone["nrmse_percent"])
            self.assertEqual(float(row["hemiparalysis_right_delta_v_ml_upper95"]), p["delta_v_ml"]["upper95"])
            self.assertEqual(float(row["hemiparalysis_right_percent"]), p["ratio_percent"]["value"])
            self.assertEqual(float(row["hemiparalysis_right_percent_structural_lower95"]), p["ratio_percent"]["structural_lower95"])
        self.assertEqual([rows["X"][key] for key in ("status", "grade", "k_muscle")], ["failed", "", ""])

    def test_a_gate_withholds_in_the_table_too(self):
        self.file("in/b.csv", trace(tidal_ml=40))  # 0.8 % of this trunk's end-expiratory volume
        self.list("subject,trace\nA,a.csv\nB,b.csv\n")
        result = self.cohort(codes=(4,), options_for_all=QUICK)
        row = self.rows()["B"]
        self.assertEqual((row["grade"], row["gates"], row["k_muscle"], row["recoil_time_s_upper95"]),
                         ("not_determined", "subject_size", "", ""))
        self.assertEqual(row["k_muscle_grade"], "not_determined")
        self.assertIsNone(result["subjects"][1]["results"]["k_muscle"]["value"])
        shown = self.trunk("fit", HEALTHY, "--cohort", "in/list.csv", "-o", "d", *QUICK).out
        self.assertRegex(shown, r"(?m)^  B +not_identifiable +not_determined +withheld +withheld")

    def test_what_is_done_is_not_done_again(self):
        self.list("subject,trace\nA,a.csv\nB,b.csv\n")
        first = self.cohort("-j", "1")
        table, before = (self.folder / "d/cohort.csv").read_bytes(), self.fits()
        again = self.cohort("-j", "2")
        self.assertEqual((first["found"], again["found"]), (0, 2))
        self.assertEqual(self.fits(), before)
        self.assertEqual((self.folder / "d/cohort.csv").read_bytes(), table)
        (self.folder / "d/B.h5").unlink()
        self.assertEqual(self.cohort()["found"], 1)
        self.assertEqual((self.folder / "d/cohort.csv").read_bytes(), table)
        self.assertEqual(self.fits()["A.h5"], before["A.h5"])

    def test_a_fit_of_something_else_is_not_replaced_unasked(self):
        self.list("subject,trace\nA,a.csv\nB,b.csv\n")
        self.cohort()
        before = self.fits()
        self.file("in/b.csv", trace(tidal_ml=500))  # another trace under the same name
        changed = self.cohort(codes=(3,))
        self.assertEqual([s["status"] == "failed" for s in changed["subjects"]], [False, True])
        self.assertRegex(changed["subjects"][1]["error"], "d/B.h5: is another fit: .*; delete it, or give --force")
        self.list("subject,trace,fix\nA,a.csv,k_elasticity=3000\nB,b.csv,\n")  # another option in the row
        self.assertEqual(self.cohort(codes=(2,))["failed"], 2)
        self.list("subject,trace\nA,a.csv\nB,b.csv\n")  # other options for all
        self.assertEqual(self.cohort("--seed", "2", codes=(2,))["failed"], 2)
        self.assertEqual(self.fits(), before)
        self.assertEqual(self.cohort("--force")["found"], 0)
        self.assertAlmostEqual(float(self.rows()["B"]["tidal_volume_measured_ml"]), 500, delta=10)

    def test_a_row_is_a_command_line(self):
        times, volumes = breaths()
        self.file("in/b.csv", csv(times, [1.3 * v if 3.0 <= t < 4.5 else v for t, v in zip(times, volumes)], "Zeit [s],V [ml]"))
        self.file("in/soft.toml", f'extends = "{HEALTHY}"\n[parameters]\nk_elasticity_N_per_m = 3000\n')
        self.list("subject;trace;scenario;breath;fix;time;signal\n"
                  "A;a.csv;;;k_elasticity=2500 damping=10;;\nB;b.csv;soft.toml;3;;Zeit [s];V [ml]\n")
        self.cohort("--free", "k_muscle", options_for_all=QUICK)
        rows = self.rows()
        self.assertAlmostEqual(float(rows["B"]["tidal_volume_measured_ml"]), 650, delta=7)
        self.assertEqual((rows["A"]["breaths_used"], rows["B"]["breaths_used"]), ("5", "1"))
        kept = {name: self.succeeds("inspect", f"d/{name}.h5")["parameters"] for name in "AB"}
        self.assertEqual((kept["A"]["k_elasticity"]["value"], kept["A"]["damping"]["value"]), (2500, 10))
        self.assertEqual((kept["B"]["k_elasticity"]["value"], kept["B"]["damping"]["value"]), (3000, 20))

    def test_two_stages_for_all(self):
        self.list("subject,trace\nA,a.csv\n")
        self.assertEqual(len(self.cohort("--breath", "each")["subjects"]), 1)
        kept = {d["path"] for d in self.succeeds("inspect", "d/A.h5")["datasets"]}
        self.assertIn("breaths/k_muscle", kept)

    def test_a_list_that_makes_no_sense(self):
        for text, says in (("subject,trace,colour\nA,a.csv,red\n", "list.csv:1: column 'colour'.*expected.*subject.*breath"),
                           ("trace\na.csv\n", "list.csv:1: there is no column 'subject'; expected a header"),
                           ("subject,trace\n", "list.csv: the list names no subject; expected"),
                           ("subject,trace\nA,a.csv\nA,b.csv\n", "list.csv:3: subject 'A' .*line 2 as well; expected each"),
                           ("subject,trace\n../A,a.csv\n", "list.csv:2: subject '../A'"),
                           ("subject,trace\na/b,a.csv\n", "list.csv:2: subject 'a/b'"),
                           ("subject,trace\n.h,a.csv\n", "list.csv:2: subject '.h'"),
                           ("subject,trace\n,a.csv\n", "list.csv:2: this row names no subject; expected 1 to 100"),
                           ("subject,trace,timing\nA,a.csv,never\n", "list.csv:2: .*timing.*never"),
                           ("subject,trace,output\nA,a.csv,b.h5\n", "column 'output'"),
                           ("subject,trace,trace\nA,a.csv,b.csv\n", "'trace' stands twice")):
            with self.subTest(text):
                self.list(text)
                self.refused("fit", HEALTHY, "--cohort", "in/list.csv", "-o", "d", *ONE, says=says)

    def test_a_folder_of_something_else_is_left_alone(self):
        self.list("subject,trace\nA,a.csv\n")
        self.refused("fit", HEALTHY, "--cohort", "in/list.csv", "-o", "in", *ONE, says="in: is not empty and holds no cohort")
        self.refused("fit", HEALTHY, "--cohort", "in/list.csv", "-o", "in/a.csv", *ONE, says="is a file")
        self.refused("fit", HEALTHY, "--cohort", "in/list.csv", "-o", "d", "--save-scenario", "s.toml", *ONE,
                     says="--save-scenario")


if __name__ == "__main__":
    unittest.main()
