"""Runs the program as a user does, and makes the traces it reads. Every test works in a folder of its own."""

import hashlib
import json
import os
import re
import resource
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SCENARIOS = ROOT / "scenarios"
NIGHTLY = "TRUNK_NIGHTLY" in os.environ  # scripts/nightly sets it; see tests/CMakeLists.txt
PROGRAM = os.environ.get("TRUNK", str(ROOT / "build" / "trunk"))
SHARED = Path(os.environ.get("TRUNK_SHARED", ROOT.parent / "shared"))
HEALTHY = str(SCENARIOS / "healthy.toml")
NO_LUNG = str(SCENARIOS / "healthy_no_lung.toml")
LIMIT_S = 180  # nothing here may hang, sanitized and beside other work

AT_REST = ("--set", "time.start=rest")  # the default's breathing repeats
# Coarse steps and a short breath: for tests of the program, not of the physics.
COARSE = ("--set", "time.dt_ms=3", "--set", "time.duration_s=0.3", *AT_REST)
FAST_FIT = ("--set", "time.dt_ms=3")
SHORT_BREATH = {"dt_ms": 3, "duration_s": 0.8, "rise_s": 0.4, "fast_fall_s": 0.1, "slow_fall_s": 0.3}


def at_night(test):
    """A test that is too long for the gate: by day it is none, and scripts/nightly runs it."""
    return test if NIGHTLY else None


def shared_file(name):
    """A file of the shared data, or the test is skipped."""
    path = SHARED / "data" / name
    if not path.is_file():
        raise unittest.SkipTest(f"{path} is absent: set TRUNK_SHARED to the folder of shared data")
    return str(path)


def start(*arguments, cwd=None, epoch=None, **options):
    environment = {k: v for k, v in os.environ.items() if k != "SOURCE_DATE_EPOCH"}
    if epoch is not None:
        environment["SOURCE_DATE_EPOCH"] = str(epoch)
    return subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=cwd, env=environment, text=True,
                            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)


def catches(process, sign=signal.SIGINT):
    """Whether the program handles the signal by now (Linux)."""
    try:
        status = Path(f"/proc/{process.pid}/status").read_text()
    except OSError:
        return False
    return bool(int(re.search(r"SigCgt:\s*(\w+)", status)[1], 16) >> (sign - 1) & 1)


def file_limit(most_bytes, ignore_signal):
    """Options of start(): files cannot grow beyond this, as with `ulimit -f`; the stand-in for a full disk."""
    def limit():
        resource.setrlimit(resource.RLIMIT_FSIZE, (most_bytes, most_bytes))
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN if ignore_signal else signal.SIG_DFL)
    return {"preexec_fn": limit}


