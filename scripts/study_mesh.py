#!/usr/bin/python3
"""How much do the results depend on the mesh?

This study refines the template from 113 to 4077 particles. The program scales the parameters: shape memory is n^2 times
as stiff for each particle, the muscle is shared by n times as many fibres, and mass and damping by n^2 times as many
particles. The study answers these questions:

  * How do the tidal volume and the shape change at unchanged parameters?
  * With which exponent of the elasticity is there a limit?
  * How much changes if k_muscle is fitted to the same tidal volume, healthy and right-paralysed?
  * Does a membrane help?
  * How much comes from the area of the cross-section?
  * How much comes from the held rings, if these have twice the elasticity?

It writes mesh.csv (all runs) and mesh.png, and prints the Markdown tables of reference/README.md, in a few minutes.

    scripts/study_mesh.py -o reference
"""

import math
import pathlib

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)
import matplotlib.ticker  # noqa: E402

from studies import ROOT, options, parsed, study_parser, workbench, write_study  # noqa: E402

RESOLUTIONS, FINEST = (1, 2, 3, 4), 6
STEP_MS = {1: 1.0, 2: 1.0, 3: 0.5, 4: 0.3, 6: 0.15}  # below the bound of stability; half of it changes little
K_ELASTICITY, K_MUSCLE = "parameters.k_elasticity_N_per_m", "parameters.k_muscle_N_per_m"
MEMBRANE = "tissue.membrane_stiffness_N_per_m"
DEFAULT = {K_ELASTICITY: 4000.0, K_MUSCLE: 27.2226, MEMBRANE: 0.0}  # those of scenarios/healthy_no_lung.toml
HALF_AXES = {"geometry.half_width_mm": 160.0, "geometry.half_depth_mm": 105.0}
EXPONENTS = (0, 1, 1.5)  # beside the program's own 2
POWER = {0: "1", 1: "n", 1.5: "n^1.5", 2: "n²"}
MEMBRANES = (10, 30, 100, 300)
TRUSTED_ORDER = (0.5, 3)
WITHOUT = {"no ribs": {"tissue.ribs": "false"},
           "abdominal wall 0.05": {"parameters.abdomen_stiffness_factor": 0.05},
           "tendon as soft as muscle": {"tissue.tendon_stiffness_factor": 1}}
TWICE = {"tissue.held_stiffness_factor": 2}
TRUNK = "healthy_no_lung.toml"  # the mesh is one of tissue; a lung has no triangles of its own
PARALYSIS = {"paralysis.side": "right", "paralysis.stiffness_factor": 0.5}
DEEP = {"activation.rise_s": 1.2, "activation.fast_fall_s": 0.3, "activation.slow_fall_s": 1.2, "time.duration_s": 2.7}
BREATHS = {"healthy": {}, "paralysed": PARALYSIS, "exercise": DEEP, "exercise, paralysed": DEEP | PARALYSIS}
HEALTHY, PARALYSED, EXERCISE, EXERCISE_PARALYSED = BREATHS
TIDAL_ML, EXERCISE_ML, CLOSE = 466, 1200, 1e-4
BOUNDS = (("delta_l_mm", 9.13, 0.30), ("delta_h_mm", 2.00, 0.75), ("delta_r_mm", 0.0, 0.50))  # Table 1: value, margin
MEASURES = {"particles": "particles", "delta_v_ml": "delta_v_ml", "delta_l_mm": "delta_l_mm",
            "delta_h_mm": "delta_h_mm", "delta_r_mm": "delta_r_mm", "excursion_right_mm": "right_dome_descends_mm",
            "excursion_left_mm": "left_dome_descends_mm", "abdominal_pressure_peak_cmH2O": "pressure_cmH2O",
            "flipped_triangles": "flipped_triangles"}
COLUMNS = ["question", "change", "resolution", "particles", "scenario", "dt_ms", "k_elasticity_N_per_m",
           "k_muscle_N_per_m", "membrane_N_per_m", *list(MEASURES.values())[1:], "status"]


