"""Help, version, wrong words, and JSON that is JSON."""

import re
import shutil
import subprocess
import unittest

from support import COARSE, HEALTHY, LIMIT_S, NIGHTLY, PROGRAM, ROOT, TrunkTest, trace

COMMANDS = ("check", "simulate", "breaths", "fit", "sweep", "status", "merge", "validate", "inspect", "report",
            "export", "register", "compare", "diff", "replay")
TOPICS = {"start": "README.md", "fitting": "fit/README.md", "pressures": "fit/channels/README.md",
          "sweeps": "fit/sweep/README.md", "structure": "fit/structure/README.md",
          "scenarios": "scenarios/README.md", "model": "libtrunk/README.md", "results": "libtrunk/io/README.md",
          "registration": "libtrunk/registration/README.md", "evidence": "reference/README.md",
          "tests": "tests/README.md", "scripts": "scripts/README.md", "contributing": ".github/CONTRIBUTING.md"}


def labels(help_text):
    """Every option or argument of a help, as (names, value or None)."""
    part = help_text.partition("\nArguments:")[2] or help_text.partition("\nOptions:")[2]
    part = part.partition("\nExample")[0].partition("\nTopics,")[0]
    found = []
    for label in re.findall(r"(?m)^  (-{0,2}[A-Za-z]\S*(?: \S+)*?)(?:  .*)?$", part):
        names = re.findall(r"(?:^|, )(-{0,2}[\w-]+)", label)
        value = re.search(r"(?<!,) (\S+)$", label)
        found.append((names, value and value[1]))
    return found


class Help(TrunkTest):
    def test_on_every_level(self):
        top = self.trunk("--help")
        self.assertEqual((top.code, top.err), (0, ""))
        self.assertRegex(top.out, r"Exit codes:\n  0 .*(\n.*)*\n  2 .*(\n.*)*\n  3 .*(\n.*)*\n  4 ")
        found = re.findall(r"(?m)^  ([a-z]+)  ", top.out.partition("\nOptions:")[0])
        self.assertEqual(set(found), {*COMMANDS, "help"})
        for command in found:
            for option in ("--help", "-h"):
                with self.subTest(command):
                    shown = self.trunk(command, option)
                    self.assertEqual((shown.code, shown.err), (0, ""))
                    self.assertTrue(shown.out.startswith(f"Usage: trunk {command}"), shown.out)
                    self.assertIn("--json" if command != "help" else "--man", shown.out)

    def test_help_of_a_command_is_its_help_option(self):
        self.assertEqual(self.trunk("help").out, self.trunk("--help").out)
        for command in (*COMMANDS, "help"):
            shown = self.trunk("help", command)
            self.assertEqual((shown.code, shown.err), (0, ""))
            self.assertEqual(shown.out, self.trunk(command, "--help").out)

    def test_lines_fit_a_terminal(self):
        for command in ((), *((name,) for name in (*COMMANDS, "help"))):
            for line in self.trunk(*command, "--help").out.splitlines():
                self.assertLessEqual(len(line), 80, line)

    def test_examples_name_options_that_exist(self):
        for command in COMMANDS:
            shown = self.trunk(command, "--help").out
            for example in re.findall(r"(?m)^  trunk (.*)$", shown):
                with self.subTest(example):
                    name, *words = example.split()
                    self.assertEqual(name, command)
                    known = {known for names, _ in labels(shown) for known in names}
                    self.assertLessEqual({word for word in words if re.match("--?[a-z]", word)}, known)

    def test_topics_are_the_pages_word_for_word(self):
        listed = re.findall(r"(?m)^  ([a-z]+)  ", self.trunk("help").out.partition("\nTopics,")[2])
        self.assertEqual(listed, list(TOPICS))
        for topic, page in TOPICS.items():
            with self.subTest(topic):
                shown = self.trunk("help", topic)
                self.assertEqual((shown.code, shown.err), (0, ""))
                self.assertEqual(shown.out, (ROOT / page).read_text(encoding="utf-8"))

    def test_every_page_of_the_front_page_is_a_topic(self):
        table = (ROOT / "README.md").read_text(encoding="utf-8").partition("| page | topic |")[2]
        rows = dict(re.findall(r"(?m)^\| \[[^\]]+\]\(([^)]+)\) \| `([a-z]+)` \|", table))
        self.assertEqual({topic: page for page, topic in rows.items()} | {"start": "README.md"}, TOPICS)

    def test_help_needs_no_file_beside_the_program(self):
        shutil.copy2(PROGRAM, self.folder / "alone")
        shown = subprocess.run([self.folder / "alone", "help", "fitting"], cwd=self.folder, capture_output=True,
                               text=True, timeout=LIMIT_S)
        self.assertEqual((shown.returncode, shown.stderr), (0, ""))
        self.assertEqual(shown.stdout, (ROOT / "fit/README.md").read_text(encoding="utf-8"))

    def test_help_says_when_it_cannot_be_written(self):
        for arguments in (("help",), ("--help",), ("fit", "--help"), ("help", "start"), ("--version",)):
            with open("/dev/full", "w") as full:
                done = subprocess.run([PROGRAM, *arguments], stdout=full, stderr=subprocess.PIPE, text=True,
                                      timeout=LIMIT_S)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertRegex(done.stderr, r"\Atrunk: standard output: [^\n]*disk[^\n]*\n\Z")

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


