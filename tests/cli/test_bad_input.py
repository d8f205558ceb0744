"""Bad input: one line that names file, line, what was found and what was expected; exit 2; nothing written."""

import importlib.util
import subprocess
import unittest

from support import COARSE, HEALTHY, LIMIT_S, PROGRAM, TrunkTest, breaths, csv, file_limit, scenario_with, trace

TIMES, VOLUMES = breaths()
GOOD = csv(TIMES, VOLUMES)


def at_one_second(text, count=1):
    """The good trace with `count` rows from 1 s on, on line 102, replaced; '*' stands for the time."""
    lines = GOOD.splitlines()
    for i in range(101, 101 + count):
        lines[i] = text.replace("*", lines[i].partition(",")[0])
    return "\n".join(lines) + "\n"


TOO_LONG = 26  # rows without a number, at 100 Hz: a quarter of a second is bridged


class Traces(TrunkTest):
    def assert_refused(self, says):
        for command in (("breaths", "t.csv"), ("fit", HEALTHY, "--trace", "t.csv", "-o", "f.h5", "--json"),
                        ("check", HEALTHY, "--trace", "t.csv")):
            self.refused(*command, says=says)

    def test_all_ways_to_be_wrong(self):
        for name, text, *says in (
                ("empty", "", "t.csv: .*empty; expected"),
                ("blank lines only", "\n\n\n", "t.csv: .*blank.*expected a header"),
                ("header only", "time_s,volume_ml\n", "t.csv:1: a header without rows.*expected"),
                ("no header", GOOD.partition("\n")[2], "t.csv:1: .*number '0.0000'; expected a header"),
                ("no units", csv(TIMES, VOLUMES, "time,volume_ml"), "t.csv:1: .*'time'.*expected time_s"),
                ("milliseconds under s", csv(TIMES, VOLUMES, time_factor=1000),
                 "t.csv: a sample every 10 s.*expected at least 4 a second.*milliseconds.*time_ms.*--time-unit ms"),
                ("litres under ml", csv(TIMES, VOLUMES, factor=0.001),
                 r"t.csv: .*tidal volume of 0\.\d+ ml.*expected 30 to 6000 ml.*litres.*volume_L"),
                ("ml under litres", csv(TIMES, VOLUMES, "time_s,volume_L"), "tidal volume of 4.* ml.*volume_ml"),
                ("NaN", at_one_second("*,nan", TOO_LONG), "t.csv:102: 'nan' found in column 'volume_ml' .the first of 26 .*; expected a finite"),
                ("infinite", at_one_second("*,-inf", TOO_LONG), "t.csv:102: '-inf' found.*expected a finite"),
                ("a word", at_one_second("*,cough", TOO_LONG), "t.csv:102: 'cough' found.*expected a number"),
                ("an empty cell", at_one_second("*,,", TOO_LONG), "t.csv:102: .*volume_ml"),
                ("a short row", at_one_second("*", TOO_LONG), "t.csv:102: .*'volume_ml'"),
                ("a long row", at_one_second("1.0000,3,4"), "t.csv:102: 3 cells found; expected 2"),
                ("time goes back", at_one_second("0.5000,300"), "t.csv:102: time 0.5 found after 0.99.*expected"),
                ("time stands still", at_one_second("0.9900,300"), "t.csv:102: time 0.99 found after 0.99.*expected"),
                ("a gap", csv(TIMES[:100] + TIMES[200:], VOLUMES[:100] + VOLUMES[200:]),
                 "t.csv:102: a gap of 1.01 s.*expected samples every 0.01 s"),
                ("less than one breath", csv(TIMES[:90], VOLUMES[:90]), "t.csv: no whole breath.*expected at least one"),
                ("two samples", csv(TIMES[:2], VOLUMES[:2]), "t.csv: 2 samples found; expected at least 10"),
                ("constant", csv(TIMES, [7] * len(TIMES)), "t.csv: all 751 samples.* 7 ml; expected a signal"),
                ("only rising", csv(TIMES, TIMES), "t.csv: no whole breath"),
                ("decimal commas", csv(TIMES, VOLUMES, comma=True), "t.csv:2: 4 cells.*expected 2.*semicolons"),
                ("binary", b"\x89HDF\r\n\x1a\n\0\0\0\0", "t.csv:.*binary.*expected text")):
            with self.subTest(name):
                self.file("t.csv", text)
                self.assert_refused(says)

    def test_missing_and_unreadable(self):
        self.assert_refused(r"t.csv: no such file; expected")
        (self.folder / "t.csv").mkdir()
        self.assert_refused("t.csv: this is a directory; expected")
        (self.folder / "t.csv").rmdir()
        rights = self.without_rights()
        (self.folder / self.file("t.csv", GOOD)).chmod(0)
        self.refused("breaths", "t.csv", says="t.csv: cannot be opened .Permission denied.*expected", **rights)


