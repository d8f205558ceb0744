#!/usr/bin/env python3
"""Prints the slowest units and tests of build folders, and every skipped test with its reason.

    scripts/test_summary.py BUILD...

Units are read from Ninja's log, tests from CTest's. Times are wall times: two jobs that run side by side each count."""

import re
import sys
from pathlib import Path

MOST = 10
TEST = re.compile(r"^\d+/\d+ Test: (\S+)\n(.*?)^Test time = +([\d.]+) sec", re.M | re.S)
SKIPPED_METHOD = re.compile(r"^(test\w+) \(\S+\)(?:\n.*)? \.\.\. skipped [\"'](.*)[\"']$", re.M)
SKIPPED_CLASS = re.compile(r"^setUpClass \((\S+)\) \.\.\. skipped [\"'](.*)[\"']$", re.M)


def units(folder):
    """(seconds, output) of the last build of every output."""
    log = folder / ".ninja_log"
    took = {}
    for line in log.read_text().splitlines()[1:] if log.exists() else []:
        begin_ms, end_ms, _, output, _ = line.split("\t")
        took[output] = (int(end_ms) - int(begin_ms)) / 1000
    return [(seconds, f"{folder}/{output}") for output, seconds in took.items() if output.endswith(".o")]


def tests(folder):
    """(seconds, name, output) of every test of the last call of CTest."""
    log = folder / "Testing/Temporary/LastTest.log"
    text = log.read_text(errors="replace") if log.exists() else ""
    return [(float(seconds), name, output) for name, output, seconds in TEST.findall(text)]


def skips(name, output):
    """A line for every skipped test in the output of one CTest test."""
    found = SKIPPED_METHOD.findall(output) + SKIPPED_CLASS.findall(output)
    if not found and re.search(r"OK \(skipped=", output):
        found = [("all", "see its log")]
    return [f"{name}: {method}: {reason}" for method, reason in found]


def print_slowest(title, rows):
    print(f"\n== {title}")
    for seconds, name in sorted(rows, reverse=True)[:MOST]:
        print(f"{seconds:7.1f} s  {name}")


def main():
    folders = [Path(argument) for argument in sys.argv[1:]]
    if not folders:
        sys.exit(__doc__)
    print_slowest("The slowest units", [row for folder in folders for row in units(folder)])
    ran = [(folder, *test) for folder in folders for test in tests(folder)]
    print_slowest("The slowest tests", [(seconds, f"{folder}: {name}") for folder, seconds, name, _ in ran])
    skipped = [f"{folder}: {line}" for folder, _, name, output in ran for line in skips(name, output)]
    skipped += [f"{folder}: {name}: the shared data are absent" for folder, _, name, output in ran
                if name.startswith("shared_") and not re.search(r"test cases?:|All tests passed", output)]
    print("\n== Skipped tests" if skipped else "\n== No test was skipped")
    print("\n".join(skipped))


if __name__ == "__main__":
    main()
