"""What tests of many fits share: short breaths, and options with which a fit of them is quick."""

import random

from support import FAST_FIT, SCENARIOS, breaths, csv

PARALYSED = str(SCENARIOS / "hemiparalysis_right.toml")
FITTED = (0, 4)
QUICK = (*FAST_FIT, "--timing", "trace", "--surface", "0")  # 5 breaths of 1.5 s, 500 steps each
ONE = (*QUICK, "--fix", "k_elasticity=4000")


def noisy(deviation_ml, seed=1):
    rng = random.Random(seed)
    times, volumes = breaths()
    return csv(times, [v + rng.gauss(0, deviation_ml) for v in volumes])