class Scenarios(TrunkTest):
    def assert_refused(self, says):
        for command in (("simulate", "s.toml", "-o", "r.h5"), ("check", "s.toml"),
                        ("fit", "s.toml", "--tidal-volume-ml", "466", "-o", "f.h5")):
            self.refused(*command, says=says)

    def test_all_ways_to_be_wrong(self):
        for name, text, *says in (
                ("empty", "", "s.toml: .*empty"),
                ("an open list", "title = [\n", "s.toml:[12]: not valid TOML"),
                ("no value", "[time]\ndt_ms =\n", "s.toml:2: not valid TOML"),
                ("no equals sign", "[time]\ndt_ms 1\n", "s.toml:2: not valid TOML"),
                ("given twice", "[time]\ndt_ms = 1\ndt_ms = 2\n", "s.toml:3: not valid TOML.*'dt_ms'"),
                ("unknown key", "[parameters]\nk_muscel_N_per_m = 30\n",
                 "s.toml:2: unknown key 'parameters.k_muscel_N_per_m'; expected 'parameters.k_muscle_N_per_m'"),
                ("unknown table", "[lungs]\nnumber = 2\n", "s.toml:1: unknown key 'lungs'"),
                ("negative mass", scenario_with({"particle_mass_kg": -0.2}),
                 r"s.toml:\d+: tissue.particle_mass_kg is -0\.2; expected a number of kg, 1e-06 to 100\n"),
                ("no mass", scenario_with({"particle_mass_kg": 0}), r"s.toml:\d+: .* is 0; expected a number of kg"),
                ("negative stiffness", scenario_with({"k_elasticity_N_per_m": -4000}), r"s.toml:\d+: .*-4000; expected"),
                ("negative muscle", scenario_with({"k_muscle_N_per_m": -30}), r"s.toml:\d+: .*-30; expected"),
                ("negative damping", scenario_with({"damping_N_s_per_m": -1}), r"s.toml:\d+: .*-1; expected"),
                ("a number in quotes", scenario_with({"k_muscle_N_per_m": '"30"'}), r's.toml:\d+: .*30.*expected a num'),
                ("not a number", scenario_with({"k_muscle_N_per_m": "nan"}), r"s.toml:\d+: .*finite; expected a number"),
                ("unstable step", scenario_with({"dt_ms": 20}), r"s.toml:\d+: a time step of 20 ms is unstable.*expected less than"),
                ("metres for mm", scenario_with({"half_width_mm": 0.16}), r"s.toml:\d+: .*is 0\.16; expected .*50 to 400"),
                ("another schema", 'schema = "trunk.sweep/1"\n', 's.toml:1: schema is .*expected "trunk.scenario/1"'),
                ("extends itself", 'extends = "s.toml"\n', "s.toml:1: .*itself"),
                ("extends nothing", 'title = "a"\nextends = "none.toml"\n', "s.toml:2: .*none.toml.*no such file"),
                ("a load nowhere", f'extends = "{HEALTHY}"\n[[force]]\nregion = "liver"\ndirection = [0, 0, 1]\n'
                                   "events_N = [[0, 1]]\n", r"trunk: s.toml:[23]: there is no region or particle 'liver'; expected"),
                ("binary", b"\x89HDF\r\n\x1a\n\0\0\0\0", "s.toml:.*binary.*expected text")):
            with self.subTest(name):
                self.file("s.toml", text)
                self.assert_refused(says)

    def test_missing_and_unreadable(self):
        self.assert_refused("s.toml: no such file; expected")
        (self.folder / "s.toml").mkdir()
        self.assert_refused("s.toml: this is a directory; expected")
        (self.folder / "s.toml").rmdir()
        rights = self.without_rights()
        (self.folder / self.file("s.toml", scenario_with())).chmod(0)
        self.refused("check", "s.toml", says="s.toml: cannot be opened .Permission denied.*expected", **rights)


