#!/usr/bin/python3
"""Plots how exactly a fit is determined: the likelihood surface with its joint 95 % region, profiles, search.

    scripts/plot_fit.py fit.h5 -o fit.png
"""

import argparse
import pathlib

import h5py
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)

# Colour-blind readers can distinguish Okabe and Ito's palette; line styles differ as well.
BLUE, ORANGE, GREEN, GREY = "#0072B2", "#D55E00", "#009E73", "#666666"


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def label(name, unit):
    return name if unit == "1" else f"{name} ({unit.replace('N m-1', 'N/m')})"


def is_gated(fit):
    """Whether something stands against the recording, so that no parameter is a result."""
    return "results/gates" in fit


def plot_surface(fit, axes):
    if is_gated(fit):
        axes.text(0.5, 0.5, "withheld:\na gate stands against\nthis recording", ha="center", transform=axes.transAxes)
        return axes.set_axis_off()
    if "surface" not in fit:
        axes.text(0.5, 0.5, "no surface: not two parameters,\nor left out", ha="center", transform=axes.transAxes)
        return axes.set_axis_off()
    surface = fit["surface"]
    first, second = (surface[name] for name in ("first", "second"))
    deviance, threshold = surface["deviance"][()].T, surface["threshold95"][()]
    x, y = first[()], second[()]
    levels = threshold * np.array([0, 0.25, 1, 4, 16, 64, 256])
    axes.contourf(x, y, deviance, levels=levels, cmap="cividis_r", extend="max")
    # The root of the deviance is nearly straight between the points of the grid, so lines are drawn on it.
    axes.contour(x, y, np.sqrt(deviance), levels=[np.sqrt(threshold)], colors=[ORANGE], linewidths=2)
    left, right, bottom, top = (surface[f"{name}_{end}95"][()] for name in ("first", "second") for end in ("lower", "upper"))
    axes.plot([left, right, right, left, left], [bottom, bottom, top, top, bottom], color=ORANGE, lw=1, ls=":")
    axes.set(xlim=x[[0, -1]], ylim=y[[0, -1]])
    k = {text(name): value for name, value in zip(fit["parameters/name"][()], fit["parameters/best"][()])}
    names = [text(axis.attrs["long_name"]) for axis in (first, second)]
    units = [text(axis.attrs["units"]) for axis in (first, second)]
    best = [k["k_muscle"] / k["k_elasticity"] if "/" in name else k[name] for name in names]
    axes.plot(*best, "*", color="white", markeredgecolor="black", markersize=11)
    axes.set(title="Likelihood: best (star), joint 95 % region and its extent", xlabel=label(names[0], units[0]),
             ylabel=label(names[1], units[1]))


def plot_profiles(fit, axes):
    if is_gated(fit):
        return axes.set_axis_off()
    styles = ((BLUE, "-o"), (ORANGE, "--s"), (GREEN, "-.^")) * 6
    for (name, profile), (color, style) in zip(fit.get("profiles", {}).items(), styles):
        value, deviance = profile["value"][()], profile["deviance"][()]
        # A file of trunk.fit/1 holds no threshold: it is that of chi-squared.
        threshold = profile["threshold95"][()] if "threshold95" in profile else 3.84
        axes.axhline(threshold, color=GREY, lw=0.8, ls=":")
        axes.set_ylim(0, 5 * threshold)
        axes.plot(100 * (value / value[deviance.argmin()] - 1), deviance, style, color=color, label=name, markersize=4)
    axes.set(title="Profiles; dotted: 95 %", xlabel="difference from the best (%)",
             ylabel="-2 log likelihood above its best")
    if "profiles" in fit:
        axes.legend(frameon=False, fontsize="small")


def plot_search(fit, axes):
    objective = fit["evaluations/objective"][()]
    number = np.arange(1, len(objective) + 1)
    best = np.fmin.accumulate(objective)
    failed = np.isnan(objective)
    axes.semilogy(number, objective, ".", color=GREY, markersize=3, label="each simulation")
    axes.semilogy(number, best, color=BLUE, label="best so far")
    if failed.any():
        axes.plot(number[failed], np.full(failed.sum(), np.nanmax(objective)), "x", color=ORANGE, label="failed")
    axes.set(title="Search, then uncertainty", xlabel="simulation", ylabel="objective")
    axes.legend(frameon=False, fontsize="small")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fit", type=pathlib.Path, help="fit file (HDF5)")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True, help="picture (PNG, PDF, SVG)")
    arguments = parser.parse_args()
    figure, axes = plt.subplots(1, 3, figsize=(14, 4), layout="constrained")
    try:
        with h5py.File(arguments.fit) as fit:
            plot_surface(fit, axes[0])
            plot_profiles(fit, axes[1])
            plot_search(fit, axes[2])
            figure.suptitle(text(fit["result"].attrs["verdict"]), fontsize="small", wrap=True)
    except (OSError, KeyError) as error:
        parser.error(f"not a file of the kind expected: {error}")
    figure.savefig(arguments.output, dpi=150)


if __name__ == "__main__":
    main()
