"""What the study scripts share: the program as a function, and tables as CSV."""

import csv
import itertools
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]


def options(settings):
    """Settings, a dictionary by key, as words of a command line."""
    return [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]


class Program:
    """`trunk` in a folder of its own; every failure is a word of status, never an exception."""

    def __init__(self, path, folder):
        self.path, self.folder = path, pathlib.Path(folder)
        self.count = itertools.count()

    def __call__(self, *arguments):
        """What it prints as JSON, or None, and a status."""
        output = self.folder / f"{next(self.count)}.h5"
        done = subprocess.run([self.path, *map(str, arguments), "-o", output, "--json"], capture_output=True, text=True)
        output.unlink(missing_ok=True)
        if done.returncode == 0:
            return json.loads(done.stdout), "completed"
        if done.returncode == 3:
            return None, "diverged or not converged"
        if "step" in done.stderr:
            return None, "time step unstable"
        sys.exit(f"{' '.join(map(str, done.args))}: exit {done.returncode}: {done.stderr.strip()}")


def add_program_options(parser):
    parser.add_argument("--trunk", type=pathlib.Path, default=ROOT / "build" / "trunk",
                        help="the program [build/trunk]")
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count(), metavar="N", help="at once [one a core]")


def parsed(parser):
    arguments = parser.parse_args()
    if not os.access(arguments.trunk, os.X_OK):
        parser.error(f"{arguments.trunk} is not a program; build it, or name it by --trunk")
    if arguments.jobs < 1:
        parser.error("--jobs must be 1 or more")
    arguments.trunk = arguments.trunk.resolve()
    return arguments


def write_csv(path, columns, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({c: f"{v:.5g}" if isinstance(v := row[c], float) else v for c in columns})