class Refinement:
    """Runs the trunk at any resolution; each run is a row of the table."""

    def __init__(self, program, coarser_step):
        self.program, self.coarser_step = program, coarser_step

    def run(self, question, change, n, settings=None, scenario=HEALTHY, step=1.0):
        """Returns the row of one run. `scenario` is one of BREATHS or a path."""
        settings = {"geometry.resolution": n, "time.dt_ms": self.coarser_step * step * STEP_MS[n]} | (settings or {})
        file = ROOT / "scenarios" / TRUNK if scenario in BREATHS else scenario
        run, status = self.program("simulate", file, *options(BREATHS.get(scenario, {}) | settings))
        known = DEFAULT | settings
        return {"question": question, "change": change, "resolution": n, "scenario": pathlib.Path(scenario).name,
                "dt_ms": settings["time.dt_ms"], "k_elasticity_N_per_m": known[K_ELASTICITY],
                "k_muscle_N_per_m": known[K_MUSCLE], "membrane_N_per_m": known[MEMBRANE], "status": status,
                **{name: run[key] if run else None for key, name in MEASURES.items()}}

    def solve(self, question, change, n, target, key=K_MUSCLE, start=None, settings=None, scenario=HEALTHY):
        """Returns the row of the run whose ΔV is `target`. It finds the value of `key` by a secant in logarithms."""
        at, slope, before = math.log(start or DEFAULT[key]), 1.0 if key == K_MUSCLE else -1.0, None
        for _ in range(10):
            row = self.run(question, change, n, (settings or {}) | {key: math.exp(at)}, scenario)
            if not row["delta_v_ml"] or row["delta_v_ml"] <= 0:
                return row
            miss = math.log(row["delta_v_ml"] / target)
            if abs(miss) <= CLOSE:
                return row
            if before:
                slope = (miss - before[1]) / (at - before[0])
            before, at = (at, miss), at - miss / slope
        return row | {"status": "tidal volume not reached"}


def muscle_at(n):
    """Returns about the k_muscle for 466 ml, where a search starts."""
    return DEFAULT[K_MUSCLE] * 2.04 / (1 + 1.04 / n)


def paralysed(mesh, question, healthy, scenario):
    """Returns the row of the paralysed twin of a fitted row."""
    return mesh.run(question, "paralysed", healthy["resolution"], {K_MUSCLE: healthy["k_muscle_N_per_m"]}, scenario)


def polygon_area(corners):
    """Returns the area of a regular polygon over that of its circle."""
    return corners / (2 * math.pi) * math.sin(2 * math.pi / corners)


def matched(mesh, n):
    """Returns rows with the same tidal volume: k_muscle fitted, its paralysed twin, and k_elasticity fitted instead."""
    healthy = mesh.solve("466 ml by k_muscle", "", n, TIDAL_ML, start=muscle_at(n))
    twin = paralysed(mesh, "466 ml by k_muscle", healthy, PARALYSED)
    k = DEFAULT[K_ELASTICITY] * DEFAULT[K_MUSCLE] / healthy["k_muscle_N_per_m"]
    return [healthy, twin, mesh.solve("466 ml by k_elasticity", "", n, TIDAL_ML, K_ELASTICITY, k)]


def exercise(mesh, n):
    start = 75.22 * muscle_at(n) / DEFAULT[K_MUSCLE]
    healthy = mesh.solve("1200 ml by k_muscle", "", n, EXERCISE_ML, start=start, scenario=EXERCISE)
    return [healthy, paralysed(mesh, "1200 ml by k_muscle", healthy, EXERCISE_PARALYSED)]


def unchanged(mesh, change, settings, resolutions, question):
    """Returns rows with the k_muscle that is fitted on the coarsest mesh."""
    first = mesh.solve(question, change, 1, TIDAL_ML, settings=settings)
    k = {K_MUSCLE: first["k_muscle_N_per_m"]}
    return [first] + [mesh.run(question, change, n, settings | k) for n in resolutions if n > 1]


def membrane_matched(mesh, stiffness, n):
    return [mesh.solve("membrane, 466 ml", f"{stiffness:g} N/m", n, TIDAL_ML, start=muscle_at(n) + 0.038 * stiffness,
                       settings={MEMBRANE: stiffness})]


def same_area(mesh, n):
    """Returns a row with half-axes that give the cross-section the area of the coarsest mesh's."""
    factor = math.sqrt(polygon_area(12) / polygon_area(12 * n))
    return [mesh.run("area of the 12-gon", "", n, {key: factor * value for key, value in HALF_AXES.items()})]


def held_stiffer(mesh, n):
    """Returns rows with twice the elasticity of held particles: same parameters, then fitted and its paralysed twin."""
    rows = [mesh.run("held twice, same parameters", "", n, TWICE)]
    if n != 3:
        fitted = "held twice, 466 ml"
        rows.append(mesh.solve(fitted, "", n, TIDAL_ML, start=1.36 * muscle_at(n), settings=TWICE))
        muscle = {K_MUSCLE: rows[-1]["k_muscle_N_per_m"]}
        rows.append(mesh.run(fitted, "paralysed", n, TWICE | muscle, PARALYSED))
    return rows


