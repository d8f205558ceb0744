#!/usr/bin/python3
"""Prints the measures of several run files side by side, with the change from the first to the last.

    scripts/compare_runs.py healthy.h5 paralysed.h5
"""

import argparse
import pathlib
import sys

import h5py

ROWS = [
    ("delta_v_ml", "tidal volume", "ml"),
    ("end_inspiratory_volume_ml", "end-inspiratory volume", "ml"),
    ("excursion_right_mm", "right dome descends", "mm"),
    ("excursion_left_mm", "left dome descends", "mm"),
    ("delta_l_mm", "zone of apposition shortens", "mm"),
    ("delta_h_mm", "domes flatten", "mm"),
    ("delta_r_mm", "zone of apposition widens", "mm"),
    ("abdominal_pressure_peak_cmH2O", "peak abdominal pressure", "cmH2O"),
]


def measures(path):
    try:
        with h5py.File(path) as run:
            return {name: float(value[()]) for name, value in run["measures"].items()}
    except (OSError, KeyError) as error:
        sys.exit(f"{path}: not a run file written by trunk simulate ({error})")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run", nargs="+", type=pathlib.Path, help="run files (HDF5)")
    paths = parser.parse_args().run
    columns = [measures(path) for path in paths]
    width = 2 + max(10, *(len(path.stem) for path in paths))
    print(f"{'':30}" + "".join(f"{path.stem:>{width}}" for path in paths) + f"{'change':>10}")
    for name, label, unit in ROWS:
        values = [round(column[name], 2) + 0.0 for column in columns]  # no -0.00
        change = f"{100 * (values[-1] / values[0] - 1):+9.0f}%" if unit == "ml" else f"{values[-1] - values[0]:+10.2f}"
        print(f"{label:30}" + "".join(f"{value:>{width}.2f}" for value in values) + change + f" {unit}")


if __name__ == "__main__":
    main()
