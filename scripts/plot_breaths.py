#!/usr/bin/python3
"""Plots lung volume over time: measured and fitted with the residual, and simulated runs together.

    scripts/plot_breaths.py --fit fit.h5 healthy.h5 paralysed.h5 -o breaths.png
"""

import argparse
import pathlib

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)

# Colour-blind readers can distinguish Okabe and Ito's palette; line styles differ as well.
BLUE, ORANGE, GREEN, GREY = "#0072B2", "#D55E00", "#009E73", "#666666"
STYLES = [(BLUE, "-"), (ORANGE, "--"), (GREEN, "-."), (GREY, ":")]


def plot_fit(path, curve_axes, residual_axes):
    with h5py.File(path) as fit:
        time, measured, sigma = (fit["problem"][name][()] for name in ("time", "measured", "sigma"))
        model_time, model = fit["result/time"][()], fit["result/dV_fit"][()]
        residual = fit["result/residual"][()]
    curve_axes.fill_between(time, measured - sigma, measured + sigma, color=GREY, alpha=0.25, lw=0,
                            label="measured ± 1 SD over breaths")
    curve_axes.plot(time, measured, color=GREY, label="measured, mean breath")
    curve_axes.plot(model_time, model, color=BLUE, ls="--", label="model, fitted")
    curve_axes.set(title="Fit", ylabel="lung volume above its start (ml)")
    residual_axes.axhline(0, color=GREY, lw=0.8)
    residual_axes.plot(model_time, residual, color=ORANGE)
    residual_axes.set(xlabel="time (s)", ylabel="model − measured (ml)")
    curve_axes.legend(frameon=False, fontsize="small")


def plot_runs(paths, curve_axes, activation_axes):
    for path, (color, style) in zip(paths, STYLES * len(paths)):
        with h5py.File(path) as run:
            time = run["curves/time"][()]
            curve_axes.plot(time, run["curves/dV_model"][()], color=color, ls=style, label=path.stem)
            activation_axes.plot(time, run["curves/activation"][()], color=color, ls=style)
    curve_axes.set(title="Simulated", ylabel="lung volume above its start (ml)")
    activation_axes.set(xlabel="time (s)", ylabel="activation A(t)")
    curve_axes.legend(frameon=False, fontsize="small")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run", nargs="*", type=pathlib.Path, help="run files (HDF5)")
    parser.add_argument("--fit", type=pathlib.Path, help="fit file (HDF5)")
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True, help="picture (PNG, PDF, SVG)")
    arguments = parser.parse_args()
    columns = bool(arguments.fit) + bool(arguments.run)
    if columns == 0:
        parser.error("expected run files, --fit or both")
    figure, axes = plt.subplots(2, columns, sharex="col", squeeze=False, figsize=(5.2 * columns, 5),
                                height_ratios=[3, 1], layout="constrained")
    try:
        if arguments.fit:
            plot_fit(arguments.fit, axes[0, 0], axes[1, 0])
        if arguments.run:
            plot_runs(arguments.run, axes[0, -1], axes[1, -1])
    except (OSError, KeyError) as error:
        parser.error(f"not a file of the kind expected: {error}")
    figure.savefig(arguments.output, dpi=150)


if __name__ == "__main__":
    main()