def tasks(mesh, quick):
    """Returns the independent parts of the study, slow ones first."""
    def one(*arguments, **named):
        return lambda: [mesh.run(*arguments, **named)]

    def part(function, *arguments):
        return lambda: function(mesh, *arguments)

    resolutions, membranes = ((1, 2), (100,)) if quick else (RESOLUTIONS, MEMBRANES)
    ends = [n for n in resolutions if n != 3]
    found = [] if quick else [one("same parameters", "", FINEST)]
    found += [part(unchanged, f"{m:g} N/m", {MEMBRANE: m}, ends, "membrane, same parameters") for m in membranes]
    for n in reversed(resolutions):
        found += [part(matched, n), part(held_stiffer, n), one("same parameters", "", n)]
        found += [part(membrane_matched, m, n) for m in membranes if n in ends]
        if not quick:
            found += [part(exercise, n), one("half the time step", "", n, step=0.5)] if n < 4 else []
        if n > 1:
            found.append(part(same_area, n))
            found += [one("exponent", f"{p:g}", n, {K_ELASTICITY: DEFAULT[K_ELASTICITY] * n**(p - 2)})
                      for p in (() if quick else EXPONENTS)]
    if not quick:
        found += [part(unchanged, name, change, (2, 3), "without") for name, change in WITHOUT.items()]
    return found


class Findings:
    """Gives the rows by question, change and resolution."""

    def __init__(self, rows):
        self.rows = {(r["question"], r["change"], r["resolution"]): r for r in rows if r["status"] == "completed"}

    def value(self, question, change, n, name):
        row = self.rows.get((question, change, n))
        return row[name] if row else None

    def series(self, question, change, name):
        return {n: self.value(question, change, n, name) for n in (*RESOLUTIONS, FINEST)}

    def exponent_series(self, p):
        own = self.series("same parameters", "", "delta_v_ml")
        return own if p == 2 else {1: own[1]} | {n: self.value("exponent", f"{p:g}", n, "delta_v_ml")
                                                for n in RESOLUTIONS[1:]}


def order_and_limit(series):
    """Returns order and limit of v = limit + c / n^order through n = 1, 2, 4; None if v does not approach smoothly."""
    if any(series.get(n) is None for n in (1, 2, 4)):
        return None
    first, second = series[2] - series[1], series[4] - series[2]
    if second == 0 or not 2**TRUSTED_ORDER[0] <= first / second <= 2**TRUSTED_ORDER[1]:
        return None
    ratio = first / second
    return math.log2(ratio), series[4] + second / (ratio - 1)


def order_and_limit_of_inverse(series):
    """Returns the same for 1 / v. A parameter that reaches a volume is inverse to the compliance, which has a limit."""
    found = order_and_limit({n: 1 / v for n, v in series.items() if v})
    return (found[0], 1 / found[1]) if found else None


def number(value, digits):
    return "" if value is None else f"{round(value, digits) + 0.0:.{digits}f}"  # no -0


def limit_cells(series, digits, extrapolate):
    found = extrapolate(series)
    return [number(found[1], digits), number(found[0], 1)] if found else ["", ""]


def fitted_lines(f, question):
    """Returns label, series, digits and extrapolation of lines whose k_muscle is fitted to 466 ml on each mesh."""
    def of(name, change=""):
        return f.series(question, change, name)

    ratio = {n: v and 100 * v / of("delta_v_ml")[n] for n, v in of("delta_v_ml", "paralysed").items()}
    return [("k_muscle for 466 ml, N/m", of("k_muscle_N_per_m"), 1, order_and_limit_of_inverse),
            ("at 466 ml: ΔL mm", of("delta_l_mm"), 2, order_and_limit),
            ("at 466 ml: ΔH mm", of("delta_h_mm"), 2, order_and_limit),
            ("at 466 ml: ΔR mm", of("delta_r_mm"), 2, order_and_limit),
            ("at 466 ml: dome descends mm", of("right_dome_descends_mm"), 1, order_and_limit),
            ("at 466 ml: peak abdominal pressure cmH2O", of("pressure_cmH2O"), 1, order_and_limit_of_inverse),
            ("right side paralysed: ΔV %", ratio, 0, order_and_limit),
            ("right side paralysed: its dome descends mm", of("right_dome_descends_mm", "paralysed"), 1,
             order_and_limit)]


