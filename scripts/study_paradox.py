#!/usr/bin/python3
"""Which parts of the model make a paralysed hemidiaphragm rise?

This study simulates healthy and right-paralysed trunks without a lung, with and without ribs, in quiet and exercise
breathing, one breath from rest. It varies the stiffness of the abdominal wall and of the paralysed half. Then it changes
one part of the model at a time.
For every trunk, k_muscle is first fitted on the healthy twin to the same tidal volume. Every run is repeated with half
the time step.

It writes paradox.csv (all runs) and paradox.png, and prints the Markdown table of reference/README.md. It takes a few minutes.
The picture shows the runs that half the time step does not change; marker sizes and orange numbers are the elasticity
left in the paralysed half.

    scripts/study_paradox.py -o reference
"""

import dataclasses
import itertools
import json

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)

from studies import ROOT, parsed, study_parser, workbench, write_study  # noqa: E402

BREATHS = {"quiet": ("", 466),  # what differs from healthy_no_lung.toml, healthy ml
           "exercise": ("[activation]\nrise_s = 1.2\nfast_fall_s = 0.3\nslow_fall_s = 1.2\n[time]\nduration_s = 2.7\n", 1200)}
ABDOMEN, SOFTENING = (0.4, 0.8, 1.6, 3.2), (1.0, 0.7, 0.5, 0.3, 0.1)
DEFAULT_ABDOMEN, DEFAULT_SOFTENING = 0.8, 0.5  # those of scenarios/healthy_no_lung.toml and hemiparalysis_right.toml
LONGEST_STEP_MS, HALVINGS = 1.0, 2
SAME_MM, SAME_PRESSURE = 0.1, 0.05  # a run counts if half the time step changes it by at most this
PRESSURE = "abdominal_pressure_peak_cmH2O"
MEASURES = {"delta_v_ml": "delta_v_ml", "excursion_right_mm": "right_dome_descends_mm",
            "excursion_left_mm": "left_dome_descends_mm", PRESSURE: PRESSURE, "flipped_triangles": "flipped_triangles"}
COLUMNS = ["breath", "costal_ring", "abdomen_stiffness_factor", "fibres", "reaction", "paralysed",
           "paralysed_stiffness_factor", "k_muscle_N_per_m", *MEASURES.values(), "delta_v_of_healthy_percent",
           "dt_ms", "status"]
HELD = "".join(f'[[displacement]]\nregion = "costal_insertion"\ndirection = {d}\nevents_mm = [[0, 0]]\n'
               for d in ([1, 0, 0], [0, 1, 0], [0, 0, 1]))


@dataclasses.dataclass(frozen=True)
class Trunk:
    """A healthy trunk. costal_ring is "free", "held", or "ribs": held, and the zone of apposition stays inside."""
    breath: str
    costal_ring: str = "ribs"
    abdomen: float = DEFAULT_ABDOMEN
    fibres: str = "tendon_border"
    reaction: str = "variational"

    def scenario(self):
        extended = json.dumps(str(ROOT / "scenarios" / "healthy_no_lung.toml"))
        return (f'schema = "trunk.scenario/1"\nextends = {extended}\n'
                f'[parameters]\nabdomen_stiffness_factor = {self.abdomen}\n'
                f'[tissue]\nfibres = "{self.fibres}"\nreaction = "{self.reaction}"\n'
                f'ribs = {"true" if self.costal_ring == "ribs" else "false"}\n'
                + BREATHS[self.breath][0] + (HELD if self.costal_ring == "held" else ""))


def trunks(quick):
    if quick:
        return [Trunk("quiet", ring) for ring in ("ribs", "free")]
    grid = [Trunk(breath, ring, abdomen) for breath, ring, abdomen in
            itertools.product(BREATHS, ("ribs", "free"), ABDOMEN)]
    alone = [Trunk(breath, **change) for breath in BREATHS for change in
             ({"costal_ring": "held"}, {"fibres": "apposition_top"}, {"reaction": "published"})]
    return grid + alone


