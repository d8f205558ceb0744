#!/usr/bin/python3
"""Plots the trunk cut open from side to side, at rest and at end-inspiration, one picture for each run, like the last
figures of Promayon and Baconnier (2008): a paralysed side rises while the other descends.

    scripts/plot_shapes.py healthy.h5 paralysed.h5 -o shapes.png
"""

import argparse
import pathlib

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)
from matplotlib.collections import LineCollection  # noqa: E402

# Colour-blind readers can distinguish Okabe and Ito's palette; line styles differ as well.
BLUE, ORANGE, GREY = "#0072B2", "#D55E00", "#999999"
CM = 100.0


def section(points, triangles, y):
    """Returns the segments in which triangles cross the plane y, [n, 2, (x, z)] in cm."""
    segments = []
    for a, b, c in points[triangles]:
        crossing = [p + (q - p) * (y - p[1]) / (q[1] - p[1]) for p, q in ((a, b), (b, c), (c, a))
                    if (p[1] < y) != (q[1] < y)]
        if len(crossing) == 2:
            segments.append([point[[0, 2]] for point in crossing])
    return CM * np.array(segments).reshape(-1, 2, 2)


def plot_run(path, axes):
    with h5py.File(path) as run:
        frames, volume = run["particles/trajectory/position/value"], run["observables/dV/value"][()]
        rest, inspired = frames[0], frames[int(volume.argmax())]
        triangles = run["connectivity/triangles"][()]
        lung = run["connectivity/triangle_component"][()] == 1
        right, left = (run[f"measures/excursion_{side}_mm"][()] for side in ("right", "left"))
        tidal = run["measures/delta_v_ml"][()]
    y = 0.5 * (rest[:, 1].min() + rest[:, 1].max()) + 1e-6  # not through a particle
    for chosen, color in ((~lung, ORANGE), (lung, BLUE)):
        axes.add_collection(LineCollection(section(rest, triangles[chosen], y), colors=GREY, linewidths=1,
                                           linestyles=":"))
        axes.add_collection(LineCollection(section(inspired, triangles[chosen], y), colors=color, linewidths=1.8))
    for name, color, style in (("lung, end-inspiration", BLUE, "-"), ("abdomen, end-inspiration", ORANGE, "-"),
                               ("at rest", GREY, ":")):
        axes.plot([], [], color=color, ls=style, label=name)
    axes.set(title=f"{path.stem}: ΔV {tidal:.0f} ml\ndomes rise: right {-right:+.1f} mm, left {-left:+.1f} mm",
             xlabel="left of the picture is the subject's right (cm)", ylabel="height (cm)", aspect="equal")
    axes.autoscale_view()
    axes.invert_xaxis()  # as seen from the front


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run", nargs="+", type=pathlib.Path, help="run files (HDF5) with a trajectory")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True, help="picture (PNG, PDF, SVG)")
    arguments = parser.parse_args()
    count = len(arguments.run)
    figure, axes = plt.subplots(1, count, squeeze=False, sharey=True, figsize=(4.6 * count, 6), layout="constrained")
    try:
        for path, one in zip(arguments.run, axes[0]):
            plot_run(path, one)
    except (OSError, KeyError) as error:
        parser.error(f"not a file of the kind expected: {error}")
    axes[0, 0].legend(loc="upper center", bbox_to_anchor=(0.5, -0.12), ncols=3, frameon=False, fontsize="x-small")
    figure.savefig(arguments.output, dpi=150)


if __name__ == "__main__":
    main()
