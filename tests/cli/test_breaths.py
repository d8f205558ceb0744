"""trunk breaths and trunk check: what the program sees in a trace, before anything is fitted."""

import unittest
from csv import DictReader
from pathlib import Path

from support import HEALTHY, TrunkTest, breaths, csv, shared_file, trace


class Synthetic(TrunkTest):
    def found(self, text, *options):
        return self.succeeds("breaths", self.file("t.csv", text), *options)

    def test_what_was_put_in_comes_out(self):
        found = self.found(trace(count=5, period_s=4, inspiration_s=1.6, tidal_ml=500, tau_s=0.4))
        self.assertEqual((found["schema"], found["breaths_found"], found["breaths_kept"]), ("trunk.breaths/1", 5, 5))
        self.assertAlmostEqual(found["tidal_volume_ml"], 500, delta=5)
        self.assertAlmostEqual(found["duration_s"], 4, delta=0.04)
        self.assertAlmostEqual(found["inspiration_s"], 1.6, delta=0.1)
        for number, breath in enumerate(found["breaths"], 1):
            self.assertEqual((breath["number"], breath["kept"], breath["reason"]), (number, True, ""))
            self.assertAlmostEqual(breath["onset_s"], 4 * (number - 1), delta=0.1)
            self.assertTrue(breath["onset_s"] < breath["peak_s"] < breath["end_s"])
            self.assertAlmostEqual(breath["tidal_volume_ml"], 500, delta=5)

    def test_spellings_of_one_trace_are_one_trace(self):
        times, volumes = breaths()
        plain = self.found(csv(times, volumes))
        for name, text in {
            "BOM, semicolons, decimal commas": "\ufeff" + csv(times, volumes, "time_s;volume_ml", ";", comma=True),
            "lines end in CR LF": csv(times, volumes).replace("\n", "\r\n"),
            "tabs": csv(times, volumes, "time_s\tvolume_ml", "\t"),
            "comments": "# subject 7\n" + csv(times, volumes).replace("\n1.0000", "\n# a cough\n1.0000"),
            "other columns": csv(times, volumes, "time_s,volume_ml,remark").replace("\n1.0000", "\n\n1.0000"),
            "UTF-16": csv(times, volumes).encode("utf-16"),
            "no line end at the end": csv(times, volumes).rstrip("\n"),
        }.items():
            with self.subTest(name):
                self.assertEqual(self.found(text), plain)

    def test_units_in_the_header(self):
        times, volumes = breaths()
        plain = self.found(csv(times, volumes))
        for header, volume, time in (("time_s,volume_L", 1e-3, 1), ("time_ms,volume_ml", 1, 1000)):
            with self.subTest(header):
                found = self.found(csv(times, [volume * v for v in volumes], header, time_factor=time).replace(
                    ",0.0000\n", ",0.00000\n"))
                self.assertEqual(found["breaths_kept"], plain["breaths_kept"])
                self.assertAlmostEqual(found["tidal_volume_ml"], plain["tidal_volume_ml"], delta=2)
                self.assertAlmostEqual(found["duration_s"], plain["duration_s"], delta=0.02)

    def test_a_flow_is_integrated(self):
        times, volumes = breaths()
        flow = [0] + [(b - a) * 0.1 for a, b in zip(volumes, volumes[1:])]  # L/s at 100 Hz
        found = self.found(csv(times, flow, "time_s,flow_L_s"))
        self.assertEqual(found["breaths_kept"], 5)
        self.assertAlmostEqual(found["tidal_volume_ml"], 500, delta=10)

    def test_columns_by_name(self):
        times, volumes = breaths()
        text = csv(times, volumes, "clock_s,spiro_ml")
        self.refused("breaths", self.file("t.csv", text), says=(r"t.csv:1: .*'clock_s', 'spiro_ml'", "expected time_s"))
        self.assertEqual(self.found(text, "--time", "clock_s", "--signal", "spiro_ml"), self.found(csv(times, volumes)))
        self.refused("breaths", "t.csv", "--signal", "strap", says=("t.csv:1:", "strap"))

    def test_a_drift_is_removed_and_told(self):
        times, volumes = breaths()
        self.file("t.csv", csv(times, [v + 30 * t for t, v in zip(times, volumes)]))
        outcome = self.trunk("breaths", "t.csv", "--json")
        self.assertEqual(outcome.code, 0, str(outcome))
        # Breaths that are all alike do not show whether a drift or the flowmeter makes the difference.
        self.assertRegex(outcome.err, r"\Anote: a drift of 45 ml a breath was removed\n"
                                      r"note: in- and expired volumes differ by 9.* one direction too high\n\Z")
        self.assertAlmostEqual(outcome.json()["tidal_volume_ml"], 500, delta=5)

    def test_a_sigh_is_rejected_with_its_reason(self):
        times, volumes = breaths(count=7)
        sigh = [3 * v if 4.5 <= t < 6.0 else v for t, v in zip(times, volumes)]
        found = self.found(csv(times, sigh))
        self.assertEqual((found["breaths_found"], found["breaths_kept"]), (7, 6))
        self.assertFalse(found["breaths"][3]["kept"])
        self.assertRegex(found["breaths"][3]["reason"], "tidal volume")
        self.assertAlmostEqual(found["tidal_volume_ml"], 500, delta=5)
        self.assertRegex(self.trunk("breaths", "t.csv").out, r"(?m)^ +4 .* no: .*tidal volume")

    def test_check_says_good_or_why_not(self):
        self.file("t.csv", trace())
        checked = self.succeeds("check", HEALTHY, "--trace", "t.csv")
        self.assertEqual((checked["particles"], checked["breaths_used"]), (113, 5))
        self.assertGreater(checked["stable_dt_s"], 0.001)
        self.file("t.csv", "time_s,volume_ml\n")
        self.refused("check", HEALTHY, "--trace", "t.csv", says="t.csv:1:")
        self.refused("check", HEALTHY, "--set", "time.dt_ms=20", says=("20 ms", "unstable", "expected less than"))

    def test_check_reads_named_columns_as_fit_does(self):
        """Else a trace that can be fitted cannot be checked."""
        self.file("t.csv", csv(*breaths(), "clock_s,spiro_ml"))
        self.succeeds("check", HEALTHY, "--trace", "t.csv", "--time", "clock_s", "--signal", "spiro_ml")


