#!/usr/bin/python3
"""How much do results depend on the triangles, with rings and as a sheet?

The same trunk is triangulated in five ways: as the template is, with the other diagonal everywhere, with all diagonals
one way, with diagonals by turns, and with every other row of the abdominal wall slid by half a spacing. Each is refined
from 113 to 1835 particles. The paper's subject is a sixth mesh; the diaphragm of Debian's libcamitk4-data (--surface)
gives it finer ones. The study answers these questions, for tissue.elasticity = "ring" and "sheet":

  * How much volume does the muscle hold, at the same parameters?
  * How much does it breathe, at the same parameters, and how does the shape change at the same tidal volume?
  * Which k_elasticity does one trace give, on the template and on the paper's subject?

It writes sheet.csv (all runs) and prints the Markdown tables of libtrunk/sheet/README.md, in about ten minutes.

    scripts/study_sheet.py -o reference --surface diaphragm.pml
"""

import math
import pathlib
import re
import subprocess
import tempfile

from studies import ROOT, options, parsed, study_parser, workbench, write_csv

LAWS = ("ring", "sheet")
RESOLUTIONS, SUBJECT_RESOLUTIONS, COMPARED = (1, 2, 3, 4), (1, 2, 3), 2
STEP_MS = {1: 1.0, 2: 0.6, 3: 0.4, 4: 0.25}  # below what is stable on all meshes
PATTERNS = ("template", "other diagonals", "one way", "by turns", "slid rows")
SUBJECT = "craighero"
K_ELASTICITY, K_MUSCLE = "parameters.k_elasticity_N_per_m", "parameters.k_muscle_N_per_m"
K_ELASTICITY_N_PER_M, K_MUSCLE_N_PER_M = 4000.0, 27.2207  # those of scenarios/healthy_no_lung.toml, for all meshes
HELD = {"activation.rise_s": 1.5, "activation.fast_fall_level": 1, "activation.fast_fall_s": 3, "time.duration_s": 3}
TIDAL_ML, CLOSE = 466, 1e-4
MEASURES = {"particles": "particles", "delta_v_ml": "delta_v_ml", "delta_l_mm": "delta_l_mm",
            "delta_h_mm": "delta_h_mm", "delta_r_mm": "delta_r_mm", "excursion_right_mm": "right_dome_descends_mm",
            "excursion_left_mm": "left_dome_descends_mm", "abdominal_pressure_peak_cmH2O": "pressure_cmH2O"}
COLUMNS = ["question", "elasticity", "mesh", "resolution", *MEASURES.values(), "k_elasticity_N_per_m",
           "k_muscle_N_per_m", "status"]


def wall_rows(n):
    """Returns the rows of equal count from the pelvis to the border of the tendon, as lists of particles."""
    first, around = 1 + 6 * n * (n - 1), 12 * n
    return [list(range(first + row * around, first + (row + 1) * around)) for row in range(6 * n + 1)]


def backward(pattern, row, column, around):
    """Returns whether the diagonal of a cell goes back as it goes up."""
    if pattern == "one way":
        return False
    if pattern == "by turns":
        return (row + column) % 2 == 0
    as_template = math.sin(4 * math.pi * (column + 0.5) / around) > 0
    return as_template != (pattern == "other diagonals")


def slid(row, n):
    """Returns whether a row of the abdominal wall is slid; its border rows are not."""
    return 0 < row < 3 * n and (3 * n - row) % 2 == 1


def cells(pattern, n):
    """Returns the triangles between the rows, outward, by the row below."""
    rows, around = wall_rows(n), 12 * n
    found = {}
    for row, (lower, upper) in enumerate(zip(rows, rows[1:])):
        shift = (slid(row, n), slid(row + 1, n)) if pattern == "slid rows" else (False, False)
        for column in range(around):
            a, b = lower[column], lower[(column + 1) % around]
            d, c = upper[column], upper[(column + 1) % around]
            if shift[0] == shift[1]:
                back = backward("template" if pattern == "slid rows" else pattern, row, column, around)
            else:
                back = shift[1]
            found.setdefault(row, []).extend([(a, b, d), (b, c, d)] if back else [(a, b, c), (a, c, d)])
    return found