def refinement_tables(f):
    text = []
    for title, same, fitted in (("particles", "same parameters", "466 ml by k_muscle"),
                                ("held particles twice as stiff; particles", "held twice, same parameters",
                                 "held twice, 466 ml")):
        lines = [f"| {title} | 113 | 455 | 1029 | 1835 | 4077 | limit | order |", "|---|---|---|---|---|---|---|---|"]
        for label, series, digits, extrapolate in (
                ("same parameters: ΔV ml", f.series(same, "", "delta_v_ml"), 0, order_and_limit),
                *fitted_lines(f, fitted)):
            cells = [number(series[n], digits) for n in (*RESOLUTIONS, FINEST)]
            lines.append(f"| {label} | " + " | ".join(cells + limit_cells(series, digits, extrapolate)) + " |")
        text.append(lines)
    return text


def within_table1(row):
    return all(abs(row[name] - value) <= margin for name, value, margin in BOUNDS)


def membrane_table(f):
    lines = ["| membrane N/m | ΔV at 455, 1835 particles % | at 466 ml, 113 particles: ΔL, ΔH, ΔR mm "
             "| 1835 particles: ΔL, ΔH, ΔR mm | ΔL, ΔH, ΔR within bounds at 113, 455, 1835 |", "|---|---|---|---|---|"]
    for m in (0, *MEMBRANES):
        change = f"{m:g} N/m" if m else ""
        same = f.series("membrane, same parameters" if m else "same parameters", change, "delta_v_ml")
        rows = [f.rows.get(("membrane, 466 ml" if m else "466 ml by k_muscle", change, n)) for n in (1, 2, 4)]
        if same[1] is None or rows[0] is None:
            continue
        shape = [" ".join(number(row[name], 2) for name, _, _ in BOUNDS) if row else "" for row in rows]
        kept = ", ".join("yes" if within_table1(row) else "no" for row in rows if row)
        change = ", ".join(f"{100 * (same[n] / same[1] - 1):+.0f}" for n in (2, 4) if same[n])
        lines.append(f"| {m:g} | {change} | {shape[0]} | {shape[2]} | {kept} |")
    return lines


def other_table(f):
    lines = ["| ΔV ml at particles | 113 | 455 | 1029 | 1835 |", "|---|---|---|---|---|"]

    def line(label, series, digits=0):
        if any(series.get(n) is not None for n in RESOLUTIONS[1:]):
            lines.append(f"| {label} | " + " | ".join(number(series.get(n), digits) for n in RESOLUTIONS) + " |")

    for p in (*EXPONENTS, 2):
        line(f"k_elasticity ∝ {POWER[p]}", f.exponent_series(p))
    k = f.series("466 ml by k_elasticity", "", "k_elasticity_N_per_m")
    line("exponent that would keep 466 ml, from 113", {n: 2 + math.log(k[n] / k[1], n) for n in RESOLUTIONS[1:]
                                                       if k[n] and k[1]}, 2)
    line("area of the 12-gon kept", {1: f.value("same parameters", "", 1, "delta_v_ml")}
         | {n: f.value("area of the 12-gon", "", n, "delta_v_ml") for n in RESOLUTIONS[1:]})
    for name in WITHOUT:
        line(f"{name}, k_muscle fitted at 113", f.series("without", name, "delta_v_ml"))
    line("exercise paralysed, k_muscle fitted to 1200 ml", f.series("1200 ml by k_muscle", "paralysed", "delta_v_ml"))
    line("its paralysed dome descends, mm", f.series("1200 ml by k_muscle", "paralysed", "right_dome_descends_mm"), 1)
    return lines


def markdown(rows):
    f = Findings(rows)
    text = [*refinement_tables(f), membrane_table(f), other_table(f)]
    same, half = (f.series(question, "", "delta_v_ml") for question in ("same parameters", "half the time step"))
    halved = [abs(half[n] - same[n]) for n in RESOLUTIONS if half[n] and same[n]]
    if halved:
        text.append([f"Half the time step changes ΔV by at most {max(halved):.2f} ml."])
    found, finest = order_and_limit(same), same[FINEST]
    if found and finest:
        order, limit = found
        predicted = limit + (same[1] - limit) / FINEST**order
        text.append([f"113, 455 and 1835 particles predict {predicted:.1f} ml at 4077; simulated: {finest:.1f} ml."])
    return "\n\n".join("\n".join(lines) for lines in text)


