"""`trunk report`: the pages hold the numbers of the files, load nothing, and show hostile texts as texts."""

import base64
import hashlib
import re
import unittest
from json import loads

from support import AT_REST, COARSE, FAST_FIT, HEALTHY, ROOT, SCENARIOS, TrunkTest, scenario_with, trace

try:
    import h5py
    import numpy as np
    from report_page import ReportPage, named, positions_m
except ImportError as missing:
    raise unittest.SkipTest(f"{missing}: apt install python3-h5py python3-numpy")

MOST_BYTES = 3_000_000
HOSTILE = '</script><script>window.harmed = 1</script><img src=x onerror="window.harmed = 1"><!-- & \u2028 \\u003c'


class ReportTest(TrunkTest):
    def report(self, *files, output="r.html", options=(), **environment):
        json = self.succeeds("report", *files, "-o", output, *options, **environment)
        page = ReportPage(self.folder / output)
        self.assertEqual(json["bytes"], page.size)
        self.assertLess(page.size, MOST_BYTES)
        self.check_loads_nothing(page)
        return page

    def check_loads_nothing(self, page):
        """The policy in the page forbids it to browsers; nothing in it asks for anything either."""
        policy = re.search(r'http-equiv="Content-Security-Policy" content="([^"]*)"', page.html)[1]
        self.assertIn("default-src 'none'", policy)
        self.assertNotIn("connect-src", policy)
        program = [text for attributes, text in page.scripts if not attributes]
        self.assertEqual(len(program), 1, "scripts that browsers run")
        digest = base64.b64encode(hashlib.sha256(program[0].encode()).digest()).decode()
        self.assertIn(f"script-src 'sha256-{digest}';", policy)
        frame = page.html
        for _, text in page.scripts:
            frame = frame.replace(text, "")
        self.assertNotRegex(frame, r'(?i)(src|href)\s*=\s*"(?!data:)|url\(|@import')
        self.assertNotRegex(program[0], r"\bfetch\(\s*[\"'`]http|XMLHttpRequest\(\)\.open|new WebSocket|sendBeacon")

    def opened(self, name):
        file = h5py.File(self.folder / name)
        self.addCleanup(file.close)
        return file

    def check_run(self, run, group, json=None):
        for name, data in group["measures"].items():
            number = named(run["measures"], name)
            expected = data[()] if np.isfinite(data[()]) else None
            self.assertEqual((number["value"], number["unit"]), (expected, data.attrs["units"].decode()
                             if isinstance(data.attrs["units"], bytes) else data.attrs["units"]), name)
            if json is not None:
                self.assertEqual(number["value"], json[name], name)
        np.testing.assert_array_equal(run["curves"]["time"], group["curves/time"][()])
        self.assertEqual({s["name"] for s in run["curves"]["series"]}, set(group["curves"]) - {"time"})
        for series in run["curves"]["series"]:
            np.testing.assert_array_equal(series["values"], group["curves"][series["name"]][()])
        for series in run["frames"]["series"]:
            np.testing.assert_array_equal(series["values"], group["observables"][series["name"]]["value"][()])
        trajectory, stored = run["trajectory"], group["particles/trajectory/position/value"][()]
        np.testing.assert_allclose(positions_m(trajectory), stored[::trajectory["every"]], rtol=0,
                                   atol=0.6 * trajectory["positions"]["step_m"])
        self.assertLess(trajectory["positions"]["step_m"], 5e-5)
        np.testing.assert_array_equal(trajectory["triangles"]["particles"], group["connectivity/triangles"][()].ravel())
        np.testing.assert_array_equal(trajectory["fibres"]["particles"], group["connectivity/fibres"][()].ravel())