def set_surface(text, name, kept, added):
    """Returns a PML with other triangles in a surface: those that it has and that are `kept`, and the added ones."""
    block = re.search(rf'<structuralComponent name="{name}"[^>]*>(.*?)</structuralComponent>', text, re.S)
    triangles = [tuple(map(int, re.findall(r'index="(\d+)"', cell))) for cell in block[1].split("</cell>")[:-1]]
    triangles = [t for t in triangles if kept(t)] + added
    body = f'\n<nrOfStructures value="{len(triangles)}" />\n' + "".join(
        '<cell>\n<cellProperties type="TRIANGLE" />\n<nrOfStructures value="3" />\n'
        + "".join(f'<atomRef index="{i}" />\n' for i in t) + "</cell>\n" for t in triangles)
    return text[:block.start(1)] + body + text[block.end(1):]


def triangulated(text, pattern, n):
    """Returns the template's PML with the triangles of a pattern, and without values of single particles."""
    text = re.sub(r' (?:mass|stiffness|damping|strength)="[^"]*"', "", text)
    rows, found = wall_rows(n), cells(pattern, n)
    row_of = {i: row for row, particles in enumerate(rows) for i in particles}

    def kept_above(lowest):
        def kept(t):
            on = {row_of.get(i, -1) for i in t}
            return not (len(on) == 2 and min(on) >= lowest and max(on) == min(on) + 1)
        return kept
    dome = [(a, c, b) for row, triangles in found.items() if row >= 5 * n for a, b, c in triangles]
    text = set_surface(text, "abdomen", kept_above(0), sum(found.values(), []))
    text = set_surface(text, "lung", kept_above(5 * n), dome)
    if pattern == "slid rows":
        text = slide(text, n)
    return text


def slide(text, n):
    """Returns the PML with every other row of the wall moved along its ellipse by half a spacing."""
    place = {int(i): [float(x), float(y)]
             for i, x, y in re.findall(r'<atomProperties index="(\d+)" x="(\S+)" y="(\S+)"', text)}
    half = math.pi / (12 * n)
    for row, particles in enumerate(wall_rows(n)):
        if not slid(row, n):
            continue
        wide, deep = place[particles[0]][0], place[particles[3 * n]][1]
        for column, i in enumerate(particles):
            angle = (2 * column + 1) * half
            text = re.sub(rf'(<atomProperties index="{i}") x="\S+" y="\S+"',
                          rf'\1 x="{wide * math.cos(angle):.17g}" y="{deep * math.sin(angle):.17g}"', text, count=1)
    return text


class Meshes:
    """Makes the meshes once each, as scenarios."""

    def __init__(self, program, folder, surface):
        self.program, self.folder, self.surface = program, pathlib.Path(folder), surface
        self.scenarios = {}

    def trunk(self, *arguments):
        subprocess.run([self.program.path, *map(str, arguments)], check=True, capture_output=True, text=True)

    def make(self, mesh, n):
        if mesh == SUBJECT and n == 1:
            scenario = self.folder / "subject1.toml"
            scenario.write_text(f'schema = "trunk.scenario/1"\nextends = "{ROOT}/scenarios/healthy_no_lung.toml"\n'
                                f'[geometry]\npml = "{ROOT}/scenarios/craighero.pml"\n', encoding="utf-8")
        elif mesh == SUBJECT:
            scenario = self.folder / f"subject{n}.toml"
            self.trunk("register", ROOT / "scenarios" / "healthy_no_lung.toml", "--surface", self.surface, "--axes", "LSA", "--surface-unit", "mm",
                       "--resolution", n, "-o", scenario.with_suffix(".pml"))
        else:
            scenario = self.triangulation(mesh, n)
        self.scenarios[mesh, n] = scenario

    def triangulation(self, pattern, n):
        name = f"{pattern.replace(' ', '_')}{n}"
        run, folder = self.folder / f"{name}.h5", self.folder / name
        self.trunk("simulate", ROOT / "scenarios" / "healthy_no_lung.toml", "-o", run, "--set", f"geometry.resolution={n}",
                   "--set", "time.duration_s=0.001", "--set", "time.dt_ms=0.1")
        self.trunk("export", run, "--pml", folder)
        run.unlink()
        path = folder / "trunk.pml"
        path.write_text(triangulated(path.read_text(encoding="utf-8"), pattern, n), encoding="utf-8")
        scenario = folder / "trunk.toml"
        scenario.write_text(f'schema = "trunk.scenario/1"\nextends = "{ROOT}/scenarios/healthy_no_lung.toml"\n'
                            '[geometry]\npml = "trunk.pml"\n', encoding="utf-8")
        return scenario


