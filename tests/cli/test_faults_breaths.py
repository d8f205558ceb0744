"""Recordings whose breaths differ, or whose flowmeter does not do its work: what the program says and stores."""

import json
import math
import unittest

import h5py

from support import FAST_FIT, HEALTHY, TrunkTest, csv


def flow_of(breaths, rate_hz=50):
    """Times and flow (L/s) of breaths (tidal volume ml, inspiration s, expiration s), half a second apart."""
    times, flow, begin = [], [], 1.0
    marks = []
    for tidal, inspiration, expiration in breaths:
        marks.append((begin, inspiration, expiration, tidal))
        begin += inspiration + expiration + 0.5
    for i in range(int((begin + 1) * rate_hz)):
        t, now = i / rate_hz, 0.0
        for start, inspiration, expiration, tidal in marks:
            s = t - start
            if 0 <= s < inspiration:
                now = math.pi * tidal / (2000 * inspiration) * math.sin(math.pi * s / inspiration)
            elif inspiration <= s < inspiration + expiration:
                now = -math.pi * tidal / (2000 * expiration) * math.sin(math.pi * (s - inspiration) / expiration)
        times.append(t)
        flow.append(now)
    return times, flow


QUIET, EXERCISE = (500, 1.5, 2.0), (1800, 0.8, 1.0)


class TwoSizes(TrunkTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.text = csv(*flow_of(12 * [QUIET] + 10 * [EXERCISE]), "time_s,flow_L_s").replace("-0.0000", "0.0000")

    def test_one_is_summarised_and_a_window_chooses(self):
        self.file("t.csv", self.text)
        both = self.succeeds("breaths", "t.csv")
        self.assertEqual((both["breaths_found"], both["breaths_kept"]), (22, 12))
        self.assertAlmostEqual(both["tidal_volume_ml"], 500, delta=5)
        self.assertNotIn("window", both)
        self.assertRegex("; ".join(both["notes"]), r"more than one size: .*\(breaths 1 to 12\), .*\(breaths 13 to 22\)")
        window = self.succeeds("breaths", "t.csv", "--begin", "48.5", "--exclude", "14")
        self.assertEqual([b["number"] for b in window["breaths"]], list(range(13, 23)))
        self.assertEqual([b["number"] for b in window["breaths"] if not b["kept"]], [14])
        self.assertAlmostEqual(window["tidal_volume_ml"], 1800, delta=20)
        self.assertEqual(window["window"]["begin_s"], 48.5)
        self.assertEqual([window["window"][key] for key in ("first_breath", "last_breath", "breaths_recorded")], [13, 22, 22])
        self.assertRegex("; ".join(window["notes"]), "only the time from 48.5 s to .* is used: breaths 13 to 22 of 22")
        self.assertRegex(self.trunk("breaths", "t.csv", "--begin", "48.5").out, r"(?m)^ +13 ")
        self.refused("breaths", "t.csv", "--begin", "48.5", "--exclude", "3", says="expected 13 to 22")
        self.refused("breaths", "t.csv", "--begin", "60", "--end", "50", says="--begin 60: --end 50 comes before it")
        self.refused("breaths", "t.csv", "--begin", "5", "--end", "6", says="no whole breath between --begin 5 s and --end 6 s")
        self.refused("breaths", "t.csv", "--begin", "soon", says="--begin")

    def test_the_window_is_stored_with_the_fit(self):
        self.file("t.csv", self.text)
        checked = self.succeeds("check", HEALTHY, "--trace", "t.csv", "--end", "49.5")
        self.assertEqual(checked["breaths_used"], 12)
        outcome = self.trunk("fit", HEALTHY, "--trace", "t.csv", "--begin", "12.5", "--end", "49.5", *FAST_FIT,
                             "--assume", "straight-activation", "-o", "f.h5", "--json")
        self.assertIn(outcome.code, (0, 4), str(outcome))  # what it determines is not the question
        fitted = outcome.json()
        self.assertEqual(fitted["breaths_used"], 9)
        self.assertEqual([fitted["window"][key] for key in ("begin_s", "end_s", "first_breath")], [12.5, 49.5, 4])
        with h5py.File(self.folder / "f.h5") as file:
            statistics = file["result/statistics"]
            stored = {name: float(statistics[name][()]) for name in ("window_begin", "window_end")}
        self.assertEqual(stored, {"window_begin": 12.5, "window_end": 49.5})
        self.assertIn("breaths 4 to 12 of 22", json.dumps(fitted["notes"]))


class Flowmeter(TrunkTest):
    def test_pulses_at_zero_and_a_spike(self):
        times, flow = flow_of(12 * [QUIET], rate_hz=100)
        zeroed = [0.0 if t % 5 > 4.7 else q for t, q in zip(times, flow)]
        zeroed[1234] = 100.0
        found = self.succeeds("breaths", self.file("t.csv", csv(times, zeroed, "time_s,flow_L_s")))
        self.assertEqual(found["breaths_kept"], 12)
        self.assertAlmostEqual(found["tidal_volume_ml"], 500, delta=10)
        notes = "; ".join(found["notes"])
        self.assertRegex(notes, r"\d pulse\(s\) of 0\.(29|3) s at zero flow, .*: the flow is bridged there")
        self.assertNotIn("clipped", notes)


if __name__ == "__main__":
    unittest.main()
