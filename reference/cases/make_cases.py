#!/usr/bin/python3
"""Makes the traces of reference/cases: breaths of the simulator itself, with noise from a seeded generator.

    reference/cases/make_cases.py build/trunk

The parameters put in are the expected ones of cases.json, which is written by hand.
"""
import json
import random
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
SCENARIOS = HERE.parents[1] / "scenarios"
RATE_HZ, BREATHS, NOISE_ML = 25, 6, 5.0


def breath(trunk, settings, duration_s):
    """Lung volume over one breath, ml, every 1/RATE_HZ s."""
    with tempfile.TemporaryDirectory() as folder:
        run = Path(folder) / "run.h5"
        options = [part for setting in settings for part in ("--set", setting)]
        subprocess.run([trunk, "simulate", SCENARIOS / "healthy_no_lung.toml", "-o", run, "--set",
                        f"time.duration_s={duration_s}", *options, "--json"], check=True, capture_output=True)
        import h5py
        with h5py.File(run) as file:
            time, volume = file["curves/time"][:], file["curves/dV_model"][:]
    step = 1 / (RATE_HZ * (time[1] - time[0]))
    return [volume[round(i * step)] for i in range(round(duration_s * RATE_HZ))]


def main():
    trunk = sys.argv[1]
    for case in json.loads((HERE / "cases.json").read_text())["cases"]:
        made = case["made_with"]
        one = breath(trunk, made["settings"], made["duration_s"])
        numbers = random.Random(made["seed"])
        rows = [f"{i / RATE_HZ:.2f},{one[i % len(one)] + numbers.gauss(0, NOISE_ML):.2f}"
                for i in range(BREATHS * len(one))]
        (HERE / case["trace"]).write_text("time_s,volume_ml\n" + "\n".join(rows) + "\n")


main()