class Manual(TrunkTest):
    def manual(self):
        shown = self.trunk("help", "--man")
        self.assertEqual((shown.code, shown.err), (0, ""))
        return shown.out

    def test_every_command_and_option_is_in_it(self):
        sections = re.split(r"(?m)^\.SS trunk ", self.manual().replace("\\-", "-"))[1:]
        by_command = {section.split()[0]: section for section in sections}
        self.assertEqual(set(by_command), {*COMMANDS, "help"})
        for command, section in by_command.items():
            shown = labels(self.trunk(command, "--help").out)
            self.assertGreater(len(shown), 1)
            entries = re.findall(r"(?m)^\.TP\n(.*)$", section)
            self.assertEqual([re.findall(r"\\fB([\w-]+)\\fR", entry) for entry in entries],
                             [names for names, _ in shown], command)
            self.assertEqual([(re.findall(r"\\fI(.*)\\fR", entry) or [None])[0] for entry in entries],
                             [value for _, value in shown], command)

    def test_values_stand_whole(self):
        """Help and page come from one table, so they cannot show each other's mistakes."""
        shown = self.trunk("fit", "--help").out
        for text in ("--prior NAME=MEAN:FACTOR", "--fix NAME=VALUE|NAME=@FILE", "--loss squares|huber|student"):
            self.assertIn(text, shown)

    def test_it_is_a_manual_page(self):
        text = self.manual()
        self.assertTrue(text.startswith('.TH TRUNK 1 '))
        for section in ("NAME", "SYNOPSIS", "DESCRIPTION", "OPTIONS", "COMMANDS", "NOTES"):
            self.assertIn(f"\n.SH {section}\n", text)
        requests = set(re.findall(r"(?m)^[.'](\w*)", text))
        self.assertEqual(requests, {"TH", "SH", "SS", "TP", "PP", "nf", "fi", "ad", "nh"})
        self.assertEqual(len(re.findall(r"(?m)^\.nf$", text)), len(re.findall(r"(?m)^\.fi$", text)))

    @unittest.skipUnless(shutil.which("groff"), "groff is not installed")
    def test_groff_has_no_warning(self):
        done = subprocess.run(["groff", "-man", "-Tutf8", "-ww"], input=self.manual(), capture_output=True, text=True,
                              timeout=LIMIT_S)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("TRUNK(1)", done.stdout)


class Completion(TrunkTest):
    def script(self, shell):
        shown = self.trunk("help", "--completion", shell)
        self.assertEqual((shown.code, shown.err), (0, ""))
        return shown.out

    def completed(self, *words):
        """What bash offers for the last of the words."""
        self.file("trunk.bash", self.script("bash"))
        line = " ".join(f"'{word}'" for word in ("trunk", *words))
        done = subprocess.run(["bash", "-c", f"source ./trunk.bash; COMP_WORDS=({line}); COMP_CWORD={len(words)}; "
                               '_trunk; printf "%s\\n" "${COMPREPLY[@]}"'], cwd=self.folder, capture_output=True,
                              text=True, timeout=LIMIT_S)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return done.stdout.split()

    def test_bash_completes(self):
        self.assertEqual(self.completed("sim"), ["simulate"])
        self.assertEqual(set(self.completed("")), {*COMMANDS, "help", "--help", "-h", "--version"})
        self.assertEqual(self.completed("fit", "--algo"), ["--algorithm"])
        self.assertEqual(set(self.completed("fit", "--loss", "")), {"squares", "huber", "student"})
        self.assertEqual(set(self.completed("help", "fi")), {"fit", "fitting"})
        self.assertEqual(set(self.completed("help", "--completion", "")), {"bash", "zsh", "fish"})
        self.assertEqual(self.completed("fit", "--trace", "--"), [], "a value is no option")
        self.assertEqual(self.completed("inspect", ""), [], "bash offers files")

    def test_bash_knows_every_option(self):
        for command in (*COMMANDS, "help"):
            shown = labels(self.trunk(command, "--help").out)
            options = [name for names, _ in shown for name in names if name.startswith("-")]
            self.assertEqual(self.completed(command, "-"), options, command)

    def test_zsh_and_fish_know_every_option(self):
        zsh, fish = self.script("zsh"), self.script("fish")
        self.assertTrue(zsh.startswith("#compdef trunk\n"))
        for command in (*COMMANDS, "help"):
            of_zsh = re.search(rf"(?m)^        {command}\) _arguments((?:.*\\\n)*.*) ;;$", zsh)[1]
            of_fish = "\n".join(re.findall(rf"(?m)^.*_from {command}'(.*)$", fish))
            for names, value in labels(self.trunk(command, "--help").out):
                for name in (name for name in names if name.startswith("-")):
                    with self.subTest(f"{command} {name}"):
                        end = "" if value is None else "=" if name.startswith("--") else r"\+"
                        self.assertRegex(of_zsh, rf"'\*?{name}{end}\[")
                        self.assertRegex(of_fish, rf" -l {name[2:]} " if name.startswith("--") else f" -s {name[1]} ")

    def test_other_shells_read_their_scripts(self):
        for shell in ("zsh", "fish"):
            with self.subTest(shell):
                if not shutil.which(shell):
                    self.skipTest(f"{shell} is not installed")
                done = subprocess.run([shell, "-n", self.folder / self.file(f"trunk.{shell}", self.script(shell))],
                                      capture_output=True, text=True, timeout=LIMIT_S)
                self.assertEqual((done.returncode, done.stderr), (0, ""), shell)


