"""Runs the benchmark programs side by side and reports medians.

All cases are timed in turn, again and again, so that a slow minute of the machine meets all of them alike; what is
compared is measured in the same turn. Times are of the work alone: no start-up, no files.
"""

import argparse
import datetime
import json
import os
import platform
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
PROGRAM = ROOT / "build" / "trunk_bench"
PEERS = {name: ROOT / "build" / f"bench_{name}" for name in ("bullet_float", "bullet_double")}
CONSERVATION = ("1e8", "3e8", "1e9")  # Bullet's kVC; above about 1.2e9 it diverges
FINEST = 9  # resolution of the mesh of about 10,000 particles


class Server:
    """A benchmark program: answers the name of a case with what it measured."""

    def __init__(self, path):
        self.process = subprocess.Popen([path], cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def __call__(self, case):
        self.process.stdin.write(case + "\n")
        self.process.stdin.flush()
        line = self.process.stdout.readline()
        if not line:
            sys.exit(f"{self.process.args[0]} ended in '{case}'")
        return json.loads(line)

    def close(self):
        self.process.stdin.close()
        self.process.wait()


def median_ms(answers):
    return statistics.median(answer["ms"] for answer in answers)


def measure(repeats):
    """All answers by (program, case)."""
    ours = Server(PROGRAM)
    peers = {name: Server(path) for name, path in PEERS.items() if path.exists()}
    kernels = ours("kernels")["kernels"]
    turns = [(ours, "trunk", case) for case in ("breath", "no_air", "air", "auto_breath", "batch", "auto_batch", "fit",
                                                "auto_fit")]
    turns += [(ours, "trunk", f"{what} {kernel}") for kernel in kernels for what in ("one", "lanes", "derivatives")]
    turns += [(ours, "trunk", f"mesh {resolution}") for resolution in (1, 2, 4, FINEST)]
    turns += [(server, name, factor) for name, server in peers.items() for factor in CONSERVATION]
    answers = {}
    for server, _, case in turns:
        server(case)  # warm
    for repeat in range(repeats):
        for server, name, case in turns:
            server(case)  # what ran before has left its own data in the caches
            answers.setdefault((name, case), []).append(server(case))
        if sys.stderr.isatty():
            print(f"\r{repeat + 1} of {repeats}", end="", file=sys.stderr)
    accuracy = ours("accuracy")
    for server in (ours, *peers.values()):
        server.close()
    return answers, accuracy, kernels


def instructions_per_step():
    """Of one breath with the best kernel that valgrind knows (it has no AVX-512), start-up taken away."""
    if not shutil.which("valgrind"):
        return None

    def count(*cases):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out", PROGRAM, *cases],
                                  cwd=ROOT, capture_output=True, text=True, check=True)
        return int(re.search(r"refs:\s+([\d,]+)", done.stderr).group(1).replace(",", ""))

    return round((count("breath", "breath", "breath") - count("breath")) / (2 * 4500))