def plot(rows, path):
    # Colour-blind readers can distinguish Okabe and Ito's palette; series differ by marker too.
    f = Findings(rows)
    figure, axes = plt.subplots(1, 3, figsize=(11, 4.1))
    figure.subplots_adjust(left=0.06, right=0.99, top=0.92, bottom=0.14, wspace=0.26)

    def draw(axis, series, label, colour, marker, line="-"):
        points = [(1 / n, v) for n, v in series.items() if v is not None]
        axis.plot(*zip(*points), color=colour, marker=marker, ls=line, ms=5, lw=1.2, label=label)

    colours, markers = ("#E69F00", "#56B4E9", "#009E73", "#000000"), "^sDo"
    for p, colour, marker in zip((*EXPONENTS, 2), colours, markers):
        series = f.exponent_series(p)
        draw(axes[0], series, f"k_elasticity ∝ {POWER[p]}" + (" (the program's)" if p == 2 else ""), colour, marker)
    found = order_and_limit(f.series("same parameters", "", "delta_v_ml"))
    if found:
        finest = f.value("same parameters", "", FINEST, "delta_v_ml")
        axes[0].plot([1 / FINEST, 0], [finest or found[1], found[1]], color="#000000", ls=":", lw=1.2)
        axes[0].plot([0], [found[1]], color="#000000", marker="o", mfc="white", clip_on=False, ls="",
                     label=f"limit {found[1]:.0f} ml")
    draw(axes[0], f.series("held twice, same parameters", "", "delta_v_ml"), "n², held particles twice as stiff",
         "#CC79A7", "v", "--")
    axes[0].set_title("same parameters", fontsize="medium")
    axes[0].set(ylabel="ΔV (ml)", yscale="log", ylim=(180, 12000), yticks=(200, 300, 500, 1000, 2000))
    axes[0].yaxis.set_major_formatter("{x:.0f}")
    axes[0].yaxis.set_minor_locator(matplotlib.ticker.NullLocator())
    for change, sides in (("", (("right", "healthy, both domes", "#000000", "o"),)),
                          ("paralysed", (("left", "right paralysed: left dome", "#0072B2", "s"),
                                         ("right", "right paralysed: right dome", "#D55E00", "^")))):
        for side, label, colour, marker in sides:
            draw(axes[1], f.series("466 ml by k_muscle", change, f"{side}_dome_descends_mm"), label, colour, marker)
            draw(axes[1], f.series("held twice, 466 ml", change, f"{side}_dome_descends_mm"), None, colour,
                 marker, "--")
    axes[1].axhline(0, color="#666666", lw=0.8)
    axes[1].set_ylim(38, -12)  # up is up
    axes[1].set_title("466 ml on each mesh (dashed: held particles twice as stiff)", fontsize="medium")
    axes[1].set(ylabel="dome descends (mm; negative: it rises)")
    for m, colour, marker in zip((0, *MEMBRANES), ("#000000", "#E69F00", "#56B4E9", "#009E73", "#D55E00"), "o^sDv"):
        series = f.series("membrane, same parameters" if m else "same parameters", f"{m:g} N/m" if m else "",
                          "delta_v_ml")
        draw(axes[2], {n: v and 100 * v / series[1] for n, v in series.items()}, f"{m:g} N/m", colour, marker)
    axes[2].set_title("membrane, k_muscle fitted at n = 1", fontsize="medium")
    axes[2].set(ylabel="ΔV over that at n = 1 (%)", ylim=(40, 102))
    for axis in axes:
        axis.set(xlim=(0, 1.04), xlabel="1/n (n = 1: 113 particles)")
        axis.legend(fontsize="small", frameon=False)
    figure.savefig(path, dpi=100)
    plt.close(figure)


def main():
    parser = study_parser(__doc__)
    parser.add_argument("--quick", action="store_true",
                        help="113 and 455 particles, one membrane, 1.5 times longer steps; no picture")
    arguments = parsed(parser)
    with workbench(arguments) as (program, pool):
        mesh = Refinement(program, 1.5 if arguments.quick else 1.0)
        groups = pool.map(lambda task: task(), tasks(mesh, arguments.quick))
        rows = sorted((row for group in groups for row in group),
                      key=lambda row: (row["question"], row["resolution"], row["membrane_N_per_m"], row["change"]))
    write_study(arguments, "mesh", COLUMNS, rows, plot, markdown)


if __name__ == "__main__":
    main()
