"""Pressures beside the volume: how breaths, check and fit take them, what they compute, and what they refuse."""

import json
import math
import unittest
from csv import DictReader

from report_page import ReportPage
from support import FAST_FIT, HEALTHY, SCENARIOS, TrunkTest, shared_file

FITTED = (0, 4)
E, R, VT, TI, TAU, PERIOD = 5.0, 2.5, 0.5, 1.6, 0.4, 4.0  # cmH2O/L, cmH2O s/L, L, s
HEADER = "time_s,flow_L_s,volume_L,Pes (cmH2O),Pga (cmH2O)"


def lung(count=6, flow_sign=1.0, unit=1.0, header=HEADER, volume_column=True, swallow_in=None):
    """A lung of one elastance and one resistance: half a sine of flow in, a passive way out. As a table."""
    rows = [header]
    for i in range(round(100 * (count * PERIOD + 0.4)) + 1):
        time = i / 100
        t = (time - 0.2) % PERIOD
        if t < TI:
            flow, volume = VT * math.pi / (2 * TI) * math.sin(math.pi * t / TI), VT / 2 * (1 - math.cos(math.pi * t / TI))
        else:
            volume = VT * math.exp((TI - t) / TAU)
            flow = -volume / TAU
        poes = -5 - E * volume - R * flow
        if swallow_in is not None:
            poes += 30 * math.exp(-0.5 * ((time - (swallow_in - 0.5) * PERIOD) / 0.3) ** 2)
        cells = [time, flow_sign * flow, volume, unit * poes, unit * (8 + 8 * volume)]
        rows.append(",".join(f"{cell:.5f}" for k, cell in enumerate(cells) if k != 2 or volume_column))
    return "\n".join(rows) + "\n"


class Numbers(TrunkTest):
    def found(self, text, *options):
        return self.succeeds("breaths", self.file("t.csv", text), *options)

    def test_table_json_and_csv_agree_with_the_closed_form(self):
        found = self.found(lung(), "--csv", "b.csv", "--pdi-max", "100", "--chest-wall-compliance", "200")
        work = (E * VT / 2 + R * math.pi ** 2 * VT / (8 * TI) + VT / 0.4) * 0.0980665
        product = (E * VT * TI / 2 + R * VT + VT * TI / 0.4) * 60 / PERIOD
        clinic = found["clinic"]
        self.assertAlmostEqual(clinic["work_of_breathing_J_per_L"]["value"], work, delta=0.03 * work)
        self.assertAlmostEqual(clinic["pressure_time_product_pleural_cmH2O_s_per_min"]["value"], product, delta=0.03 * product)
        self.assertAlmostEqual(clinic["gastric_swing_cmH2O"]["value"], 4, delta=0.05)
        self.assertIn("tension_time_index", clinic)
        for number in clinic.values():
            self.assertEqual(set(number), {"value", "unit", "lower95", "upper95", "of_mean_breath", "meaning", "doubt"})
            self.assertTrue(number["lower95"] <= number["value"] <= number["upper95"])
        self.assertEqual(found["channels"]["poes"], {"column": "Pes (cmH2O)", "unit": "cmH2O"})
        with open(self.folder / "b.csv", encoding="utf-8", newline="") as file:
            rows = list(DictReader(file))
        self.assertEqual(len(rows), found["breaths_found"])
        for row, breath in zip(rows, found["breaths"]):
            for name in clinic:
                self.assertAlmostEqual(float(row[name]), breath[name], delta=1e-5 * abs(breath[name]) + 1e-9)
        shown = self.trunk("breaths", "t.csv").out
        self.assertRegex(shown, r"dPpl +dPga +dPdi +WOB +PTPpl +PTPdi +Cdyn +R +PEEPi")
        self.assertEqual(len([line for line in shown.splitlines() if line.startswith("  mean")]), 2)

    def test_a_breath_that_is_not_kept_has_no_numbers(self):
        found = self.found(lung(), "--exclude", "2")
        self.assertNotIn("pleural_swing_cmH2O", found["breaths"][1])
        self.assertIn("pleural_swing_cmH2O", found["breaths"][2])

    def test_a_swallow_is_named_and_has_no_numbers(self):
        found = self.found(lung(swallow_in=3))
        self.assertRegex(" ".join(found["notes"]), "breath 3 does not count for the oesophageal pressure: a spike")
        self.assertIsNone(found["breaths"][2]["work_of_breathing_J_per_L"])
        self.assertAlmostEqual(found["breaths"][2]["gastric_swing_cmH2O"], 4, delta=0.1)

    def test_units_and_options_give_the_same_numbers(self):
        plain = self.found(lung())["clinic"]["work_of_breathing_J_per_L"]["value"]
        for header, factor, options in (
                (HEADER.replace("cmH2O", "kPa"), 0.0980665, ()),
                (HEADER.replace("Pes (cmH2O)", "A").replace("Pga (cmH2O)", "B"), 0.0980665,
                 ("--pes", "A", "--pgas", "5", "--pressure-unit", "kPa")),
                (HEADER.replace(" (cmH2O)", ""), 1, ())):
            with self.subTest(header):
                found = self.found(lung(unit=factor, header=header), *options)
                self.assertAlmostEqual(found["clinic"]["work_of_breathing_J_per_L"]["value"], plain, delta=2e-3 * plain)

    def test_none_leaves_a_channel_out(self):
        found = self.found(lung(), "--poes", "none", "--pga", "none")
        self.assertNotIn("clinic", found)
        self.assertNotIn("channels", found)

    def test_a_belt_without_a_scale_has_no_numbers(self):
        self.file("t.csv", lung())
        found = self.succeeds("breaths", "t.csv", "--belt", "volume_L")
        self.assertNotIn("clinic", found)