class Table(TrunkTest):
    def test_every_breath_in_numbers(self):
        times, volumes = breaths(count=6, period_s=4, inspiration_s=1.6, tau_s=0.3)
        self.file("t.csv", csv(times, volumes))
        found = self.succeeds("breaths", "t.csv")
        for one in found["breaths"]:
            self.assertAlmostEqual(one["inspiration_s"] + one["expiration_s"], one["duration_s"], places=9)
            self.assertAlmostEqual(one["duration_s"], one["end_s"] - one["onset_s"], places=9)
            self.assertAlmostEqual(one["minute_ventilation_L_min"],
                                   one["tidal_volume_ml"] * 0.06 / one["duration_s"], places=6)
            self.assertTrue(0.3 < one["pause_s"] < one["expiration_s"], one)
            self.assertAlmostEqual(one["inspired_ml"], 500, delta=5)
            self.assertAlmostEqual(one["expired_ml"], 500, delta=5)
        self.assertEqual(set(found["median"]) - set(found["breaths"][0]), set())
        self.assertAlmostEqual(found["median"]["tidal_volume_ml"], 500, delta=5)
        self.assertAlmostEqual(found["total_s"], 24, delta=0.2)
        self.assertAlmostEqual(found["breaths_per_min"], 15, delta=0.1)
        self.assertAlmostEqual(found["minute_ventilation_L_min"], 7.5, delta=0.1)
        text = self.trunk("breaths", "t.csv").out.splitlines()
        self.assertEqual(len(text), 9)
        self.assertRegex(text[7], "median of those kept")
        self.assertRegex(text[8], r"6 breaths found, 6 kept: 2[34]\S* s, 15\S* breaths/min, 7\.[45]\S* L/min")

    def test_chosen_by_number(self):
        self.file("t.csv", trace(count=7))
        found = self.succeeds("breaths", "t.csv", "--exclude", "2,4-5", "--exclude", "7")
        self.assertEqual([one["number"] for one in found["breaths"] if not one["kept"]], [2, 4, 5, 7])
        self.assertEqual({one["reason"] for one in found["breaths"]}, {"", "excluded by --exclude"})
        self.assertEqual(found["breaths_kept"], 3)
        self.assertIn("no: excluded by --exclude", self.trunk("breaths", "t.csv", "--exclude", "2").out)
        self.refused("breaths", "t.csv", "--exclude", "8", says=("t.csv: --exclude names breath 8", "expected 1 to 7"))
        self.refused("breaths", "t.csv", "--exclude", "two", says=("--exclude two: this is not a list of breath numbers; expected", "as in 3,7 or 3-5"))
        self.refused("breaths", "t.csv", "--exclude", "3", "--include", "2-3", says="breath 3 is named by both")
        nothing = self.succeeds("breaths", "t.csv", "--exclude", "1-7")
        self.assertEqual((nothing["breaths_found"], nothing["breaths_kept"]), (7, 0))
        self.assertNotIn("median", nothing)

    def test_an_odd_breath_can_be_kept(self):
        times, volumes = breaths(count=7)
        self.file("t.csv", csv(times, [3 * v if 4.5 <= t < 6.0 else v for t, v in zip(times, volumes)]))
        sigh = self.succeeds("breaths", "t.csv", "--include", "4")["breaths"][3]
        self.assertTrue(sigh["kept"])
        self.assertRegex(sigh["reason"], r"^included by --include, though tidal volume (1500|149\d) ml")

    def test_as_comma_separated_values(self):
        self.file("t.csv", trace())
        found = self.succeeds("breaths", "t.csv", "--exclude", "2", "--csv", "table.csv")
        with open(self.folder / "table.csv", encoding="utf-8", newline="") as file:
            rows = list(DictReader(file))
        self.assertEqual(len(rows), 5)
        for row, one in zip(rows, found["breaths"]):
            self.assertEqual(set(row), set(one))
            self.assertAlmostEqual(float(row["tidal_volume_ml"]), one["tidal_volume_ml"], delta=0.01)
            self.assertEqual((row["kept"], row["reason"]), (str(int(one["kept"])), one["reason"]))
        self.refused("breaths", "t.csv", "--csv", "table.csv", says="table.csv: .*--force")
        self.refused("breaths", "t.csv", "--csv", "t.csv", "--force", says="t.csv: is read by this command")
        self.succeeds("breaths", "t.csv", "--csv", "table.csv", "--force")

    def test_the_curve_without_drift(self):
        times, volumes = breaths(rate_hz=200)
        self.file("t.csv", csv(times, [v + 30 * t for t, v in zip(times, volumes)]))
        self.assertNotIn("curve", self.succeeds("breaths", "t.csv"))
        curve = self.succeeds("breaths", "t.csv", "--curve")["curve"]
        self.assertEqual(len(curve["time_s"]), len(curve["volume_ml"]))
        steps = [b - a for a, b in zip(curve["time_s"], curve["time_s"][1:])]
        self.assertAlmostEqual(min(steps), 0.02, places=6)
        self.assertAlmostEqual(max(curve["volume_ml"]), 500, delta=10)
        self.assertAlmostEqual(min(curve["volume_ml"]), 0, delta=10)

    def test_a_wrong_calibration_is_corrected(self):
        self.file("t.csv", trace(tidal_ml=4.0))
        self.refused("breaths", "t.csv", says=r"tidal volume of (4|3\.\d+) ml")
        found = self.succeeds("breaths", "t.csv", "--calibrate-tidal-volume", "480")
        self.assertAlmostEqual(found["tidal_volume_ml"], 480, delta=5)
        self.assertRegex(found["notes"][0], r"scaled so that the median tidal volume is 480 ml, which was (4|3\.\d+) ml")
        for bad in ("0", "-500", "nan", "much"):
            self.refused("breaths", "t.csv", "--calibrate-tidal-volume", bad, says="--calibrate-tidal-volume")


