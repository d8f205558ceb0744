"""The study scripts share this: options, the program as a function, and the output."""

import argparse
import concurrent.futures
import contextlib
import csv
import itertools
import json
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]


def options(settings):
    """Returns settings, a dictionary by key, as words of a command line."""
    return [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]


class Program:
    """Runs `trunk` in a folder. A simulation that fails gives a status and no exception."""

    def __init__(self, path, folder):
        self.path, self.folder = path, pathlib.Path(folder)
        self.count = itertools.count()

    def __call__(self, *arguments):
        """Returns the JSON that the program prints, or None, and a status."""
        output = self.folder / f"{next(self.count)}.h5"
        done = subprocess.run([self.path, *map(str, arguments), "-o", output, "--json"], capture_output=True, text=True)
        output.unlink(missing_ok=True)
        if done.returncode == 0:
            return json.loads(done.stdout), "completed"
        if done.returncode == 3:
            return None, "diverged or not converged"
        if "cannot repeat" in done.stderr:
            return None, "breathing cannot repeat"
        if "step" in done.stderr:
            return None, "time step unstable"
        sys.exit(f"{' '.join(map(str, done.args))}: exit {done.returncode}: {done.stderr.strip()}")


def study_parser(description, output="DIR", output_help="folder for the results"):
    """Returns a parser with the options of every study."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True, metavar=output, help=output_help)
    parser.add_argument("--trunk", type=pathlib.Path, default=ROOT / "build" / "trunk",
                        help="the program [build/trunk]")
    parser.add_argument("-j", "--jobs", type=int, default=os.cpu_count(), metavar="N", help="at once [one per core]")
    return parser


def parsed(parser):
    """Returns the arguments; ends with a message if the program does not exist."""
    arguments = parser.parse_args()
    if not os.access(arguments.trunk, os.X_OK):
        parser.error(f"{arguments.trunk} is not a program; build it, or name it by --trunk")
    if arguments.jobs < 1:
        parser.error("--jobs must be 1 or more")
    arguments.trunk = arguments.trunk.resolve()
    return arguments


@contextlib.contextmanager
def workbench(arguments):
    """Gives the program in a temporary folder, and a pool of --jobs threads."""
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        yield Program(arguments.trunk, folder), pool


def write_study(arguments, name, columns, rows, plot, markdown):
    """Writes all runs to NAME.csv, plots NAME.png unless the study is a quick one, and prints the Markdown tables."""
    arguments.output.mkdir(parents=True, exist_ok=True)
    write_csv(arguments.output / f"{name}.csv", columns, rows)
    if not arguments.quick:
        plot(rows, arguments.output / f"{name}.png")
    print(markdown(rows))


def write_csv(path, columns, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, columns, lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({c: f"{v:.5g}" if isinstance(v := row[c], float) else v for c in columns})
