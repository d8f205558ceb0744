"""What other programs read in the files: h5py, xarray (h5netcdf) group by group, pandas; equal to the JSON."""

import math
import unittest

from support import COARSE, FAST_FIT, HEALTHY, TrunkTest, trace

try:
    import h5py
    import numpy as np
    import pandas
    import xarray
except ImportError as missing:
    raise unittest.SkipTest(f"{missing}: apt install python3-h5py python3-xarray python3-h5netcdf python3-pandas")


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


class ResultsTest(TrunkTest):
    def opened(self, name):
        file = h5py.File(self.folder / name)
        self.addCleanup(file.close)
        return file

    def group(self, name, group):
        data = xarray.open_dataset(self.folder / name, engine="h5netcdf", group=group)
        self.addCleanup(data.close)
        return data

    def check_file(self, name, kind):
        """What holds for all three: complete, no handle left behind, every group opens, every number has a unit."""
        file = self.opened(name)
        self.assertEqual(int(file.attrs["complete"]), 1)
        self.assertEqual((text(file.attrs["schema"]), int(file.attrs["schema_version"])), (f"trunk.{kind}", 2 if kind == "fit" else 1))
        groups, datasets = [], []
        file.visititems(lambda path, o: (groups if isinstance(o, h5py.Group) else datasets).append(path))
        beside = tuple("parameters/" + name for name in ("initial", "lower", "upper", "best", "stderr", "lower95", "upper95",
                                                       "naive_lower95", "naive_upper95"))
        beside += ("problem/bounds", "evaluations/x", "draws/value", "starts/from", "starts/to",
                   *(f"{group}/{name}" for group in ("results", "straight_activation")
                     for name in ("value", "lower95", "upper95")))  # their units stand in a column beside them
        data = {path: file[path] for path in datasets}
        self.assertEqual([path for path, d in data.items() if d.dtype.kind == "f" and "units" not in d.attrs
                          and not path.endswith(beside)], [])
        self.assertEqual([path for path, d in data.items() if not h5py.h5ds.is_scale(d.id)
                          and any(len(d.dims[axis]) != 1 for axis in range(d.ndim))], [], "axes without a scale")
        for path in ["/", *groups]:
            with self.subTest(path):
                self.group(name, path).load()
        self.assertEqual(text(file["provenance"].attrs["software"]), "trunk")
        return file