class Gates(TrunkTest):
    def gates(self, *options):
        outcome = self.trunk("breaths", *options, "--json")
        self.assertEqual(outcome.code, 0, str(outcome))
        return outcome.json()["gates"], outcome.err

    def test_spontaneous_breathing_fires_none(self):
        self.file("t.csv", trace(count=6, period_s=4, inspiration_s=1.6, tau_s=0.4))
        self.assertEqual(self.gates("t.csv"), ([], ""))

    def test_upside_down(self):
        times, volumes = breaths(count=6, period_s=4, inspiration_s=1.6, tau_s=0.4)
        self.file("t.csv", csv(times, [-v for v in volumes]))
        gates, said = self.gates("t.csv")
        self.assertIn("upside_down", gates)
        self.assertRegex(said, "note: the recording looks upside down.* use --invert\n")
        self.assertEqual(self.gates("t.csv", "--invert")[0], [])

    def test_driven_by_a_machine(self):
        """The flow is constant for 1 s, then the chest empties by itself."""
        times = [0.01 * i for i in range(4001)]
        phases = [t % 4 for t in times]
        self.file("t.csv", csv(times, [500 * (p if p < 1 else 2.718281828 ** ((1 - p) / 0.5)) for p in phases]))
        gates, said = self.gates("t.csv")
        self.assertEqual(gates, ["machine_driven"])
        self.assertIn("note: not driven by a muscle?", said)

    def test_check_knows_the_size_of_the_trunk(self):
        self.file("t.csv", trace(tidal_ml=60))
        self.assertEqual(self.gates("t.csv")[0], [])
        checked = self.trunk("check", HEALTHY, "--trace", "t.csv", "--json")
        self.assertEqual(checked.json()["gates"], ["subject_size"])
        self.assertRegex(checked.err, "this trunk is an adult's of 4760 ml")

    def test_too_few_samples_and_breaths_are_said(self):
        self.file("t.csv", trace(count=30, period_s=1.0, inspiration_s=0.4, rate_hz=4))
        self.refused("breaths", "t.csv", says=("t.csv: the median breath has 4 samples", "more samples a second"))
        self.file("t.csv", trace(count=2, period_s=4, inspiration_s=1.6, tau_s=0.4))
        self.assertIn("note: 2 breath(s) used: so few", self.gates("t.csv")[1])