class Study:
    def __init__(self, program, meshes):
        self.program, self.meshes = program, meshes

    def run(self, question, law, mesh, n, settings=None, paralysed=False):
        """Returns a row of the table."""
        chosen = {K_ELASTICITY: K_ELASTICITY_N_PER_M, K_MUSCLE: K_MUSCLE_N_PER_M, "tissue.elasticity": law,
                  "time.dt_ms": STEP_MS[n], "time.frame_every_ms": 0} | (settings or {})
        if paralysed:
            chosen["paralysis.side"] = "right"
        result, status = self.program("simulate", self.meshes.scenarios[mesh, n], *options(chosen))
        row = dict.fromkeys(COLUMNS, "") | {"question": question, "elasticity": law, "mesh": mesh, "resolution": n,
                                            "k_elasticity_N_per_m": chosen[K_ELASTICITY],
                                            "k_muscle_N_per_m": chosen[K_MUSCLE], "status": status}
        return row | {to: result[name] for name, to in MEASURES.items()} if result else row

    def held(self, law, mesh, n):
        return [self.run("held", law, mesh, n, HELD)]

    def breath(self, law, mesh, n):
        return [self.run("breath", law, mesh, n)]

    def matched(self, law, mesh, n):
        """Returns the row with the k_muscle for the tidal volume, and its paralysed twin."""
        before, at = None, K_MUSCLE_N_PER_M * 1.3
        for _ in range(12):
            row = self.run("466 ml", law, mesh, n, {K_MUSCLE: at})
            if row["status"] != "completed":
                return [row]
            miss = row["delta_v_ml"] / TIDAL_ML - 1
            if abs(miss) < CLOSE:
                return [row, self.run("466 ml, right paralysed", law, mesh, n, {K_MUSCLE: at}, paralysed=True)]
            slope = (miss - before[1]) / (at - before[0]) if before else 1 / at
            before, at = (at, miss), at - miss / slope
        return [row | {"status": "tidal volume not reached"}]

    def fitted(self, law, mesh, n):
        """Returns what one trace gives."""
        settings = {"tissue.elasticity": law, "time.dt_ms": STEP_MS[n]}
        result, status = self.program("fit", self.meshes.scenarios[mesh, n], "--trace",
                                      ROOT / "reference" / "constructed_trace.csv", *options(settings), "--draws", 0)
        row = dict.fromkeys(COLUMNS, "") | {"question": "one trace", "elasticity": law, "mesh": mesh, "resolution": n,
                                            "status": status}
        if result:
            for name in ("k_elasticity", "k_muscle"):
                row[f"{name}_N_per_m"] = result["parameters"][name]["value"]
        return [row]


def tasks(study, quick, subjects):
    """Returns the independent parts of the study, slow ones first."""
    def part(function, *arguments):
        return lambda: function(*arguments)

    if quick:
        return [part(study.held, "sheet", mesh, 3) for mesh in PATTERNS]
    found = []
    for law in LAWS:
        for n in reversed(RESOLUTIONS):
            found += [part(study.held, law, mesh, n) for mesh in PATTERNS]
            found += [part(study.breath, law, mesh, n) for mesh in PATTERNS]
            found += [part(study.matched, law, mesh, n) for mesh in PATTERNS if n == COMPARED or mesh == "template"]
        for n in subjects:
            found += [part(study.held, law, SUBJECT, n), part(study.breath, law, SUBJECT, n)]
            found += [part(study.matched, law, SUBJECT, n)] if n <= COMPARED else []
        found += [part(study.fitted, law, mesh, n) for mesh in ("template", SUBJECT) for n in subjects
                  if n <= COMPARED]
    return found


def spread(volumes):
    """Returns the largest over the smallest, less 1, in %."""
    return 100 * (max(volumes) / min(volumes) - 1)


