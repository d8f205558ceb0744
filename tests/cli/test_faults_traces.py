"""Recordings as other programs write them, through the program itself: the tidal volume, or the sentence. The readers
are tested in C++; here are the options and the words that reach a user."""

import math
import unittest

from support import TrunkTest

RATE, PERIOD, TIDAL_VOLUME = 50, 4.0, 0.5  # Hz, s, L
INSPIRATION, EXPIRATION = 1.6, 2.0  # s


def flow(t):
    """Half sines of 0.5 L, then rest; L/s."""
    t %= PERIOD
    if t < INSPIRATION:
        return TIDAL_VOLUME * math.pi / 2 / INSPIRATION * math.sin(math.pi * t / INSPIRATION)
    if t < INSPIRATION + EXPIRATION:
        return -TIDAL_VOLUME * math.pi / 2 / EXPIRATION * math.sin(math.pi * (t - INSPIRATION) / EXPIRATION)
    return 0.0


SAMPLES = [(i / RATE, flow(i / RATE)) for i in range(40 * RATE)]


def labchart(unit="L/s", scale=1, first=0, last=None):
    header = ["Interval=\t20 ms", "ExcelDateTime=\t4.5363e+004\t12/03/2024 09:42:10", "TimeFormat=\tStartOfBlock",
              "DateFormat=\t", "ChannelTitle=\tEMG\tFluss", "Range=\t1.0 mV\t10.000 V", f"UnitName=\t\u00b5V\t{unit}"]
    rows = [f"{t:.2f}\t3.5\t{scale * v:.5f}" + ("\t#* Husten " if i == 77 else "")
            for i, (t, v) in enumerate(SAMPLES[first:last])]
    return "\r\n".join(header + [row.replace(".", ",") for row in rows]) + "\r\n"


class FilesOfTheField(TrunkTest):
    def tidal_volume(self, content, *options, notes=()):
        name = self.file("recording.txt", content)
        outcome = self.trunk("breaths", name, *options, "--json")
        self.assertEqual(outcome.code, 0, str(outcome))
        for words in notes:
            self.assertRegex(outcome.err, words)
        volume = outcome.json()["median"]["tidal_volume_ml"]
        self.assertAlmostEqual(volume, 1000 * TIDAL_VOLUME, delta=10)

    def test_labchart(self):
        self.tidal_volume(labchart().encode("cp1252"), notes=["1 comment in the file: 'Husten' in line 85"])
        blocks = labchart(last=200) + labchart("L/min", 60)
        self.tidal_volume(blocks, notes=["has 2 blocks, of 4, 40 s: block 2, the longest, is read"])
        self.refused("breaths", self.file("b.txt", blocks), "--block", "3", says="^trunk: --block 3: b.txt has 2 blocks;")

    def test_code_pages(self):
        table = "時間\t流量 (L/s)\n" + "".join(f"{t:.2f}\t{v:.5f}\n" for t, v in SAMPLES)
        options = ("--time", "時間", "--time-unit", "s", "--flow", "流量 (L/s)")
        self.tidal_volume(table.encode("shift_jis"), *options, "--encoding", "Shift_JIS")
        self.tidal_volume(table.encode("utf-16"), *options)
        self.refused("breaths", "recording.txt", "--encoding", "Shift JIS", says="no encoding of this name.*`iconv -l`")

    def test_clocks(self):
        def clocks(text):
            return "Tempo\tFLUSSO (l/min)\n" + "".join(f"{text(t)}\t{60 * v:.4f}\n" for t, v in SAMPLES)
        self.tidal_volume(clocks(lambda t: f"00:10:{int(t + 1e-9):02}:{round(1000 * t) % 1000:03}"))
        self.tidal_volume(clocks(lambda t: f"11:59:{20 + t:05.2f} PM"))
        self.tidal_volume(clocks(lambda t: f"2024-10-27T02:00:{t:05.2f}+02:00"))

    def test_what_is_not_read_is_named_with_the_way_out(self):
        breaths = "t;VO2;VCO2;RER;VT\n" + "".join(f"{3 * i};250;210;0,84;0,5\n" for i in range(40))
        belts = "time_s,Thorax,Abdomen\n" + "".join(f"{t:.2f},{v:.4f},{-v:.4f}\n" for t, v in SAMPLES)
        for content, words in ((breaths, "each row seems to be a breath.*metabolic cart.*export flow or volume"),
                               (belts, "'Thorax' is understood as the belt of the thorax.*--belt 'Thorax'"),
                               ("<html><body><table>", "web page, perhaps a spreadsheet.*save the sheet as CSV"),
                               (b"PK\3\4" + bytes(200), r"a spreadsheet \(.xlsx, .ods\).*save the sheet as CSV")):
            self.refused("breaths", self.file("x.txt", content), says=words)


if __name__ == "__main__":
    unittest.main()