class Run(ReportTest):
    def test_run(self):
        json = self.succeeds("simulate", HEALTHY, "-o", "r.h5", *COARSE)
        page = self.report("r.h5")
        (file,) = page.files
        self.assertEqual((file["kind"], file["name"]), ("run", "r.h5"))
        self.check_run(file["run"], self.opened("r.h5"), json)
        contact = file["run"]["trajectory"]["contact"]
        stored = self.opened("r.h5")["particles/trajectory/contact/value"][()]
        touching = contact["touching"].reshape(-1, len(contact["particles"]))
        np.testing.assert_array_equal(touching, stored[:, contact["particles"]] > 0)
        self.assertEqual(touching.sum(), (stored > 0).sum())
        again = self.report("r.h5", output="again.html")
        self.assertEqual(page.html, again.html, "equal files make equal pages")

    def test_beside_a_measured_surface(self):
        self.succeeds("simulate", HEALTHY, "-o", "r.h5", *COARSE)
        group = self.opened("r.h5")
        points = 1e3 * group["particles/trajectory/position/value"][-1] + (0, 0, 5)
        lung = group["connectivity/triangles"][()][group["connectivity/triangle_component"][()] == 1]
        self.file("lung.obj", "".join("v {} {} {}\n".format(*p) for p in points) +
                  "".join("f {} {} {}\n".format(*t) for t in lung + 1))
        options = ("--surface", "lung.obj", "--axes", "RAS", "--region", "lung", "--at", "end")
        expected = self.succeeds("compare", "r.h5", *options)
        surface = self.report("r.h5", options=options).files[0]["run"]["surface"]
        self.assertEqual((surface["name"], surface["time_s"]), ("lung.obj", expected["time_s"]))
        side = surface["side_mm"]
        self.assertEqual(len(side), len(points))
        np.testing.assert_allclose(side[expected["particles"]], expected["signed_distance_mm"], atol=1e-4)
        self.assertEqual(np.isfinite(side).sum(), len(expected["particles"]))
        self.assertEqual(surface["distances"][0]["rms_mm"], expected["model_to_surface"]["rms_mm"])
        drawn = surface["points_mm"].reshape(-1, 3)[surface["corners"].reshape(-1, 3)]
        self.assertEqual(len(drawn), len(lung))
        np.testing.assert_allclose(drawn.min(axis=(0, 1)), points[np.unique(lung)].min(axis=0), atol=1e-3)

    def test_a_surface_needs_one_run(self):
        self.succeeds("simulate", HEALTHY, "-o", "r.h5", *COARSE)
        self.refused("report", "r.h5", "r.h5", "--surface", "x.stl", "-o", "p.html", says="one run or fit")
        self.refused("report", "r.h5", "--surface", "x.stl", "-o", "p.html", says="x.stl: no such file")
        self.refused("report", "r.h5", "--at", "peak", "-o", "p.html", says="--surface")

    def test_paralysed_fibres_beside_healthy_ones(self):
        self.succeeds("simulate", HEALTHY, "-o", "a.h5", *COARSE)
        self.succeeds("simulate", SCENARIOS / "hemiparalysis_right.toml", "-o", "b.h5", *COARSE)
        page = self.report("a.h5", "b.h5")
        self.assertEqual([f["name"] for f in page.files], ["a.h5", "b.h5"])
        for file in page.files:
            self.check_run(file["run"], self.opened(file["name"]))
        healthy, paralysed = (f["run"]["trajectory"]["fibre_activity"] for f in page.files)
        self.assertTrue((healthy == 1).all())
        self.assertEqual(sorted(set(paralysed)), [0, 0.5, 1])

    def test_more_frames_than_a_page_can_hold(self):
        self.succeeds("simulate", HEALTHY, "-o", "r.h5", "--every", "1")
        trajectory = self.report("r.h5").files[0]["run"]["trajectory"]
        self.assertEqual((trajectory["every"], trajectory["frames"]), (2, 2251))
        self.check_run(self.report("r.h5", output="again.html").files[0]["run"], self.opened("r.h5"))

    def test_summary_without_trajectory(self):
        self.succeeds("simulate", HEALTHY, "-o", "r.h5", *COARSE, "--every", "0")
        run = self.report("r.h5").files[0]["run"]
        self.assertIsNone(run["trajectory"])
        self.assertIsNone(run["frames"])
        self.assertGreater(len(run["curves"]["time"]), 10)

    def test_diverged(self):
        """Its beginning is shown, within a box around the trunk; what has no number is null."""
        own = self.file("own.toml", f'extends = "{HEALTHY}"\n[[force]]\nregion = "central_tendon"\n'
                                    "direction = [0, 0, 1]\nevents_N = [[0, 0], [0.1, 100000]]\n")
        self.succeeds("simulate", own, "-o", "r.h5", *AT_REST, codes=(3,))
        run = self.report("r.h5").files[0]["run"]
        self.assertIn(run["status"], ("diverged", "volume_lost"))
        self.assertIsNone(named(run["measures"], "delta_v_ml")["value"])
        self.assertGreater(run["trajectory"]["frames"], 1)
        self.assertLess(abs(positions_m(run["trajectory"])).max(), 2)

    def test_hostile_texts(self):
        text = scenario_with().replace("title = ", f"title = '''{HOSTILE}''' # ", 1)
        self.file("s.toml", text)
        self.succeeds("simulate", "s.toml", "-o", "r.h5", *COARSE)
        name = "<b>&'\"-.h5"
        (self.folder / "r.h5").rename(self.folder / name)
        page = self.report(name)
        self.assertEqual((page.files[0]["title"], page.files[0]["name"]), (HOSTILE, name))
        self.assertNotIn("<script>window.harmed", page.html)
        self.assertNotIn("<img src=x", page.html)
        self.assertNotIn("<b>&", page.html)

    def test_never_overwrites(self):
        self.succeeds("simulate", HEALTHY, "-o", "r.h5", *COARSE)
        self.report("r.h5")
        self.refused("report", "r.h5", "-o", "r.html", says="--force")
        self.succeeds("report", "r.h5", "-o", "r.html", "--force")
        self.refused("report", "r.h5", "-o", "r.h5", "--force", says="is read by this command")
        self.refused("report", "r.h5", "-o", "nowhere/r.html", says="folder does not exist")

    def test_bad_files(self):
        self.succeeds("simulate", HEALTHY, "-o", "r.h5", *COARSE)
        whole = (self.folder / "r.h5").read_bytes()
        flipped = bytearray(whole)
        flipped[len(whole) // 2] ^= 8
        for name, content in (("empty.h5", b""), ("text.h5", b"hello, this is no HDF5\n"), ("cut.h5", whole[:len(whole) // 2]),
                              ("flipped.h5", bytes(flipped))):
            self.file(name, content)
            with self.subTest(name):
                self.refused("report", name, "-o", "p.html", says=name)
        with h5py.File(self.folder / "foreign.h5", "w") as foreign:
            foreign["x"] = 1
        self.refused("report", "foreign.h5", "-o", "p.html", says="another program")
        self.refused("report", "r.h5", "absent.h5", "-o", "p.html", says="absent.h5: no such file")
        self.refused("report", "r.h5", "r.h5", "r.h5", "-o", "p.html", says="FILE")

    def test_numbers_that_do_not_exist(self):
        """Written by a stranger with our attributes: indices beyond the particles, codes without meaning."""
        self.succeeds("simulate", HEALTHY, "-o", "r.h5", *COARSE)
        for path, value in (("connectivity/triangles", 113), ("connectivity/fibres", -1), ("particles/trajectory/species", 99)):
            with self.subTest(path):
                (self.folder / "bad.h5").write_bytes((self.folder / "r.h5").read_bytes())
                with h5py.File(self.folder / "bad.h5", "r+") as file:
                    data = file[path]
                    data[(0,) * data.ndim] = value
                self.refused("report", "bad.h5", "-o", "p.html", says="bad.h5.*damaged")


class Fit(ReportTest):
    def test_fit(self):
        self.file("t.csv", trace())
        json = self.succeeds("fit", HEALTHY, "--trace", "t.csv", "-o", "f.h5", *FAST_FIT, "--surface", "5", codes=(0, 4))
        stored = self.opened("f.h5")
        (file,) = self.report("f.h5").files
        fit = file["fit"]
        self.assertEqual(fit["result"]["verdict"], json["verdict"])
        for key in ("grade", "input", "notes"):
            self.assertEqual(fit["result"][key], json[key])
        self.assertEqual([r["name"] for r in fit["results"]], list(json["results"]))
        for kind, of_json in (("results", json["results"]), ("straight", json["straight_activation"])):
            for result in fit[kind]:
                self.assertEqual([result[k] for k in ("value", "lower95", "upper95", "grade")],
                                 [of_json[result["name"]][k] for k in ("value", "lower95", "upper95", "grade")])
        first = fit["surface"]["first"]
        self.assertEqual(first["region95"], list(json["surface"]["joint95"][first["name"]].values()))
        for name, estimate in json["parameters"].items():
            shown = named(fit["parameters"], name)
            self.assertEqual([shown[k] for k in ("best", "stderr", "lower95", "upper95", "at_bound")],
                             [estimate[k] for k in ("value", "stderr", "lower95", "upper95", "at_bound")])
        for name in ("nrmse_percent", "baseline_nrmse_percent", "residual_autocorrelation"):
            self.assertEqual(named(fit["result"]["statistics"], name)["value"], json[name])
        for name in ("dV_fit", "residual", "dV_baseline"):
            np.testing.assert_allclose(fit["result"][name], stored["result"][name][()], rtol=1e-14)
        np.testing.assert_allclose(fit["measured"]["measured"], stored["problem/measured"][()], rtol=1e-14)
        np.testing.assert_array_equal(fit["objective"], stored["evaluations/objective"][()])
        np.testing.assert_array_equal(fit["surface"]["deviance"], stored["surface/deviance"][()].ravel())
        self.assertEqual(fit["surface"]["first"]["values"], list(stored["surface/first"][()]))
        self.assertEqual({p["name"] for p in fit["profiles"]}, set(stored.get("profiles", ())))
        self.check_run(file["run"], stored["best_run"])


class Sweep(ReportTest):
    def test_sweep(self):
        design = self.file("s.toml", f'schema = "trunk.sweep/1"\nscenarios = ["{HEALTHY}"]\n[grid]\n'
                                     '"parameters.k_muscle_N_per_m" = [20, 30.5]\n"time.dt_ms" = [3, 20]\n'
                                     '"time.duration_s" = [0.3]\n')
        self.succeeds("sweep", design, "-o", "d", codes=(3,))
        stored = self.opened("d/sweep.h5")
        (file,) = self.report("d/sweep.h5").files
        sweep = file["sweep"]
        self.assertEqual((sweep["runs"], sweep["rows"], sweep["status"]), (4, 4, ["completed", "invalid"] * 2))
        for column in sweep["columns"]:
            expected = stored["table"][column["name"]][()]
            self.assertEqual(column["values"], [v if np.isfinite(v) else None for v in expected])
        np.testing.assert_allclose(sweep["curves"]["values"].reshape(4, -1), stored["curves/dV"][()], rtol=1e-6)
        self.succeeds("simulate", HEALTHY, "-o", "r.h5", *COARSE)
        self.refused("report", "r.h5", "d/sweep.h5", "-o", "p.html", says="sweep.h5: is a sweep")


class Source(unittest.TestCase):
    """The page that is checked in, which no build of the program makes."""

    FOLDER = ROOT / "scripts" / "report_page"

    def test_is_made_of_the_sources_beside_it(self):
        names = ["build.mjs", "package-lock.json", "package.json", "page.in.html",
                 *sorted(f"src/{p.name}" for p in (self.FOLDER / "src").iterdir())]
        lines = "".join(f"{hashlib.sha256((self.FOLDER / name).read_bytes()).hexdigest()}  {name}\n" for name in names)
        self.assertIn(f"sources sha256 {hashlib.sha256(lines.encode()).hexdigest()}", (self.FOLDER / "page.html").read_text(),
                      "run scripts/build_report_page")

    def test_holds_the_licences_of_what_is_in_it(self):
        page = (self.FOLDER / "page.html").read_text()
        versions = loads((self.FOLDER / "package.json").read_text())["devDependencies"]
        for name in ("three", "uplot"):
            self.assertIn(f"{name} {versions[name]}", page)
        self.assertEqual(page.count("Permission is hereby granted"), 2)


if __name__ == "__main__":
    unittest.main()