class Run(ResultsTest):
    def test_run(self):
        json = self.succeeds("simulate", HEALTHY, "-o", "r.h5", *COARSE)
        file = self.check_file("r.h5", "run")
        self.assertEqual([int(v) for v in file["h5md"].attrs["version"]], [1, 1])
        for name, data in file["measures"].items():
            self.assertEqual(data[()], json[name], name)
        frames, particles = file["particles/trajectory/position/value"].shape[:2]
        self.assertEqual((particles, frames), (json["particles"], 34))  # every third step of 3 ms
        curves = self.group("r.h5", "curves")
        self.assertEqual(curves.sizes["time"], json["steps"] + 1)
        self.assertEqual(curves["dV_model"].attrs["units"], "ml")
        frame = curves.to_dataframe()
        self.assertIsInstance(frame, pandas.DataFrame)
        self.assertAlmostEqual(frame["dV_model"].max(), json["delta_v_ml"], delta=1e-9)
        self.assertAlmostEqual(frame["abdominal_pressure"].max(), json["abdominal_pressure_peak_cmH2O"], delta=1e-9)
        self.assertEqual(frame["dV_model"].iloc[0], 0)
        self.assertAlmostEqual(frame["activation"].max(), 0.3 / 2, delta=0.002)  # 0.3 s of a rise of 2 s
        position = file["particles/trajectory/position"]
        self.assertEqual(text(position["value"].attrs["units"]), "m")
        self.assertTrue(np.isfinite(position["value"][()]).all())
        self.assertAlmostEqual(float(position["time"][-1]), 0.3, delta=0.01)
        self.assertEqual(position["time"][0], 0)

    def test_volume_from_the_particles(self):
        """The stored surface of the lung, closed, encloses the stored volume."""
        json = self.succeeds("simulate", HEALTHY, "-o", "r.h5", *COARSE)
        file = self.opened("r.h5")
        lung = file["connectivity/triangles"][()][file["connectivity/triangle_component"][()] == 1]
        def volume(x):
            return abs(np.einsum("ij,ij->i", x[lung[:, 0]], np.cross(x[lung[:, 1]], x[lung[:, 2]])).sum() / 6) * 1e6
        frames = file["particles/trajectory/position/value"]
        self.assertAlmostEqual(volume(frames[0]), json["end_expiratory_volume_ml"], delta=0.01)
        stored = file["observables/dV/value"]
        for at in (len(frames) // 2, -1):
            self.assertAlmostEqual(volume(frames[at]) - volume(frames[0]), stored[at], delta=0.01)

    def test_the_stored_scenario_repeats_the_run(self):
        json = self.succeeds("simulate", HEALTHY, "-o", "r.h5", *COARSE, "--set", "paralysis.side=left")
        self.file("again.toml", text(self.opened("r.h5")["parameters/scenario_toml"][()]))
        again = self.succeeds("simulate", "again.toml", "-o", "s.h5")
        for key in set(json) - {"wall_s"}:
            if isinstance(json[key], float):
                self.assertAlmostEqual(json[key], again[key], delta=1e-9 * (1 + abs(json[key])), msg=key)
            else:
                self.assertEqual(json[key], again[key])


class Fit(ResultsTest):
    def test_fit(self):
        self.file("t.csv", trace())
        json = self.succeeds("fit", HEALTHY, "--trace", "t.csv", "-o", "f.h5", *FAST_FIT, codes=(0, 4))
        file = self.check_file("f.h5", "fit")
        table = self.group("f.h5", "parameters").drop_dims(["covariance_row", "covariance_column"]).to_dataframe()
        self.assertEqual(set(table.index[table["free"] == 1]), set(json["parameters"]))
        for name, estimate in json["parameters"].items():
            row = table.loc[name]
            for key, column in (("value", "best"), ("stderr", "stderr"), ("lower95", "lower95"), ("upper95", "upper95"),
                                ("at_bound", "at_bound")):
                self.assertEqual(row[column], estimate[key], (name, key))
            self.assertTrue(row["lower"] <= row["best"] <= row["upper"])
        for name, data in file["result/statistics"].items():
            expected = json["ratio"][{"ratio": "value", "ratio_lower95": "lower95", "ratio_upper95": "upper95"}[name]] \
                if name.startswith("ratio") else json[name] if name != "methods_differ_percent" \
                else json["cross_check"]["largest_difference_percent"]
            self.assertEqual(data[()], expected, name)
        self.assertEqual(text(file["result"].attrs["verdict"]), json["verdict"])
        results = self.group("f.h5", "results").to_dataframe()
        self.assertEqual(list(results.index), list(json["results"]))
        for name, result in json["results"].items():
            row = results.loc[name]
            for key in ("value", "lower95", "upper95"):
                self.assertEqual(row[key], result[key] if result[key] is not None else math.inf, (name, key))
            for key in ("grade", "assumption", "reason", "meaning"):
                self.assertEqual(row[key], result[key] or "", (name, key))
        shown = results[results["headline"] > 0].sort_values("headline")
        self.assertEqual(list(shown.index), json["headline"])
        self.assertEqual(text(file["results"].attrs["grade"]), json["grade"])
        straight = self.group("f.h5", "results/straight_activation")
        self.assertEqual(float(straight["nrmse_percent"]), json["straight_activation"]["nrmse_percent"])
        for name, value in zip(straight["name"].values, straight["value"].values):
            self.assertEqual(value, json["straight_activation"][text(name)]["value"])
        self.assertEqual(text(file["problem"].attrs["input"]), "t.csv")
        self.assertEqual([text(note) for note in file["result/notes"][()]] if "notes" in file["result"] else [], json["notes"])
        evaluations = self.group("f.h5", "evaluations")
        self.assertEqual(evaluations.sizes["evaluation"], json["evaluations"])
        result, problem = self.group("f.h5", "result"), self.group("f.h5", "problem")
        residual = result["residual"].values
        np.testing.assert_allclose(residual, result["dV_fit"].values - problem["measured"].values, atol=1e-9)
        nrmse = 100 * math.sqrt((residual ** 2).mean()) / json["tidal_volume_measured_ml"]
        self.assertAlmostEqual(nrmse, json["nrmse_percent"], delta=1e-9)
        best = self.group("f.h5", "best_run/curves")
        self.assertAlmostEqual(float(best["dV_model"].interp(time=result["time"][100])),
                               float(result["dV_fit"][100]), delta=0.5)
        sd = [estimate["stderr"] / estimate["value"] for estimate in json["parameters"].values()]
        np.testing.assert_allclose(np.sqrt(np.diag(file["parameters/covariance"])), sd, rtol=1e-6)
        for row in json["correlation"]:
            self.assertTrue(all(abs(c) <= 1 + 1e-12 for c in row))


class Sweep(ResultsTest):
    def test_sweep(self):
        design = self.file("s.toml", f'schema = "trunk.sweep/1"\nscenarios = ["{HEALTHY}"]\n[grid]\n'
                                     '"parameters.k_muscle_N_per_m" = [20, 30.5]\n"time.dt_ms" = [3, 20]\n'
                                     '"time.duration_s" = [0.3]\n')
        json = self.succeeds("sweep", design, "-o", "d", codes=(3,))
        file = self.check_file("d/sweep.h5", "sweep")
        csv = pandas.read_csv(self.folder / "d/table.csv", index_col="run", float_precision="round_trip")
        table = self.group("d/sweep.h5", "table").to_dataframe()
        self.assertEqual((len(csv), list(csv["status"])), (json["runs"], ["completed", "invalid"] * 2))
        self.assertEqual(list(csv["parameters.k_muscle_N_per_m"]), [20, 20, 30.5, 30.5])
        for column in csv.columns:
            if csv[column].dtype.kind == "f":
                np.testing.assert_array_equal(csv[column], table[column], column)
        self.assertEqual(text(file["table/parameters.k_muscle_N_per_m"].attrs["units"]), "N m-1")
        curves = self.group("d/sweep.h5", "curves")
        self.assertEqual(dict(curves.sizes), {"run": 4, "time": 31})
        self.assertTrue(np.isnan(curves["dV"][1]).all())
        # From 10 ms rows of a curve in 3 ms steps: each the first at or after, so the last may miss the peak.
        self.assertAlmostEqual(float(curves["dV"][2].max()), csv["delta_v_ml"][2], delta=1)
        self.assertEqual(sorted(file["runs"]), ["00000", "00002"])
        self.assertEqual(file["runs/00002/measures/delta_v_ml"][()], csv["delta_v_ml"][2])


if __name__ == "__main__":
    unittest.main()
