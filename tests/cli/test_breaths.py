"""trunk breaths and trunk check: what the program sees in a trace, before anything is fitted."""

import unittest

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
        self.assertRegex(outcome.err, r"\Anote: a drift of 45 ml a breath was removed\n\Z")
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


class Real(TrunkTest):
    def test_canterbury(self):
        for name, tidal, spread in (("cant_Subject03_0cmH2O_0mL", 1040, 80), ("cant_Subject01_0cmH2O_0mL", 970, 130)):
            with self.subTest(name):
                found = self.succeeds("breaths", shared_file(f"traces/{name}.csv"))
                self.assertGreaterEqual(found["breaths_found"], 9)
                self.assertGreaterEqual(found["breaths_kept"], 8)
                self.assertAlmostEqual(found["tidal_volume_ml"], tidal, delta=spread)

    def test_a_chest_belt_is_not_a_volume(self):
        self.refused("breaths", shared_file("traces/biosppy_resp_100Hz.csv"),
                     says=(r"biosppy_resp_100Hz.csv: ", "expected"))


if __name__ == "__main__":
    unittest.main()