def volume_table(rows, question):
    lines = [f"| {question}: ΔV ml at resolution | " + " | ".join(map(str, RESOLUTIONS)) + " |", "|---|---|---|---|---|"]
    volume = {(r["elasticity"], r["mesh"], r["resolution"]): r["delta_v_ml"] for r in rows
              if r["question"] == question and r["status"] == "completed"}
    for law in LAWS:
        for mesh in (*PATTERNS, SUBJECT):
            cells_of = [f"{volume[law, mesh, n]:.0f}" if (law, mesh, n) in volume else "" for n in RESOLUTIONS]
            if any(cells_of):
                lines.append(f"| {law}, {mesh} | " + " | ".join(cells_of) + " |")
        if not any(key[0] == law for key in volume):
            continue
        spreads = [[volume[law, mesh, n] for mesh in PATTERNS if (law, mesh, n) in volume] for n in RESOLUTIONS]
        lines.append(f"| **{law}: spread of the five, %** | "
                     + " | ".join(f"{spread(v):.1f}" if len(v) == len(PATTERNS) else "" for v in spreads) + " |")
    return lines


def shape_table(rows):
    lines = ["| at 466 ml | k_muscle | ΔL mm | ΔH mm | ΔR mm | cmH2O | paralysed: ΔV % | its dome mm |",
             "|---|---|---|---|---|---|---|---|"]
    twin = {(r["elasticity"], r["mesh"], r["resolution"]): r for r in rows if "paralysed" in r["question"]}
    for r in rows:
        other = twin.get((r["elasticity"], r["mesh"], r["resolution"]))
        if r["question"] == "466 ml" and other and other["status"] == "completed":
            lines.append(f"| {r['elasticity']}, {r['mesh']}, {r['resolution']} | {r['k_muscle_N_per_m']:.1f} "
                         f"| {r['delta_l_mm']:.2f} | {r['delta_h_mm']:.2f} | {r['delta_r_mm']:.2f} "
                         f"| {r['pressure_cmH2O']:.1f} | {100 * other['delta_v_ml'] / r['delta_v_ml']:.0f} "
                         f"| {other['right_dome_descends_mm']:.1f} |")
    return lines


def trace_table(rows):
    lines = ["| one trace: k_elasticity N/m | template | paper's subject | ratio |", "|---|---|---|---|"]
    found = {(r["elasticity"], r["resolution"], r["mesh"]): r["k_elasticity_N_per_m"] for r in rows
             if r["question"] == "one trace" and r["status"] == "completed"}
    for law in LAWS:
        for n in SUBJECT_RESOLUTIONS:
            pair = [found.get((law, n, mesh)) for mesh in ("template", SUBJECT)]
            if all(pair):
                lines.append(f"| {law}, resolution {n} | {pair[0]:.0f} | {pair[1]:.0f} | {pair[1] / pair[0]:.2f} |")
    return lines


def main():
    parser = study_parser(__doc__)
    parser.add_argument("--surface", type=pathlib.Path, metavar="FILE",
                        help="diaphragm.pml of libcamitk4-data, for finer meshes of the paper's subject")
    parser.add_argument("--quick", action="store_true",
                        help="only the volumes that a sheet holds at resolution 3")
    arguments = parsed(parser)
    subjects = () if arguments.quick else SUBJECT_RESOLUTIONS if arguments.surface else (1,)
    with workbench(arguments) as (program, pool), tempfile.TemporaryDirectory() as folder:
        meshes = Meshes(program, folder, arguments.surface)
        wanted = [(mesh, n) for mesh in PATTERNS for n in ((3,) if arguments.quick else RESOLUTIONS)]
        list(pool.map(lambda pair: meshes.make(*pair), wanted + [(SUBJECT, n) for n in subjects]))
        groups = pool.map(lambda task: task(), tasks(Study(program, meshes), arguments.quick, subjects))
        order = (*PATTERNS, SUBJECT)
        rows = sorted((row for group in groups for row in group),
                      key=lambda r: (r["question"], r["elasticity"], order.index(r["mesh"]), r["resolution"]))
    arguments.output.mkdir(parents=True, exist_ok=True)
    write_csv(arguments.output / "sheet.csv", COLUMNS, rows)
    tables = [volume_table(rows, "held")]
    if not arguments.quick:
        tables += [volume_table(rows, "breath"), shape_table(rows), trace_table(rows)]
    print("\n\n".join("\n".join(table) for table in tables))


if __name__ == "__main__":
    main()