class Sign(TrunkTest):
    def test_volume_or_pressure_turn_a_flow(self):
        upright = self.succeeds("breaths", self.file("t.csv", lung()))
        for name, text in {
            "volume": lung(flow_sign=-1),
            "pressure": lung(flow_sign=-1, header=HEADER.replace("volume_L,", ""), volume_column=False),
        }.items():
            with self.subTest(name):
                found = self.succeeds("breaths", self.file("t.csv", text))
                self.assertRegex(" ".join(found["notes"]), "is turned")
                self.assertNotRegex(" ".join(found["notes"]), "which way is up")
                self.assertEqual(found["gates"], [])
                self.assertEqual(found["breaths"], upright["breaths"])

    def test_what_cannot_be_is_refused_in_one_line(self):
        self.file("t.csv", lung())
        self.file("wrong.csv", lung(unit=98.0665))
        for options, says in (
                (("--invert-channel", "poes"), ("'Pes .cmH2O.' moves the wrong way", "--invert-channel poes", "--poes none")),
                (("--poes", "nothing"), ("t.csv:1: no column 'nothing'",)),
                (("--pressure-unit", "psi"), ("--pressure-unit psi", "cmH2O, mbar, hPa, kPa, Pa or mmHg")),
                (("--pdi", "Pga (cmH2O)"), ("is not gastric", "they differ by", "--pdi none"))):
            for command in (("breaths", "t.csv"), ("check", HEALTHY, "--trace", "t.csv")):
                with self.subTest(options=options, command=command[0]):
                    self.refused(*command, *options, says=says)
        self.refused("breaths", "wrong.csv", "--pga", "none", says=("'Pes .cmH2O.' swings by \\d\\d\\d cmH2O", "0.05 to 150 cmH2O", "if it is in Pa, give --pressure-unit Pa"))