class Paradox:
    """Runs trunks with and without paralysis."""

    def __init__(self, program, longest_step_ms):
        self.program, self.longest_step_ms = program, longest_step_ms

    def checked(self, scenario, step_ms, *settings):
        """Returns a run and its status, which says if half the time step changes the run."""
        run, status = self.program("simulate", scenario, *settings, "--set", f"time.dt_ms={step_ms}")
        if not run:
            return run, status
        half, _ = self.program("simulate", scenario, *settings, "--set", f"time.dt_ms={step_ms / 2}")
        same = half and all(abs(half[f"excursion_{side}_mm"] - run[f"excursion_{side}_mm"]) <= SAME_MM
                            for side in ("right", "left"))
        same = same and abs(half[PRESSURE] / run[PRESSURE] - 1) <= SAME_PRESSURE
        return run, "completed" if same else "depends on the time step"

    def runs(self, trunk, softenings):
        """Returns the rows of one trunk: k_muscle fitted on the healthy one, then its paralysed twins. Halves the time
        step while one of them fails."""
        scenario = self.program.folder / f"{next(self.program.count)}.toml"
        scenario.write_text(trunk.scenario(), encoding="utf-8")
        for halving in range(HALVINGS + 1):
            step_ms = self.longest_step_ms / 2**halving
            rows = self.runs_at(trunk, scenario, softenings, step_ms)
            if all(row["delta_v_ml"] is not None for row in rows):
                break
        return rows

    def runs_at(self, trunk, scenario, softenings, step_ms):
        common = {"breath": trunk.breath, "costal_ring": trunk.costal_ring, "abdomen_stiffness_factor": trunk.abdomen,
                  "fibres": trunk.fibres, "reaction": trunk.reaction, "dt_ms": step_ms}
        step = ("--set", f"time.dt_ms={step_ms}")
        volume_ml = BREATHS[trunk.breath][1]
        fit, status = self.program("fit", scenario, "--tidal-volume-ml", volume_ml, "--free", "k_muscle", *step)
        k_muscle = fit["parameters"]["k_muscle"]["value"] if fit else None
        healthy, rows = None, []
        for softening in (None, *softenings):
            run = None
            if fit:
                paralysis = ("--set", "paralysis.side=right", "--set", f"paralysis.stiffness_factor={softening}")
                run, status = self.checked(scenario, step_ms, "--set", f"parameters.k_muscle_N_per_m={k_muscle!r}",
                                           *(paralysis if softening is not None else ()))
            healthy = run if softening is None else healthy
            ratio = 100 * run["delta_v_ml"] / healthy["delta_v_ml"] if run and healthy else None
            rows.append(common | {"paralysed": "no" if softening is None else "right",
                                  "paralysed_stiffness_factor": softening, "k_muscle_N_per_m": k_muscle,
                                  "delta_v_of_healthy_percent": ratio, "status": status}
                        | {name: run[key] if run else None for key, name in MEASURES.items()})
        return rows


def markdown(rows):
    lines = [("all of it: ribs, abdominal wall 0.8, paralysed half at 0.5", {}),
             ("no ribs", {"costal_ring": "free"}),
             ("costal insertion held, zone of apposition free", {"costal_ring": "held"}),
             ("no ribs, abdominal wall 3.2, paralysed half at 0.1",
              {"costal_ring": "free", "abdomen_stiffness_factor": 3.2, "paralysed_stiffness_factor": 0.1}),
             ("paralysed half not softer", {"paralysed_stiffness_factor": 1.0}),
             ("paralysed half at 0.1", {"paralysed_stiffness_factor": 0.1}),
             ("abdominal wall 0.4", {"abdomen_stiffness_factor": 0.4}),
             ("abdominal wall 1.6", {"abdomen_stiffness_factor": 1.6}),
             ("fibres end at the top of the zone of apposition", {"fibres": "apposition_top"}),
             ("reaction as published", {"reaction": "published"}),
             ("reaction as published, paralysed half at 0.1",
              {"reaction": "published", "paralysed_stiffness_factor": 0.1})]
    default = {"costal_ring": "ribs", "abdomen_stiffness_factor": DEFAULT_ABDOMEN, "fibres": "tendon_border",
               "reaction": "variational", "paralysed": "right", "paralysed_stiffness_factor": DEFAULT_SOFTENING}
    text = ["| | quiet: ΔV | paralysed dome | other dome | exercise: ΔV | paralysed dome | other dome |",
            "|---|---|---|---|---|---|---|"]
    for label, change in lines:
        cells = []
        for breath in BREATHS:
            wanted = default | change | {"breath": breath}
            found = [row for row in rows if all(row[name] == value for name, value in wanted.items())]
            if found and found[0]["status"] == "completed":
                right, left = (found[0][f"{side}_dome_descends_mm"] for side in ("right", "left"))
                cells += [f"{found[0]['delta_v_of_healthy_percent']:.0f} %", f"{right:+.1f} mm", f"{left:+.1f} mm"]
            else:
                cells += [""] * 3
        if any(cells):
            text.append(f"| {label} | " + " | ".join(cells) + " |")
    return "\n".join(text)


