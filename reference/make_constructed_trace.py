#!/usr/bin/python3
"""Writes constructed_trace.csv beside itself: quiet breathing constructed from the end points of Table 1.

An independent one-compartment model, R dV/dt + E V = Pmus(t), stands in for a recording that the paper does not
give as numbers. It shares nothing with libtrunk, so that a fit to it is a fit to something else. Run it again and
the file is the same to the last byte (fixed seed; Debian's python3 and numpy).
"""

from pathlib import Path

import numpy as np

# Table 1, measured row.
EEV_ML = 4760.0
EIV_ML = 5226.0
MEAN_TIDAL_VOLUME_ML = EIV_ML - EEV_ML

# Our choice, of the order usual for resting adults.
RESISTANCE_CMH2O_S_L = 3.0
ELASTANCE_CMH2O_L = 10.0

# The paper's activation: rise, fast fall, slow fall. How far the fast fall goes, and the pause, are our choice.
RISE_S, FAST_FALL_S, SLOW_FALL_S = 2.0, 0.5, 2.0
LEVEL_AFTER_FAST_FALL = 0.4
PAUSE_S = 0.6

# How real recordings differ from the model (our choice).
WHOLE_BREATHS = 8
DEPTH_DEVIATION, TIMING_DEVIATION = 0.04, 0.03
FLOW_NOISE_L_S, FLOW_OFFSET_L_S = 0.005, 0.004
SEED = 20080066
RATE_HZ, STEPS_PER_SAMPLE = 50, 20
# The record begins in the expiration of a breath before and ends in the inspiration of one after.
START_IN_BREATH_S, END_IN_BREATH_S = 3.4, 0.8


def breaths(random):
    """Knots of Pmus for one cut breath, the whole ones, one cut breath: (depth, stretch of time)."""
    count = WHOLE_BREATHS + 2
    depth = 1.0 + DEPTH_DEVIATION * random.standard_normal(count)
    stretch = 1.0 + TIMING_DEVIATION * random.standard_normal(count)
    return list(zip(depth, stretch))


def pressure(drawn):
    """Relative Pmus(t) as knots (times, values), and the onset of every breath."""
    times, values, onsets, now = [], [], [], 0.0
    for depth, stretch in drawn:
        onsets.append(now)
        phases = ((RISE_S, depth), (FAST_FALL_S, LEVEL_AFTER_FAST_FALL * depth), (SLOW_FALL_S, 0.0), (PAUSE_S, 0.0))
        times.append(now)
        values.append(0.0)
        for duration, level in phases:
            now += stretch * duration
            times.append(now)
            values.append(level)
        # The next breath puts its first knot at the same time.
        times.pop()
        values.pop()
    return times, values, onsets


def volumes(drive_cmh2o, step_s):
    """V(t) in L for Pmus given at the steps: implicit midpoint rule from rest."""
    volume, result = 0.0, []
    for before, after in zip(drive_cmh2o[:-1], drive_cmh2o[1:]):
        result.append(volume)
        forcing = 0.5 * (before + after)
        half = 0.5 * step_s * ELASTANCE_CMH2O_L / RESISTANCE_CMH2O_S_L
        volume = (volume * (1.0 - half) + step_s * forcing / RESISTANCE_CMH2O_S_L) / (1.0 + half)
    return np.array(result + [volume])


def tidal_volumes(time_s, volume_l, onsets):
    """Maximum over the value at the onset, of the whole breaths."""
    result = []
    for begin, end in zip(onsets[1:-1], onsets[2:]):
        inside = (time_s >= begin) & (time_s <= end)
        result.append(volume_l[inside].max() - volume_l[inside][0])
    return np.array(result)


def main():
    random = np.random.default_rng(SEED)
    times, values, onsets = pressure(breaths(random))
    step_s = 1.0 / (RATE_HZ * STEPS_PER_SAMPLE)
    steps = int((onsets[-1] + END_IN_BREATH_S) / step_s)
    time_s = step_s * np.arange(steps + 1)
    relative = np.interp(time_s, times, values)

    # The model is linear: one scale of Pmus gives the mean tidal volume of Table 1.
    unit_volume = volumes(relative, step_s)
    scale = MEAN_TIDAL_VOLUME_ML / 1000.0 / tidal_volumes(time_s, unit_volume, onsets).mean()
    flow_l_s = (scale * relative - ELASTANCE_CMH2O_L * scale * unit_volume) / RESISTANCE_CMH2O_S_L

    first = int(START_IN_BREATH_S / step_s)
    flow_l_s = flow_l_s[first::STEPS_PER_SAMPLE]
    flow_l_s = flow_l_s + FLOW_OFFSET_L_S + FLOW_NOISE_L_S * random.standard_normal(flow_l_s.size)

    depths_ml = 1000.0 * scale * tidal_volumes(time_s, unit_volume, onsets)
    header = f"""\
# CONSTRUCTED, NOT A MEASUREMENT. Written by reference/make_constructed_trace.py; do not edit.
# Flow of {WHOLE_BREATHS} whole quiet breaths (and a cut one at either end); inspiration is positive.
# Model: R dV/dt + E V = Pmus(t), R = {RESISTANCE_CMH2O_S_L} cmH2O s/L, E = {ELASTANCE_CMH2O_L} cmH2O/L (our choice, of the order usual for adults).
# Pmus: linear rise {RISE_S} s, fall to {LEVEL_AFTER_FAST_FALL} of the peak {FAST_FALL_S} s, fall to 0 {SLOW_FALL_S} s (timing of the paper), pause {PAUSE_S} s;
# peak {scale:.4f} cmH2O at depth 1, set so that the mean tidal volume of the whole breaths is {MEAN_TIDAL_VOLUME_ML:.0f} ml:
# EEV {EEV_ML:.0f} ml to EIV {EIV_ML:.0f} ml, experiment, Table 1 of Promayon & Baconnier, ESAIM: Proceedings 23 (2008) 66-77.
# From breath to breath (standard deviation): depth {100 * DEPTH_DEVIATION:.0f} %, timing {100 * TIMING_DEVIATION:.0f} %; flow noise {FLOW_NOISE_L_S} L/s, offset {FLOW_OFFSET_L_S} L/s; seed {SEED}.
# True tidal volumes, ml: {" ".join(f"{depth:.1f}" for depth in depths_ml)}
time_s,flow_L_s
"""
    rows = "".join(f"{i / RATE_HZ:.2f},{flow:.5f}\n" for i, flow in enumerate(flow_l_s))
    Path(__file__).with_name("constructed_trace.csv").write_text(header + rows, encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