class Fit(TrunkTest):
    def test_numbers_reach_results_json_and_file(self):
        import h5py
        self.file("t.csv", lung())
        fit = self.succeeds("fit", HEALTHY, "--trace", "t.csv", "-o", "f.h5", *FAST_FIT, codes=FITTED)
        breaths = self.succeeds("breaths", "t.csv")
        for name in ("work_of_breathing_J_per_L", "pressure_time_product_transdiaphragmatic_cmH2O_s_per_min",
                     "pleural_swing_cmH2O", "transdiaphragmatic_swing_cmH2O", "intrinsic_peep_cmH2O"):
            result = fit["results"][name]
            self.assertEqual(result["grade"], "determined")
            self.assertEqual(result["value"], breaths["clinic"][name]["value"])
        self.assertEqual([row["number"] for row in fit["breaths"]], [1, 2, 3, 4, 5, 6])
        with h5py.File(self.folder / "f.h5") as file:
            for row, stored in zip(fit["breaths"], file["breaths/work_of_breathing_J_per_L"][()]):
                self.assertEqual(row["work_of_breathing_J_per_L"], stored)
            self.assertEqual(file["breaths/work_of_breathing_J_per_L"].attrs["units"], b"J L-1")
            self.assert_channels_are_stored(file)
        self.succeeds("export", "f.h5", "--csv", "tables")
        with open(self.folder / "tables" / "breath.csv", encoding="utf-8", newline="") as table:
            rows = list(DictReader(table))
        for name in ("oesophageal", "gastric"):
            swing = [float(row[f"{name}_pressure_measured_cmH2O"]) for row in rows]
            off = [float(row[f"{name}_pressure_fit_cmH2O"]) - v for row, v in zip(rows, swing)]
            rms = math.sqrt(sum(v * v for v in off) / len(off))
            self.assertLess(rms, 0.1 * (max(swing) - min(swing)))
        self.trunk("report", "f.h5", "-o", "f.html")
        shown = ReportPage(self.folder / "f.html").files[0]["fit"]["channels"]
        self.assertEqual([(c["meaning"], c["unit"]) for c in shown],
                         [("oesophageal pressure", "cmH2O"), ("gastric pressure", "cmH2O")])
        for channel in shown:
            self.assertEqual({len(channel[curve]) for curve in ("measured", "sigma", "model")}, {len(rows)})
        self.assertIn("inspiratory work of breathing", self.trunk("fit", HEALTHY, "--trace", "t.csv", "-o", "g.h5", *FAST_FIT).out)

    def assert_channels_are_stored(self, file):
        """The mean breath of both pressures: closed forms, and a model that was fitted to them."""
        time, channels = file["problem/time"][()], file["channels"]
        self.assertEqual(set(channels) - {"time"}, {"gastric_pressure", "oesophageal_pressure"})
        for name, top in (("gastric_pressure", 8 * VT), ("oesophageal_pressure", -E * VT)):
            of = channels[name]
            self.assertEqual(of["measured"].attrs["units"], b"cmH2O")
            self.assertEqual(of["measured"].shape, time.shape)
            at_peak = file["problem/measured"][()].argmax()
            self.assertAlmostEqual(of["measured"][at_peak], top, delta=0.05 * abs(top))
            self.assertTrue((of["sigma"][()] > 0).all())
            self.assertAlmostEqual(abs(of["residual"][()] - (of["model"][()] - of["measured"][()])).max(), 0, delta=1e-9)

    def test_a_lung_that_is_not_there_is_named(self):
        for options in (("--free", "lung_elastance"), ("--fix", "resistance=3")):
            with self.subTest(options[0]):
                self.refused("fit", SCENARIOS / "published_healthy.toml", "--tidal-volume-ml", "440", *options, "-o", "f.h5",
                             says=(f"{options[0]} {options[1].split('=')[0]}: the scenario has no lung", r"table \[lung\]"))

    def test_breath_by_breath(self):
        self.file("t.csv", lung())
        fit = self.succeeds("fit", HEALTHY, "--trace", "t.csv", "-o", "f.h5", "--breath", "each", *FAST_FIT, codes=FITTED)
        for row in fit["breaths"]:
            self.assertIn("k_muscle", row)
            self.assertGreater(row["work_of_breathing_J_per_L"], 0.2)

    def test_a_recording_with_pressures(self):
        trace = shared_file("traces/respmech_synthetic_pressures_100Hz.csv")
        outcome = self.trunk("fit", HEALTHY, "--trace", trace, "--time", "time", "--time-unit", "s", "--flow", "flow",
                             "--unit", "L/s", "--poes", "poes", "--pga", "pgas", "-o", "rm.h5", "--json")
        self.assertEqual(outcome.code, 0, str(outcome))
        fit = json.loads(outcome.out)
        self.assertRegex(outcome.err, "flow 'flow' is negative on inspiration and is turned: it runs against volume 'volume'")
        self.assertEqual(len(fit["breaths"]), 8)
        for row in fit["breaths"]:
            self.assertAlmostEqual(row["transdiaphragmatic_swing_cmH2O"], 14, delta=0.3)
            self.assertAlmostEqual(row["work_of_breathing_J_per_L"], 0.385, delta=0.01)
        # Pressure goes with volume there: 8.1 cmH2O over 1.2 L, and hardly any resistance.
        self.assertAlmostEqual(fit["results"]["dynamic_lung_elastance_cmH2O_per_L"]["value"], 6.7, delta=0.2)
        self.assertLess(fit["results"]["lung_resistance_cmH2O_s_per_L"]["value"], 0.1)
        # No airway is so wide: the number itself is doubted, and so is what rests on the usual resistance.
        self.assertEqual(fit["results"]["lung_resistance_cmH2O_s_per_L"]["grade"], "not_determined")
        self.assertRegex(fit["results"]["resistance_cmH2O_s_per_L"]["assumption"],
                         r"prior of resistance holds, which this recording contradicts: it lies \d\.\d deviations away")


if __name__ == "__main__":
    unittest.main()