class Outputs(TrunkTest):
    def refused_at(self, output, says, **options):
        self.file("t.csv", trace())
        for command in (("simulate", HEALTHY, *COARSE),
                        ("fit", HEALTHY, "--trace", "t.csv", "--set", "time.dt_ms=3", "--max-evaluations", "5")):
            with self.subTest(command[0]):
                self.refused(*command, "-o", output, says=says, **options)

    def test_missing_folder(self):
        self.refused_at("none/r.h5", "none/r.h5: its folder does not exist")
        self.refused_at("t.csv/r.h5", "t.csv/r.h5: .*a file")

    def test_not_a_file(self):
        self.refused_at("/dev/full", "/dev/full: exists and is not a file")
        self.refused_at(".", r"trunk: \.: ")

    def test_read_only_folder(self):
        self.refused_at("/proc/r.h5", "/proc/r.h5: cannot create")
        rights = self.without_rights()
        self.refused_at("r.h5", "r.h5: .*Permission denied", **rights)

    def test_full_disk(self):
        """As reported by the disk, and as `ulimit -f` reports it: with a signal that must not leave a half file."""
        for ignore_signal in (True, False):
            self.refused_at("r.h5", "r.h5(.ledger)?: cannot be written: ", **file_limit(20_000, ignore_signal))

    def test_full_disk_behind_stdout(self):
        """A script that keeps the JSON must not take an empty file for a result."""
        with open("/dev/full", "w") as full:
            done = subprocess.run([PROGRAM, "check", HEALTHY, "--json"], stdout=full, stderr=subprocess.PIPE, timeout=LIMIT_S)
        self.assertNotEqual(done.returncode, 0)


class Results(TrunkTest):
    def setUp(self):
        super().setUp()
        self.succeeds("simulate", HEALTHY, "-o", "r.h5", *COARSE)
        self.data = (self.folder / "r.h5").read_bytes()

    def refuses(self, data, says="x.h5: "):
        self.file("x.h5", data)
        return self.refused("inspect", "x.h5", says=says)

    def test_truncated(self):
        size = len(self.data)
        for part in (1, 100, size // 4, size // 2, size - 5000, size - 1):
            with self.subTest(part):
                self.refuses(self.data[:part])

    def test_foreign(self):
        self.refuses("time_s,volume_ml\n0,1\n", "x.h5: is not an HDF5 file; expected a results file of trunk; it looks like text")
        self.refuses(b"")
        self.refused("inspect", "none.h5", says="none.h5: no such file")
        self.refused("inspect", ".", says=r"trunk: \.: ")

    def flipped(self, place, bit):
        data = bytearray(self.data)
        data[place] ^= 1 << bit
        return bytes(data)

    def test_one_flipped_bit_anywhere_is_seen(self):
        for i in range(60):
            place = i * (len(self.data) - 1) // 59
            with self.subTest(place):
                self.refuses(self.flipped(place, i % 8), "x.h5: is (damaged|not an HDF5 file)")

    @unittest.skipUnless(importlib.util.find_spec("h5py"), "needs python3-h5py")
    def test_flipped_bits_in_numbers_are_seen(self):
        import h5py
        places = {}
        with h5py.File(self.folder / "r.h5") as file:
            for name in ("particles/trajectory/position/value", "curves/dV_model", "particles/trajectory/mass"):
                chunk = file[name].id.get_chunk_info(0)
                places[name] = chunk.byte_offset + chunk.size // 2
            value = file["measures/delta_v_ml"][()].tobytes()
            self.assertEqual(self.data.count(value), 1)
            places["measures/delta_v_ml"] = self.data.find(value) + 6
        for name, place in places.items():
            with self.subTest(name):
                self.refuses(self.flipped(place, 3))

    @unittest.skipUnless(importlib.util.find_spec("h5py"), "needs python3-h5py")
    def test_another_program_s_file(self):
        import h5py
        with h5py.File(self.folder / "x.h5", "w") as file:
            file["velocity"] = [1.0, 2.0]
        self.refused("inspect", "x.h5", says="x.h5: .*expected")
        self.refused("simulate", HEALTHY, "-o", "a.h5", "--from", "x.h5", says="x.h5: .*expected")


if __name__ == "__main__":
    unittest.main()
