#!/usr/bin/python3
"""Simulates the scenario stored in a run file a second time, by an implementation that shares no code with
libtrunk, and prints how far the two are apart. Exit code 0: within the tolerance, 1: not, 2: no such run.

    build/trunk simulate scenarios/healthy.toml --set time.start=rest -o healthy.h5
    reference/oracle.py healthy.h5

The rest shape is the first frame. A run whose breathing repeats does not begin at rest: --rest names one that does.
"""

import argparse
import sys
import time

import numpy as np

sys.dont_write_bytecode = True
from oracle.body import Body  # noqa: E402 (the package beside this file)
from oracle.breath import simulate  # noqa: E402
from oracle.run import read_run  # noqa: E402
from oracle.volume import enclosed_volume  # noqa: E402


def compare(run, body):
    """(largest distance to the stored frames m, largest difference of dV ml, particle and step of the former)"""
    frames = dict(zip(run.frame_steps.tolist(), run.frames))
    worst = (0.0, 0, 0)
    apart_ml = 0.0
    for step, positions in enumerate(simulate(body, run.scenario["activation"])):
        volume = enclosed_volume(positions, body.anatomy.lung)
        if step == 0:
            start = volume
        delta_v_ml = 1e6 * (volume - start)
        apart_ml = np.maximum(apart_ml, abs(delta_v_ml - run.delta_v_ml[step]))  # keeps NaN
        if step in frames:
            distance = np.linalg.norm(positions.T - frames.pop(step), axis=1)
            worst = max(worst, (np.inf if np.isnan(distance).any() else distance.max(), distance.argmax(), step))
    assert not frames, f"no step of this scenario is that of {len(frames)} stored frames"
    return worst, apart_ml


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run", help="run file (HDF5) written by trunk simulate")
    parser.add_argument("--rest", metavar="RUN", help="run of the same trunk that starts at rest")
    parser.add_argument("--tolerance", type=float, default=1e-9, metavar="M",
                        help="largest distance of a particle that passes, m (default %(default)s)")
    options = parser.parse_args()
    start = time.perf_counter()
    try:
        run = read_run(options.run, options.rest)
        body = Body(run)
    except (OSError, KeyError, ValueError) as error:
        print(f"oracle: {options.run}: not a run of trunk simulate: {error}", file=sys.stderr)
        return 2
    (distance, particle, step), apart_ml = compare(run, body)
    within = bool(distance <= options.tolerance)
    print(f"largest distance   {distance:.3g} m (particle {particle}, step {step})")
    print(f"largest dV apart   {apart_ml:.3g} ml")
    print(f"time               {time.perf_counter() - start:.1f} s for {body.steps} steps")
    print(f"{'agrees' if within else 'DIFFERS'}: tolerance {options.tolerance:g} m")
    return 0 if within else 1


if __name__ == "__main__":
    sys.exit(main())
