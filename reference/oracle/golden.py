"""The fingerprint of a breath: lung volume over time, and where some particles are at three moments."""

import numpy as np

from oracle.body import Body
from oracle.breath import simulate
from oracle.volume import enclosed_volume

EVERY_S = 0.05
METRES, MILLILITRES = 12, 8  # decimals kept: far below the tolerance, above what differs between machines


def landmarks(regions, rest):
    """{name: particle}: the outermost, by a direction, on the highest ring of a region. x right, y forward, z up."""
    x, y, z = rest

    def outermost(score, region, where=True):
        members = np.array([i for i in regions[region] if np.broadcast_to(where, x.shape)[i]])
        top = members[z[members] > z[members].max() - 1e-6]
        return int(top[score[top].argmax()])

    return {
        "right_dome": outermost(x, "central_tendon", x > 1e-6),
        "left_dome": outermost(-x, "central_tendon", x < -1e-6),
        "tendon_middle": outermost(z, "central_tendon", x**2 + y**2 < 1e-6),
        "apposition_right": outermost(x, "zone_of_apposition"),
        "apposition_left": outermost(-x, "zone_of_apposition"),
        "apposition_front": outermost(y, "zone_of_apposition"),
        "abdominal_wall_front": outermost(y, "abdominal_wall"),
    }


def fingerprint(run):
    """What the oracle makes of the scenario and the mesh of a run (its trajectory is not looked at), as plain
    data: dV in ml every EVERY_S, positions in m at the start, at end-inspiration (largest dV) and at the end."""
    body = Body(run)
    named = landmarks(body.anatomy.names, body.rest)
    every = round(EVERY_S / body.dt)
    at_rest = enclosed_volume(body.rest, body.anatomy.lung)
    delta_v, moments = [], {}
    for step, positions in enumerate(simulate(body, run.scenario["activation"])):
        delta_v.append(1e6 * (enclosed_volume(positions, body.anatomy.lung) - at_rest))
        moments["end"] = step, positions
        if step == 0:
            moments["start"] = moments["end"]
        if delta_v[-1] >= max(delta_v):
            moments["end_inspiration"] = moments["end"]
    assert np.isfinite(delta_v).all(), "the oracle diverged"
    return {
        "dt_s": body.dt,
        "steps": body.steps,
        "delta_v": {"every_steps": every, "ml": [round(v, MILLILITRES) for v in delta_v[::every]]},
        "particles": named,
        "positions": [
            {"moment": moment, "step": moments[moment][0],
             "m": {name: moments[moment][1][:, i].round(METRES).tolist() for name, i in named.items()}}
            for moment in ("start", "end_inspiration", "end")
        ],
    }