class WrongWords(TrunkTest):
    def test_nothing_or_nonsense(self):
        self.refused(says=("no command is given; expected one of check, ", "trunk --help"))
        self.refused("orchestra", HEALTHY, says=("unknown command 'orchestra'; expected one of check, .* validate",
                                                 "see `trunk --help`"))
        self.refused("--verbose", says="unknown option '--verbose' of `trunk`; see `trunk --help`")
        self.refused("help", "orchestra", says=("unknown command or topic 'orchestra'", "expected one of .* evidence"))
        for command in (*COMMANDS, "help"):
            with self.subTest(command):
                self.refused(command, "--nonsense",
                             says=f"unknown option '--nonsense' of `trunk {command}`; see `trunk {command} --help`")
                self.refused(command, "a", "b", "c", says=r"required|not expected")

    def test_a_misspelt_word_names_the_nearest(self):
        for typed, meant in (("simluate", "simulate"), ("simulte", "simulate"), ("chekc", "check"), ("ft", "fit"),
                             ("replays", "replay"), ("hlep", "help")):
            said = self.refused(typed, HEALTHY, "-o", "r.h5")
            self.assertEqual(said, f"trunk: unknown command '{typed}'; did you mean '{meant}'?\n")
        self.assertEqual(self.refused("help", "fiting"),
                         "trunk: unknown command or topic 'fiting'; did you mean 'fitting'?\n")
        self.refused("--vrsion", says="unknown option '--vrsion' of `trunk`; did you mean '--version'?")
        self.refused("fit", "--alogrithm", "lm", says="'--alogrithm' of `trunk fit`; did you mean '--algorithm'")
        self.refused("fit", "--alogrithm=lm", says="'--alogrithm' of `trunk fit`; did you mean '--algorithm'")
        self.refused("--json", "fit", says="'--json' stands before the command; write it .* `trunk fit --json`")

    def test_every_option_of_every_command_is_found_when_misspelt(self):
        for command in (*COMMANDS, "help"):
            known = [name for names, _ in labels(self.trunk(command, "--help").out) for name in names]
            for name in [name for name in known if name.startswith("--")][::1 if NIGHTLY else 6]:
                typed = name + "e"
                if typed not in known:
                    with self.subTest(f"{command} {typed}"):
                        said = self.trunk(command, typed)
                        self.assertEqual((said.code, said.out), (2, ""))
                        self.assertEqual(said.err, f"trunk: unknown option '{typed}' of `trunk {command}`; "
                                                   f"did you mean '{name}'?\n")

    def test_contradictions_are_named(self):
        self.refused("breaths", "t.csv", "--flow", "a", "--volume", "b",
                     says="--flow and --volume cannot be used together; see `trunk breaths --help`")
        self.refused("help", "fit", "--man", says="SUBJECT and --man cannot be used together")
        self.refused("report", "r.h5", "-o", "r.html", "--align", says="--align requires --surface")
        self.refused("export", "r.h5", says="expected --csv DIR, --vtk DIR or --pml DIR")

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
        self.refused("breaths", "t.csv", "--rate", "nan", says="--rate: 'nan' found; expected a number from")
        self.refused("diff", "a.h5", "b.h5", "--absolute", "-1", says="--absolute: '-1' found; expected a number, 0 or")
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
