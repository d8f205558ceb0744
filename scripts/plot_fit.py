#!/usr/bin/python3
"""Plots how exactly a fit is determined: the likelihood surface with its ridge and joint 95 % region, profiles, search.

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
CHI2_95 = 3.84


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def label(name, unit):
    return name if unit == "1" else f"{name} ({unit.replace('N m-1', 'N/m')})"


def y_of(y):
    return np.linspace(y[0], y[-1], 400)


def between_the_grid(x, y, deviance):
    """Returns fine x, the deviance on a fine grid, and the place of the ridge. The ridge is narrower than a cell of the
    grid, so each column is replaced by the parabola through its three lowest points. The height, place and width of the
    parabolas are smooth functions of x."""
    columns = []
    for i, column in enumerate(deviance.T):
        low = int(np.argmin(np.where(np.isnan(column), np.inf, column)))
        if 0 < low < len(y) - 1 and np.isfinite(column[low - 1:low + 2]).all():
            scaled = (y[low - 1:low + 2] - y[low]) / (y[1] - y[0])
            bend, slope, height = np.polyfit(scaled, column[low - 1:low + 2], 2)
            columns.append((x[i], y[low] - slope / (2 * bend) * (y[1] - y[0]), height - slope ** 2 / (4 * bend), bend))
    if len(columns) < 3:
        return None
    at, place, height, bend = np.array(columns).T
    fine = np.linspace(at[0], at[-1], 400)
    place, height, bend = (np.polyval(np.polyfit(at - at.mean(), values, min(4, len(at) - 1)), fine - at.mean())
                           for values in (place, height, bend))
    return fine, height + bend * ((y_of(y)[:, None] - place) / (y[1] - y[0])) ** 2, place


def plot_surface(fit, axes):
    if "surface" not in fit:
        axes.text(0.5, 0.5, "no surface: not two parameters,\nor left out", ha="center", transform=axes.transAxes)
        return axes.set_axis_off()
    surface = fit["surface"]
    first, second = (surface[name] for name in ("first", "second"))
    deviance, threshold = surface["deviance"][()].T, surface["threshold95"][()]
    x, y = first[()], second[()]
    levels = threshold * np.array([0, 0.25, 1, 4, 16, 64, 256])
    axes.contourf(x, y, deviance, levels=levels, cmap="cividis_r", extend="max")
    if between := between_the_grid(x, y, deviance):
        fine_x, fine, ridge = between
        axes.contour(fine_x, y_of(y), fine, levels=[threshold], colors=[ORANGE], linewidths=2)
        axes.plot(fine_x, ridge, color="white", ls="--", lw=1)
    axes.set(xlim=x[[0, -1]], ylim=y[[0, -1]])
    k = {text(name): value for name, value in zip(fit["parameters/name"][()], fit["parameters/best"][()])}
    names = [text(axis.attrs["long_name"]) for axis in (first, second)]
    units = [text(axis.attrs["units"]) for axis in (first, second)]
    best = [k["k_muscle"] / k["k_elasticity"] if "/" in name else k[name] for name in names]
    axes.plot(*best, "*", color="white", markeredgecolor="black", markersize=11)
    axes.set(title="Likelihood: best (star), ridge, joint 95 % region", xlabel=label(names[0], units[0]),
             ylabel=label(names[1], units[1]))


def plot_profiles(fit, axes):
    axes.axhline(CHI2_95, color=GREY, lw=0.8, ls=":")
    styles = ((BLUE, "-o"), (ORANGE, "--s"), (GREEN, "-.^")) * 6
    for (name, profile), (color, style) in zip(fit.get("profiles", {}).items(), styles):
        value, deviance = profile["value"][()], profile["deviance"][()]
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
