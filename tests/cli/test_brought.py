"""What people bring: tables of spreadsheets and loggers, EDF, columns of other names; and all mistakes at once."""

import struct
import unittest

from support import HEALTHY, TrunkTest, breaths, csv

TIMES, VOLUMES = breaths()
FLOWS = [0] + [(b - a) * 0.1 for a, b in zip(VOLUMES, VOLUMES[1:])]  # L/s at 100 Hz


def comma(value, digits=4):
    return f"{value:.{digits}f}".replace(".", ",")


def edf(label, unit, values, rate, most):
    """An EDF file of one channel; records last a second."""
    def fields(*texts):
        return b"".join(str(text).ljust(width).encode() for text, width in texts)
    values = values[:len(values) // rate * rate]
    head = fields(("0", 8), ("X X X X", 80), ("Startdate 01-JAN-2024 X X X", 80), ("01.01.2408.00.00", 16), (512, 8),
                  ("", 44), (len(values) // rate, 8), (1, 8), (1, 4), (label, 16), ("", 80), (unit, 8), (-most, 8),
                  (most, 8), (-32767, 8), (32767, 8), ("", 80), (rate, 8), ("", 32))
    return head + b"".join(struct.pack("<h", round(v / most * 32767)) for v in values)


class Files(TrunkTest):
    def found(self, content, *options, notes=None, name="t.csv"):
        outcome = self.trunk("breaths", self.file(name, content), *options, "--json")
        self.assertEqual(outcome.code, 0, str(outcome))
        if notes is not None:
            self.assertRegex(outcome.err, rf"\A{notes}\Z")
        return outcome.json()

    def assert_usual(self, found, count=5):
        self.assertEqual(found["breaths_kept"], count)
        self.assertAlmostEqual(found["tidal_volume_ml"], 500, delta=12)

    def test_a_spreadsheet_in_german(self):
        rows = "".join(f"{comma(t, 2)};{comma(60 * f)};1,0\r\n" for t, f in zip(TIMES, FLOWS))
        table = "Zeit [s];Fluss (l/min);Druck [mbar]\r\n" + rows
        told = "note: taken by name: column 'Zeit \\[s\\]' as the time, column 'Fluss \\(l/min\\)' as the flow\n"
        for content in ("\ufeff" + table, table.encode("utf-16"), table.encode("utf-16-le")):
            self.assert_usual(self.found(content, notes=told))
        self.refused("breaths", self.file("t.csv", table), "--flow", "Flus",
                     says=r"t.csv:1: no column 'Flus' among 'Zeit \[s\]', 'Fluss \(l/min\)', 'Druck \[mbar\]'; expected")
        self.refused("breaths", "t.csv", "--volume", "Fluss", says="t.csv:1: .*in L_min.*expected.*--flow")

    def test_a_logger_in_german(self):
        rows = "".join(f"23:59:{57 + int(t)},{round(100 * t) % 100:02};{comma(f)}\n" if t < 3 else
                       f"00:00:{int(t) - 3:02},{round(100 * t) % 100:02};{comma(f)}\n" for t, f in zip(TIMES, FLOWS))
        table = "Ger\u00e4t: Logger\nAbtastrate;100\n\nUhrzeit;Atemflu\u00df\nhh:mm:ss;l/s\n" + rows
        self.assert_usual(self.found(table.encode("cp1252"), notes="note: taken by name: [^\n]*'Atemflu\u00df' as the flow\n"))

    def test_columns_by_number_and_units_by_option(self):
        table = "".join(f"{t:.2f},{f:.5f}\n" for t, f in zip(TIMES, FLOWS))
        self.refused("breaths", self.file("t.csv", table), says=("t.csv:1: the first row", "--time 1 --flow 2 --unit L/s"))
        self.assert_usual(self.found(table, "--time", "1", "--flow", "2", "--unit", "L/s"))
        self.assert_usual(self.found(csv(TIMES, VOLUMES, "a,b"), "--rate", "100", "--volume", "b", "--unit", "ml"))
        self.refused("breaths", "t.csv", "--rate", "100", "--time", "1", says="--rate|--time")
        self.refused("breaths", "t.csv", "--flow", "1", "--volume", "2", says="--flow|--volume")
        self.refused("breaths", "t.csv", "--volume", "b", "--time", "a", "--unit", "mol", says="--unit mol: .*; expected a unit")

    def test_edf(self):
        content = edf("Resp Volume", "mL", VOLUMES, 100, 2000)
        self.assert_usual(self.found(content, name="t.edf"), count=4)  # records of 1 s: the fifth is cut
        self.refused("breaths", self.file("t.edf", content[:-2]), says="t.edf: an EDF or BDF file.*expected")

    def test_a_coarse_clock_and_bad_cells_are_repaired(self):
        times, volumes = breaths(rate_hz=500)
        self.assert_usual(self.found(
                                     "time_s,volume_ml\n" + "".join(f"{t:.2f},{v:.2f}\n" for t, v in zip(times, volumes)),
                                     notes="note: 3000 samples share the time .*500 a second\n"))
        lines = csv(TIMES, VOLUMES).splitlines()
        lines[51], lines[52], lines[300] = "0.5000,OVF", "0.5100,---", "2.9900,"
        told = ("note: 3 samples without a number interpolated; the first: t.csv:52: 'OVF' found in column 'volume_ml'\n"
                "note: 1 sample without a number at an end of the recording left out: t.csv:753: .*\n")
        self.assert_usual(self.found("\n".join(lines) + "\n7.51", notes=told))


class AllAtOnce(TrunkTest):
    def test_every_mistake_is_listed(self):
        self.file("s.toml", "title = 3\n[time]\ndt_ms = 0\nduration_s = 1\n[tissue]\nribs = \"yes\"\n")
        self.file("t.csv", csv(TIMES, VOLUMES, "clock,volume_m2"))
        command = ("check", "s.toml", "--trace", "t.csv", "--free", "k_muscle,beauty", "--fix", "k_muscle=3")
        expected = (r"s.toml:1: title is 3", r"s.toml:3: time.dt_ms is 0", r"s.toml:6: tissue.ribs is .*yes",
                    r"t.csv:1: no time column", r"t.csv:1: no volume or flow column",
                    "--free beauty: there is no parameter 'beauty'", "parameter 'k_muscle' is both free and fixed")
        outcome = self.trunk(*command)
        self.assertEqual((outcome.code, outcome.out), (2, ""), str(outcome))
        self.assertEqual(len(outcome.err.splitlines()), len(expected), str(outcome))
        for line, pattern in zip(outcome.err.splitlines(), expected):
            self.assertRegex(line, r"\Atrunk: " + pattern)
        outcome = self.trunk(*command, "--json")
        self.assertEqual(outcome.code, 2, str(outcome))
        found = outcome.json()
        self.assertEqual(found["schema"], "trunk.check/1")
        self.assertEqual([(p["file"], p["line"]) for p in found["problems"]],
                         [("s.toml", 1), ("s.toml", 3), ("s.toml", 6), ("t.csv", 1), ("t.csv", 1), (None, None), (None, None)])
        self.assertEqual([p["option"] for p in found["problems"]], 5 * [None] + ["--free beauty", None])
        self.assertRegex(found["problems"][1]["text"], r"\Atime.dt_ms is 0; expected")

    def test_other_commands_name_the_first_and_how_many(self):
        self.file("s.toml", "title = 3\n[time]\ndt_ms = 0\n")
        self.refused("simulate", "s.toml", "-o", "r.h5", says=r"s.toml:1: title .*\(and 1 more: `trunk check` lists all\)")

    def test_what_a_fit_could_not_use(self):
        self.file("t.csv", csv(TIMES, VOLUMES))
        for options, says in ((("--fix", "k_elasticity=2"), "--fix k_elasticity=2: 2 N/m is out of bounds; expected 20 to"),
                              (("--fix", "k_muscle=@none.h5"), "none.h5: no such file.*named in --fix k_muscle=@none.h5"),
                              (("--fix", "k_muscle"), "--fix k_muscle: no value is given; expected name=value"),
                              (("--fix", "k_muscle=30", "--fix", "k_elasticity=4000"), "no parameter is free"),
                              (("--set", "activation.rise_s=1"), "--set activation.rise_s=1: the trace gives the timing; expected --timing scenario"),
                              (("--prior", "k_muscle=1e9:2"), "k_muscle"),
                              (("--set", "paralysis.side=both"), "--set paralysis.side=both: k_muscle has no effect"),
                              (("--set", "parameters.k_elasticity_N_per_m=10", "--set", "time.start=rest"),
                               "k_elasticity starts a fit at 10 N/m; expected 20")):
            with self.subTest(options):
                self.refused("check", HEALTHY, "--trace", "t.csv", *options, says=says)
        self.succeeds("check", HEALTHY, "--trace", "t.csv", "--free", "k_muscle", "--fix", "k_elasticity=4000")

    def test_a_trace_alone_and_its_doubts(self):
        self.file("t.csv", csv(*breaths(count=3, tidal_ml=2500)))
        outcome = self.trunk("check", "--trace", "t.csv", "--json")
        self.assertEqual(outcome.code, 0, str(outcome))
        self.assertEqual(outcome.json()["problems"], [])
        self.assertTrue(any("beyond what the model was made for" in note for note in outcome.json()["notes"]), str(outcome))


if __name__ == "__main__":
    unittest.main()