class Real(TrunkTest):
    def test_canterbury(self):
        for name, tidal, spread in (("cant_Subject03_0cmH2O_0mL", 1040, 80), ("cant_Subject01_0cmH2O_0mL", 970, 130)):
            with self.subTest(name):
                found = self.succeeds("breaths", shared_file(f"traces/{name}.csv"))
                self.assertEqual((found["breaths_found"], found["breaths_kept"]), (10, 10))
                self.assertAlmostEqual(found["tidal_volume_ml"], tidal, delta=spread)
                again = self.succeeds("breaths", shared_file(f"traces/{name}.csv"), "--signal", "volume_L")
                self.assertEqual(again["breaths_found"], 10)
                self.assertAlmostEqual(again["tidal_volume_ml"], found["tidal_volume_ml"], delta=15)

    def test_a_clipped_chest_belt_has_breaths(self):
        belt = Path(shared_file("traces/biosppy_resp_100Hz.csv")).read_text(encoding="utf-8")
        self.file("t.csv", belt.replace("belt_au", "volume_ml"))
        found = self.succeeds("breaths", "t.csv", "--calibrate-tidal-volume", "500")
        self.assertTrue(15 <= found["breaths_found"] <= 25, found["breaths_found"])
        self.assertTrue(10 <= found["breaths_kept"] < found["breaths_found"])
        self.assertAlmostEqual(found["median"]["tidal_volume_ml"], 500, places=6)
        self.assertRegex("; ".join(found["notes"]), "highest value, .*clipped")
        for one in found["breaths"]:
            self.assertEqual(one["kept"], one["reason"] == "")

    def test_a_chest_belt_is_not_a_volume(self):
        """It has breaths in a unit of its own; a fit wants to know how large they are."""
        belt = shared_file("traces/biosppy_resp_100Hz.csv")
        shown = self.succeeds("breaths", belt)
        self.assertGreater(shown["breaths_kept"], 8)
        self.refused("fit", HEALTHY, "--trace", belt, "-o", "f.h5", says="--calibrate-tidal-volume")
        calibrated = self.succeeds("breaths", belt, "--calibrate-tidal-volume", "500")
        self.assertEqual(calibrated["breaths_kept"], shown["breaths_kept"])


if __name__ == "__main__":
    unittest.main()
