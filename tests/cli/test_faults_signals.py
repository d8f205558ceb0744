"""Traces that can be read and are not what their names say: a wrong unit, no sign, a counter, a pressure in kPa."""

import unittest

from support import FAST_FIT, TrunkTest, breaths

try:
    import h5py
except ImportError as missing:
    raise unittest.SkipTest(f"{missing}: apt install python3-h5py")

RATE_HZ = 50
TIMES, VOLUMES = breaths(count=8, period_s=4, inspiration_s=1.6, tau_s=0.4, rate_hz=RATE_HZ)  # 500 ml
FLOWS = [0.0] + [(b - a) * RATE_HZ / 1000 for a, b in zip(VOLUMES, VOLUMES[1:])]  # L/s


def table(header, *columns):
    return header + "\n" + "".join(",".join(f"{v:.5f}" for v in row) + "\n" for row in zip(TIMES, *columns))


def counted(volumes):
    total, counts = 0.0, [0.0]
    for a, b in zip(volumes, volumes[1:]):
        total += max(b - a, 0)
        counts.append(total)
    return counts


class Refused(TrunkTest):
    def test_is_named_with_a_remedy(self):
        middle = len(TIMES) // 2
        rows = table("time_s,flow_L_s", FLOWS).splitlines()
        for name, text, says in (
            ("no sign", table("time_s,flow_L_s", [abs(q) for q in FLOWS]),
             ("the flow goes one way", "its sign were lost", "export the flow with its sign")),
            ("one direction", table("time_s,flow_L_s", [max(q, 0) for q in FLOWS]), ("only one direction",)),
            ("offset", table("time_s,flow_L_s", [q + 2 for q in FLOWS]), ("offset of the sensor", "--remove-drift")),
            ("counter", table("time_s,volume_ml", counted(VOLUMES)), ("hardly comes back", "counter of one direction")),
            ("L/min as L/s", table("time_s,flow_L_s,volume_ml", [60 * q for q in FLOWS], VOLUMES),
             (r"rises by 1/6\d.* of what flow", "add --unit L/min")),
            ("factor", table("time_s,Flow (mL/s x10)", FLOWS), ("the unit 'mL/s x10' of",)),
            ("second header", "\n".join([*rows[:middle], "time_s,flow_L_min", *rows[middle:]]) + "\n",
             (f":{middle + 1}: a second header, 'time_s'", "files of their own")),
            ("kPa", table("time_s,flow_L_s,Pes,Pga,Pdi", FLOWS, [-5 - v / 100 for v in VOLUMES],
                          [8 + v / 1000 for v in VOLUMES], [(13 + v * 0.011) / 10.197 for v in VOLUMES]),
             ("'Pdi' is in kPa and not in cmH2O",)),
        ):
            with self.subTest(name):
                self.refused("breaths", self.file("t.csv", text), says=("t.csv", *says))

    def test_unless_the_user_says_what_it_is(self):
        self.file("t.csv", table("time_s,flow_L_s", [q + 2 for q in FLOWS]))
        found = self.succeeds("breaths", "t.csv", "--remove-drift")
        self.assertAlmostEqual(found["tidal_volume_ml"], 500, delta=10)
        self.assertIn("--remove-drift takes away a drift as large as a breath", " ".join(found["notes"]))
        self.file("m.csv", table("time_s,flow_L_s,volume_ml", [60 * q for q in FLOWS], VOLUMES))
        self.assertAlmostEqual(self.succeeds("breaths", "m.csv", "--unit", "L/min")["tidal_volume_ml"], 500, delta=10)


class Told(TrunkTest):
    def test_a_factor_is_applied(self):
        self.file("t.csv", table("time_s,Flow (0.1 L/min)", [600 * q for q in FLOWS]))
        found = self.succeeds("breaths", "t.csv")
        self.assertAlmostEqual(found["tidal_volume_ml"], 500, delta=10)
        self.assertIn("is 0.1 L/min, as its unit says", " ".join(found["notes"]))

    def everywhere(self, words, *arguments):
        """The words stand in the terminal or the JSON object, in the result file and in the report."""
        shown = self.trunk("fit", *arguments, *FAST_FIT, "--free", "k_muscle", "-o", "f.h5", "--json")
        self.assertIn(shown.code, (0, 4), str(shown))
        self.trunk("report", "f.h5", "-o", "f.html")
        page = (self.folder / "f.html").read_text(encoding="utf-8")
        texts = []
        with h5py.File(self.folder / "f.h5") as file:
            file.visititems(lambda _, item: texts.append(str(item[()])) if isinstance(item, h5py.Dataset)
                            and item.dtype.kind in "OS" else None)
        for word in words:
            with self.subTest(word):
                self.assertIn(word, shown.err + shown.out)
                self.assertIn(word, str(shown.json()))
                self.assertIn(word, " ".join(texts))
                self.assertIn(word.replace("'", "&#39;"), page.replace("'", "&#39;"))

    def test_doubts_stand_everywhere(self):
        """A tidal volume of a child on the trunk of an adult, whose flow and volume do not agree."""
        self.file("t.csv", table("time_s,flow_L_s,volume_ml", [0.13 * q for q in FLOWS], [0.08 * v for v in VOLUMES]))
        self.everywhere(("one of the two has another calibration", "is the unit right?",
                         "this trunk is an adult's of 4760 ml"), "t.csv")

    def test_a_pressure_in_kPa_is_doubted(self):
        self.file("t.csv", table("time_s,flow_L_s,Pes (cmH2O)", FLOWS, [-0.5 - v / 1000 for v in VOLUMES]))
        self.assertIn("where lungs take 3 to 100", " ".join(self.succeeds("breaths", "t.csv")["notes"]))


if __name__ == "__main__":
    unittest.main()
