#!/usr/bin/python3
"""How near does the published model on our mesh come to its own row of Table 1? Which of the values that the paper does
not give matter?

This study takes a scenario, changes one key at a time over its range, and fits k_muscle to the tidal volume of the row
each time. It prints the ranges of the shape changes as Markdown, and writes all runs to a CSV file, in a few minutes.
Runs that failed or that turned triangles over are left out of the ranges and counted.

    scripts/study_published.py -o published.csv
    scripts/study_published.py --set tissue.fibres=tendon_border -o published.csv
"""

import csv
import pathlib

from studies import ROOT, options, parsed, study_parser, workbench, write_csv

DOMES = ("geometry.dome_height_right_mm", "geometry.dome_height_left_mm")
RANGES = [  # keys that change together, values
    (("parameters.abdomen_stiffness_factor",), (0.1, 0.3, 0.6, 1, 1.5, 3)),
    (("tissue.tendon_stiffness_factor",), (1, 2, 5, 10)),
    (("parameters.k_elasticity_N_per_m",), (1000, 2000, 4000, 8000, 16000)),
    (("parameters.damping_N_s_per_m",), (10, 20, 50, 100)),
    (("tissue.particle_mass_kg",), (0.05, 0.1, 0.2, 0.5)),
    (DOMES, (30, 50, 70, 90)),
    (("geometry.abdomen_height_mm",), (120, 150, 200, 250, 300)),
    (("geometry.apposition_length_mm",), (100, 130, 149, 162.7, 200)),
    (("geometry.half_width_mm",), (130, 148, 160, 170)),
    (("geometry.half_depth_mm",), (80, 90.5, 105, 120)),
    (("activation.rise_s",), (1, 2, 3)),
    (("tissue.fibres",), ("apposition_top", "tendon_border")),
    (("tissue.reaction",), ("published", "variational")),
]
MEASURES = {"delta_v_ml": "ΔV ml", "delta_l_mm": "ΔL mm", "delta_l_percent": "ΔL %", "delta_h_mm": "ΔH mm",
            "delta_r_mm": "ΔR mm"}


def run(program, scenario, settings, tidal_ml):
    """Returns the measures of the scenario with k_muscle fitted, and a status."""
    fit, _ = program("fit", scenario, "--tidal-volume-ml", tidal_ml, "--free", "k_muscle", *options(settings))
    k_muscle = {"parameters.k_muscle_N_per_m": repr(fit["parameters"]["k_muscle"]["value"])} if fit else {}
    simulated, _ = program("simulate", scenario, *options(settings | k_muscle)) if fit else (None, None)
    status = "failed" if not simulated else "triangles turned over" if simulated["flipped_triangles"] else "completed"
    return {"k_muscle_N_per_m": float(*k_muscle.values()) if fit else None, "status": status,
            **{name: simulated[name] if simulated else None for name in MEASURES}}


def markdown(base, groups, published):
    shape = ("delta_l_mm", "delta_h_mm", "delta_r_mm")
    lines = ["| | range | ΔL mm | ΔH mm | ΔR mm | left out |", "|---|---|---|---|---|---|",
             "| published row | | " + " | ".join(published[name] for name in ("dl_mm", "dh_mm", "dr_mm")) + " | |",
             "| scenario as it is | | "
             + " | ".join("" if base[name] is None else f"{base[name]:.1f}" for name in shape) + " | |"]
    for (keys, values), rows in groups:
        good = [row for row in rows if row["status"] == "completed"]
        spans = [f"{good[0][name]:.1f} … {good[-1][name]:.1f}" if good else ""
                 for name in shape]
        lines.append(f"| {keys[0].split('.')[1]} | {values[0]} … {values[-1]} | " + " | ".join(spans)
                     + f" | {len(rows) - len(good) or ''} |")
    return "\n".join(lines)


def main():
    parser = study_parser(__doc__, "CSV", "file for all runs")
    parser.add_argument("scenario", nargs="?", type=pathlib.Path, default=ROOT / "scenarios/published_healthy.toml",
                        help="[scenarios/published_healthy.toml]")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE",
                        help="change the scenario in every run")
    parser.add_argument("--only", action="append", metavar="KEY", help="change this key alone; may be repeated")
    arguments = parsed(parser)
    ranges = [group for group in RANGES if not arguments.only or set(group[0]) & set(arguments.only)]
    if not ranges:
        parser.error(f"--only: expected one of {', '.join(keys[0] for keys, _ in RANGES)}")
    always = dict(word.split("=", 1) for word in arguments.set)
    with open(ROOT / "reference/table1.csv", encoding="utf-8") as file:
        table = csv.DictReader(line for line in file if not line.startswith("#"))
        published = next(row for row in table if row["source"] == "published_model")
    with workbench(arguments) as (program, pool):
        def start(settings):
            return pool.submit(run, program, arguments.scenario, settings, published["dv_ml"])
        base = start(always)
        started = [[start(always | dict.fromkeys(keys, value)) for value in values] for keys, values in ranges]
        base, groups = base.result(), [(group, [s.result() for s in row]) for group, row in zip(ranges, started)]
    write_csv(arguments.output, ["key", "value", "k_muscle_N_per_m", *MEASURES, "status"],
              [{"key": keys[0], "value": value} | row for (keys, values), rows in [((("",), [""]), [base]), *groups]
               for value, row in zip(values, rows)])
    print(markdown(base, groups, published))


if __name__ == "__main__":
    main()