def plot(rows, path):
    # Colour-blind readers can distinguish Okabe and Ito's palette; marker and line show the ribs.
    colours = dict(zip(ABDOMEN, ("#E69F00", "#D55E00", "#0072B2", "#000000")))
    styles = {"ribs": ("o", "-", "ribs"), "free": ("^", ":", "no ribs")}
    figure, axes = plt.subplots(1, 2, figsize=(10, 5.2))
    figure.subplots_adjust(left=0.075, right=0.985, top=0.94, bottom=0.27)
    for axis, (breath, (_, volume_ml)) in zip(axes, BREATHS.items()):
        for (ring, (marker, line, _)), (abdomen, colour) in itertools.product(styles.items(), colours.items()):
            series = [row for row in rows if (row["breath"], row["costal_ring"], row["abdomen_stiffness_factor"])
                      == (breath, ring, abdomen) and row["paralysed"] == "right" and row["status"] == "completed"
                      and (row["fibres"], row["reaction"]) == ("tendon_border", "variational")]
            x = [row["delta_v_of_healthy_percent"] for row in series]
            y = [row["right_dome_descends_mm"] for row in series]
            sizes = [14 + 50 * row["paralysed_stiffness_factor"] for row in series]
            axis.plot(x, y, color=colour, ls=line, lw=1)
            axis.scatter(x, y, sizes, color=colour, marker=marker, edgecolors="white", linewidths=0.5, zorder=3)
            if ring == "ribs" and abdomen == DEFAULT_ABDOMEN:
                for row, a, b in zip(series, x, y):
                    axis.annotate(f"{row['paralysed_stiffness_factor']:g}", (a, b), (6, 5),
                                  textcoords="offset points", fontsize=8, color=colour)
        axis.axhline(0, color="#666666", lw=0.8)
        bottom, top = axis.get_ylim()
        left, right = axis.get_xlim()
        axis.fill_between([40, 60], min(bottom, -2), -1, color="#009E73", alpha=0.18, lw=0)
        axis.set(ylim=(top, min(bottom, -2)), xlim=(left, right),  # up is up
                 title=f"{breath} breathing, healthy ΔV {volume_ml} ml",
                 xlabel="ΔV of the paralysed over the healthy trunk (%)",
                 ylabel="paralysed dome descends (mm; negative: it rises)")
    keys = [plt.Line2D([], [], color="#666666", marker=m, ls=line, label=label) for m, line, label in styles.values()]
    keys += [plt.Line2D([], [], color=colour, lw=3, label=f"abdominal wall {abdomen:g} of muscle stiffness")
             for abdomen, colour in colours.items()]
    keys += [plt.Line2D([], [], color="#666666", marker="o", ls="", markersize=(14 + 50 * s) ** 0.5,
                        label=f"paralysed half at {s:g}") for s in (SOFTENING[0], SOFTENING[-1])]
    keys.append(plt.Rectangle((0, 0), 1, 1, color="#009E73", alpha=0.18, label="40–60 % and at least 1 mm up"))
    figure.legend(handles=keys, loc="lower center", ncols=3, frameon=False, fontsize="small")
    figure.savefig(path, dpi=110)
    plt.close(figure)


def main():
    parser = study_parser(__doc__)
    parser.add_argument("--quick", action="store_true",
                        help="quiet breathing at the defaults, with and without ribs, in steps of 3 ms; no picture")
    arguments = parsed(parser)
    softenings = (DEFAULT_SOFTENING,) if arguments.quick else SOFTENING
    with workbench(arguments) as (program, pool):
        paradox = Paradox(program, 3.0 if arguments.quick else LONGEST_STEP_MS)
        groups = pool.map(lambda trunk: paradox.runs(trunk, softenings), trunks(arguments.quick))
        rows = [row for group in groups for row in group]
    write_study(arguments, "paradox", COLUMNS, rows, plot, markdown)


if __name__ == "__main__":
    main()
