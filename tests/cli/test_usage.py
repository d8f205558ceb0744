"""Help, version, wrong words, and JSON that is JSON."""

import re
import unittest

from support import COARSE, HEALTHY, TrunkTest, trace

COMMANDS = ("check", "simulate", "breaths", "fit", "sweep", "status", "merge", "validate", "inspect", "report")


class Help(TrunkTest):
    def test_on_every_level(self):
        top = self.trunk("--help")
        self.assertEqual((top.code, top.err), (0, ""))
        self.assertRegex(top.out, r"Exit codes: 0 .*2 .*3 .*4 ")
        found = re.findall(r"(?m)^  ([a-z]+)  ", top.out.partition("Subcommands:")[2])
        self.assertLessEqual(set(COMMANDS), set(found))
        for command in found:
            for option in ("--help", "-h"):
                with self.subTest(command):
                    shown = self.trunk(command, option)
                    self.assertEqual((shown.code, shown.err), (0, ""))
                    self.assertIn(f"trunk {command}", shown.out)
                    self.assertIn("--json", shown.out)

    def test_version_names_what_made_a_result(self):
        shown = self.trunk("--version")
        self.assertEqual((shown.code, shown.err), (0, ""))
        self.assertRegex(shown.out, r"\Atrunk \d+\.\d+\.\d+ \(([0-9a-f]{12}(, with changes)?|no git)\)\n")
        for library in ("Eigen", "GSL", "HDF5", "NLopt"):
            self.assertRegex(shown.out, rf"(?m)^{library} \d+\.\d+")
        self.assertRegex(shown.out, "GPL-3.0-or-later")

    def test_keys_are_all_usable(self):
        shown = self.trunk("check", "--keys")
        self.assertEqual((shown.code, shown.err), (0, ""))
        keys = re.findall(r"(?m)^  (\S+) .*\[(.*)\]$", shown.out)
        self.assertGreater(len(keys), 25)
        settings = [text for key, value in keys if key != "title" for text in ("--set", f"{key}={value.strip(chr(34))}")]
        self.succeeds("check", HEALTHY, *settings)


class WrongWords(TrunkTest):
    def test_nothing_or_nonsense(self):
        self.refused(says="subcommand")
        self.refused("simulte", HEALTHY, "-o", "r.h5", says="'?simulte'?")
        self.refused("--verbose", says="--verbose")
        for command in COMMANDS:
            with self.subTest(command):
                self.refused(command, "--nonsense", says=r"required|--nonsense")
                self.refused(command, "a", "b", "c", says=r"required|not expected")

    def test_what_is_missing_is_named(self):
        self.refused("simulate", "-o", "r.h5", says="SCENARIO")
        self.refused("simulate", HEALTHY, says="--output")
        self.refused("simulate", HEALTHY, "-o", says="--output")
        self.refused("fit", HEALTHY, "-o", "r.h5", says="--trace FILE or --tidal-volume-ml")
        self.refused("fit", HEALTHY, "--trace", "t.csv", says="--output")
        self.refused("sweep", "s.toml", says="--output")
        self.refused("breaths", says="TRACE")
        self.refused("inspect", says="FILE")
        self.refused("status", says="DIR")
        self.refused("check", says="SCENARIO")
        self.refused("sweep", "s.toml", "-o", "d", "-j", "0", says="--threads")
        self.refused("sweep", "s.toml", "-o", "d", "-j", "many", says="--threads.*many")
        self.refused("fit", HEALTHY, "--tidal-volume-ml", "deep", "-o", "r.h5", says="--tidal-volume-ml.*deep")

    def test_no_json_where_there_is_an_error(self):
        self.refused("simulate", "none.toml", "-o", "r.h5", "--json", says="none.toml")
        self.refused("breaths", "none.csv", "--json", says="none.csv")
        self.refused("inspect", "none.h5", "--json", says="none.h5")
        self.refused("status", "none", "--json", says="none")

    def test_names_with_spaces_and_umlauts(self):
        (self.folder / "Atmung Müller").mkdir()
        self.succeeds("simulate", HEALTHY, "-o", "Atmung Müller/tief und flach.h5", *COARSE)
        self.assertEqual(self.succeeds("inspect", "Atmung Müller/tief und flach.h5")["kind"], "run")


class Json(TrunkTest):
    def commands(self):
        self.file("t.csv", trace())
        self.file("s.toml", f'schema = "trunk.sweep/1"\nscenarios = ["{HEALTHY}"]\n[grid]\n"time.dt_ms" = [3]\n'
                            '"time.duration_s" = [0.3]\n')
        yield "simulate", HEALTHY, "-o", "r.h5", *COARSE
        yield ("fit", HEALTHY, "--trace", "t.csv", "-o", "f.h5", "--set", "time.dt_ms=3", "--fix", "k_elasticity=4000",
               "--timing", "trace", "--surface", "0")
        yield "breaths", "t.csv"
        yield "check", HEALTHY, "--trace", "t.csv"
        yield "sweep", "s.toml", "-o", "d"
        yield "status", "d"
        yield "inspect", "r.h5"
        yield "inspect", "f.h5"
        yield "inspect", "d/sweep.h5"
        yield "report", "r.h5", "-o", "r.html"
        yield "check", "--keys"
        yield "validate",

    def test_one_object_or_a_table(self):
        for command in self.commands():
            with self.subTest(" ".join(command)):
                self.assertRegex(self.succeeds(*command, codes=(0, 4))["schema"], rf"^trunk\.{command[0]}/\d+$")
                again = (*command, "--force") if command[0] in ("simulate", "fit", "sweep", "report") else command
                plain = self.trunk(*again)
                self.assertIn(plain.code, (0, 4), str(plain))
                self.assertNotRegex(plain.out, r"[{}]|\"schema\"")
                self.assertGreater(len(plain.out), 20)
                self.assertNotIn("\x1b", plain.out + plain.err)


if __name__ == "__main__":
    unittest.main()