class Outcome:
    def __init__(self, process):
        try:
            self.out, self.err = process.communicate(timeout=LIMIT_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            raise AssertionError(f"no end within {LIMIT_S} s: {process.args}") from None
        self.code = process.returncode
        self.args = process.args

    def json(self):
        """Stdout is one JSON object and nothing else. NaN is not JSON."""
        def no_constant(text):
            raise AssertionError(f"{text} is not JSON, in the output of {self.args}")
        value = json.loads(self.out, parse_constant=no_constant)
        if not isinstance(value, dict):
            raise AssertionError(f"expected one JSON object, found {type(value)}")
        return value

    def __str__(self):
        return f"{' '.join(self.args)}\nexit {self.code}\nstdout: {self.out}\nstderr: {self.err}"


class TrunkTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="trunk_cli_")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def trunk(self, *arguments, **options):
        return Outcome(start(*arguments, cwd=self.folder, **options))

    def succeeds(self, *arguments, codes=(0,), **options):
        """Runs with --json, checks exit code and stderr, returns the object."""
        outcome = self.trunk(*arguments, "--json", **options)
        self.assertIn(outcome.code, codes, str(outcome))
        for line in outcome.err.splitlines():
            self.assertTrue(line.startswith("note: "), str(outcome))
        self.assert_no_part()
        return outcome.json()

    def refused(self, *arguments, says=(), code=2, after_notes=False, **options):
        """One line on stderr that holds all of `says` (regular expressions), nothing on stdout, nothing written. Notes
        about the input may stand before it if `after_notes`."""
        before = self.contents()
        outcome = self.trunk(*arguments, **options)
        self.assertEqual(outcome.code, code, str(outcome))
        if after_notes:
            self.assertRegex(outcome.err, r"\Anote: ")
            outcome.err = re.sub(r"\A(note: [^\n]*\n)+", "", outcome.err)
        self.assert_one_line(outcome)
        self.assertEqual(outcome.out, "", str(outcome))
        for pattern in [says] if isinstance(says, str) else says:
            self.assertRegex(outcome.err, pattern)
        self.assertEqual(self.contents(), before, "something was written")
        return outcome.err

    def assert_one_line(self, outcome):
        self.assertRegex(outcome.err, r"\Atrunk: [^\n\r]{10,}\n\Z", str(outcome))
        self.assertNotRegex(outcome.err, r"(?i)terminate called|what\(\)|\bstd::|toml::|traceback|\x1b", str(outcome))

    def assert_no_part(self):
        self.assertEqual([str(p) for p in self.folder.rglob("*.part")], [])

    def contents(self):
        """Every file below the folder, by content and place on the disk."""
        return {str(p): (p.stat().st_ino, p.stat().st_mtime_ns,
                         hashlib.sha256(p.read_bytes()).hexdigest() if p.is_file() else None)
                for p in sorted(self.folder.rglob("*"))}

    def file(self, name, text):
        path = self.folder / name
        if isinstance(text, bytes):
            path.write_bytes(text)
        else:
            path.write_text(text, encoding="utf-8")
        return path.name

    def without_rights(self):
        """Options of start() under which file permissions count, for root too."""
        if os.geteuid() != 0:
            return {}
        self.folder.chmod(0o755)
        options = {"user": 65534, "group": 65534, "extra_groups": []}
        try:
            if self.trunk("check", HEALTHY, **options).code == 0:
                return options
        except OSError:
            pass
        raise unittest.SkipTest("runs as root, and nobody may not run the program")

    def interrupt(self, process, ready, sign=signal.SIGINT):
        """Sends the signal as soon as ready() holds; the program must still be at work then."""
        deadline = time.monotonic() + LIMIT_S
        while not ready() and process.poll() is None and time.monotonic() < deadline:
            time.sleep(0.002)
        self.assertIsNone(process.poll(), "the program ended before it could be interrupted")
        process.send_signal(sign)
        return Outcome(process)


def breaths(count=5, period_s=1.5, inspiration_s=0.6, tidal_ml=500.0, rate_hz=100.0, tau_s=0.15, tail_s=0.0):
    """(times s, volumes ml) of the one-compartment model tau dV/dt + V = drive(t), scaled to the tidal volume:
    the drive rises linearly over the inspiration and is off after it. Written apart from the program's own."""
    substeps, times, volumes, volume = 20, [], [], 0.0
    for sample in range(round((count * period_s + tail_s) * rate_hz) + 1):
        times.append(sample / rate_hz)
        volumes.append(volume)
        for part in range(substeps):
            t = (sample + part / substeps) / rate_hz
            phase = t % period_s
            drive = phase / inspiration_s if phase < inspiration_s and t < count * period_s else 0.0
            volume += (drive - volume) / (tau_s * rate_hz * substeps)
    highest = max(volumes)
    return times, [tidal_ml * v / highest for v in volumes]


def csv(times, volumes, header="time_s,volume_ml", separator=",", comma=False, factor=1.0, time_factor=1.0):
    rows = [f"{t * time_factor:.4f}{separator}{v * factor:.4f}" for t, v in zip(times, volumes)]
    text = "\n".join(rows)
    return header + "\n" + (text.replace(".", ",") if comma else text) + "\n"


def trace(**options):
    return csv(*breaths(**options))


def scenario_with(values=SHORT_BREATH):
    """healthy.toml as text with the values of some keys replaced."""
    text = Path(HEALTHY).read_text(encoding="utf-8")
    for key, value in values.items():
        text, found = re.subn(rf"(?m)^{key} = [^#\n]*", f"{key} = {value}  ", text)
        if found != 1:
            raise AssertionError(f"{key} is not in healthy.toml")
    return text


def coarse_run():
    """The file of a short run, for tests that change or read it many times."""
    maker = TrunkTest()
    maker.setUp()
    try:
        maker.succeeds("simulate", HEALTHY, "-o", "r.h5", *COARSE)
        return (maker.folder / "r.h5").read_bytes()
    finally:
        maker.doCleanups()