def summary(answers, accuracy, counted):
    ms = {key: median_ms(found) for key, found in answers.items()}
    last = {key: found[-1] for key, found in answers.items()}

    def rate(case, count="breaths"):
        return 1e3 * last["trunk", case][count] / ms["trunk", case]

    def per_particle(case):
        return ms["trunk", case] / (last["trunk", case]["steps"] * last["trunk", case]["particles"])

    result = {
        "breath_ms": ms["trunk", "breath"],
        "lung_ratio": ms["trunk", "air"] / ms["trunk", "no_air"],
        "auto_breath_ms": ms["trunk", "auto_breath"],
        "auto_dt_ms": last["trunk", "auto_breath"]["dt_ms"],
        "batch_breaths_per_s": rate("auto_batch"),
        "batch_1ms_breaths_per_s": rate("batch"),
        "fit_ms": ms["trunk", "auto_fit"],
        "fit_evaluations": last["trunk", "auto_fit"]["evaluations"],
        "fit_1ms_ms": ms["trunk", "fit"],
        "per_particle_ratio_10k": per_particle(f"mesh {FINEST}") / per_particle("mesh 1"),
        "finest_particles": last["trunk", f"mesh {FINEST}"]["particles"],
        "instructions_per_step": counted,
        "volume_error": accuracy["volume_error"],
        "auto_delta_v_error_percent": accuracy["auto_delta_v_error_percent"],
    }
    for name in PEERS:
        found = [key for key in ms if key[0] == name]
        result[f"{name}_ms"] = min((ms[key] for key in found), default=None)
    errors = [last[key]["volume_error"] for key in last if key[0] in PEERS]
    result["bullet_volume_error"] = min(errors, default=None)
    for name in PEERS:
        peer = result[f"{name}_ms"]
        result[f"ratio_vs_{name}"] = peer / result["breath_ms"] if peer else None
    result["cases_ms"] = {f"{name} {case}": value for (name, case), value in ms.items()}
    return result


def machine():
    name = platform.processor() or platform.machine()
    if (info := Path("/proc/cpuinfo")).exists():
        name = next((line.split(":", 1)[1].strip() for line in info.read_text().splitlines()
                     if line.startswith("model name")), name)
    return f"{name}, {os.cpu_count()} cores"


def table(r):
    def ms(value):
        return "not measured" if value is None else f"{value:.1f} ms"

    rows = [
        ("one breath, 4500 steps of 1 ms, 113 particles, one core", ms(r["breath_ms"])),
        ("a breath with lung and airway over one without", f"{r['lung_ratio']:.2f}"),
        ("the same size in Bullet 3.24's soft body, float", ms(r["bullet_float_ms"])),
        ("the same size in Bullet 3.24's soft body, double", ms(r["bullet_double_ms"])),
        ("largest relative volume error: trunk, Bullet at its best",
         f"{r['volume_error']:.1g}, " + ("not measured" if r["bullet_volume_error"] is None else f"{r['bullet_volume_error']:.1g}")),
        (f"one breath, dt = auto ({r['auto_dt_ms']:g} ms; ΔV within {r['auto_delta_v_error_percent']:.2g} % of 0.25 ms)",
         ms(r["auto_breath_ms"])),
        ("batch, all cores: dt = auto, 1 ms",
         f"{r['batch_breaths_per_s']:.0f}, {r['batch_1ms_breaths_per_s']:.0f} breaths/s"),
        (f"fit of two parameters to 1e-6, dt = auto ({r['fit_evaluations']} evaluations)", ms(r["fit_ms"])),
        (f"a particle's step at {r['finest_particles']} particles over one at 113", f"{r['per_particle_ratio_10k']:.2f}"),
        ("instructions a step (AVX2)", "not measured" if r["instructions_per_step"] is None else f"{r['instructions_per_step']:,}"),
    ]
    return "\n".join(["| what | median |", "|---|---|", *(f"| {what} | {value} |" for what, value in rows)])


def main():
    parser = argparse.ArgumentParser(prog="scripts/bench", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--repeats", type=int, default=9, help="turns, of which the medians are taken [9]")
    parser.add_argument("--json", metavar="FILE", help="write all figures here")
    parser.add_argument("--no-count", action="store_true", help="do not count instructions (takes about a minute)")
    options = parser.parse_args()
    answers, accuracy, kernels = measure(max(1, options.repeats))
    result = summary(answers, accuracy, None if options.no_count else instructions_per_step())
    result |= {"machine": machine(), "date": datetime.date.today().isoformat(), "kernels": kernels,
               "repeats": options.repeats}
    if options.json:
        Path(options.json).write_text(json.dumps(result, indent=2) + "\n")
    print(f"{result['machine']}, {result['date']}, medians of {options.repeats} interleaved repeats\n\n{table(result)}")


if __name__ == "__main__":
    main()
