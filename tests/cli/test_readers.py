"""Programs of others open files written by the real one: h5py, h5dump, xarray, netCDF4, MDAnalysis, VTK. Numbers are
held against the JSON of the command that wrote the file."""

import importlib.util
import shutil
import subprocess
import unittest
import warnings
import xml.etree.ElementTree as ElementTree

from support import FAST_FIT, HEALTHY, Outcome, TrunkTest, start, trace

try:
    import h5py
    import numpy as np
except ImportError as missing:
    raise unittest.SkipTest(f"{missing}: apt install python3-h5py")

warnings.simplefilter("ignore", DeprecationWarning)
POSITION = "particles/trajectory/position/value"
SHORT = ("--set", "time.dt_ms=2", "--set", "time.duration_s=2.4")  # past end-inspiration


def needs(module, package):
    return unittest.skipUnless(importlib.util.find_spec(module), f"needs {package}")


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


class Written(TrunkTest):
    """A run and a fit, once for all."""

    def files(self):
        for name in (self.run_file, self.fit_file):
            with self.subTest(name):
                yield name

    def check_volume(self, points, triangles, frame):
        """The tidal volume as the program says, from the surface of the lung as a reader sees it."""
        def volume(x):
            return abs(np.einsum("ij,ij->i", x[triangles[:, 0]], np.cross(x[triangles[:, 1]], x[triangles[:, 2]])).sum() / 6)
        self.assertAlmostEqual(1e6 * (volume(points(frame)) - volume(points(0))), self.run_json["delta_v_ml"], delta=0.2)

    @staticmethod
    def peak(path):
        with h5py.File(path) as file:
            return int(file["observables/dV/value"][()].argmax())

    @staticmethod
    def lung(path):
        with h5py.File(path) as file:
            return file["connectivity/triangles"][()][file["connectivity/triangle_component"][()] == 1]


def setUpModule():
    maker = Written()
    maker.setUp()
    unittest.addModuleCleanup(maker.doCleanups)
    maker.file("t.csv", trace())
    Written.run_json = maker.succeeds("simulate", HEALTHY, "-o", "run.h5", *SHORT)
    Written.fit_json = maker.succeeds("fit", HEALTHY, "--trace", "t.csv", "-o", "fit.h5", *FAST_FIT, codes=(0, 4))
    Written.made, Written.positions = maker.folder, {}
    Written.run_file, Written.fit_file = str(maker.folder / "run.h5"), str(maker.folder / "fit.h5")
    for name in (Written.run_file, Written.fit_file):
        with h5py.File(name) as file:
            Written.positions[name] = file[POSITION][()]


class H5py(Written):
    def test_run(self):
        with h5py.File(self.run_file) as file:
            for name, data in file["measures"].items():
                self.assertEqual(data[()], self.run_json[name], name)
            frames = file[POSITION]
            self.check_volume(lambda i: frames[i], self.lung(self.run_file), self.peak(self.run_file))
            self.assertAlmostEqual(file["observables/dV/value"][()].max(), self.run_json["delta_v_ml"], delta=0.2)
            peak = self.peak(self.run_file)
            for name, key in (("dL", "delta_l_mm"), ("dH", "delta_h_mm"), ("excursion_right", "excursion_right_mm")):
                self.assertAlmostEqual(file[f"observables/{name}/value"][peak], self.run_json[key], delta=0.02, msg=name)
            contact = file["particles/trajectory/contact/value"][()]
            self.assertEqual(text(file["particles/trajectory/contact/value"].attrs["flag_meanings"]), "none slides sticks")
            ribs = file["particles/trajectory/species"].attrs["flag_meanings"]
            apposed = text(ribs).split().index("zone_of_apposition") == file["particles/trajectory/species"][()]
            self.assertTrue(contact[:, apposed].any())
            self.assertFalse(contact[:, ~apposed].any())
            self.assertEqual(file["connectivity/fibre_activity"][()].tolist(), [1.0] * 12)

    def test_every_chunk_is_checksummed(self):
        for path in self.files():
            with h5py.File(path) as file:
                found = []
                file.visititems(lambda name, o: found.append((name, o)) if isinstance(o, h5py.Dataset) and o.chunks else None)
                self.assertGreater(len(found), 30)
                self.assertEqual([n for n, d in found if not (d.fletcher32 and d.shuffle and d.compression == "gzip")], [])

    def layouts(self, path):
        found = {}
        with h5py.File(path) as file:
            file.visititems(lambda name, o: found.setdefault(o.id.get_create_plist().get_layout(), []).append(name)
                            if isinstance(o, h5py.Dataset) else None)
        return found

    def test_layouts_that_ncdf4_knows(self):
        """R's ncdf4 opens a file if every dataset is chunked or contiguous."""
        known = {h5py.h5d.CHUNKED, h5py.h5d.CONTIGUOUS}
        for path in self.files():
            found = self.layouts(path)
            self.assertEqual(set(found) - known, {h5py.h5d.VIRTUAL})
            self.assertEqual([n for n in found[h5py.h5d.VIRTUAL] if "VTKHDF/" not in n], [])
            if shutil.which("h5repack"):
                copy = self.folder / "r.h5"
                subprocess.run(["h5repack", "-l", "CONTI", path, copy], check=True)
                self.assertEqual(set(self.layouts(copy)) - known, set())
        self.succeeds("simulate", HEALTHY, "-o", "summary.h5", "--every", "0", *SHORT)
        self.assertEqual(set(self.layouts(self.folder / "summary.h5")) - known, set())

    def test_h5dump(self):
        if not shutil.which("h5dump"):
            self.skipTest("needs hdf5-tools")
        for path in self.files():
            out = subprocess.run(["h5dump", "-d", "measures/delta_v_ml" if path == self.run_file else
                                  "best_run/measures/delta_v_ml", path], capture_output=True, text=True, check=True).stdout
            with h5py.File(path) as file:
                value = (file if path == self.run_file else file["best_run"])["measures/delta_v_ml"][()]
            self.assertAlmostEqual(float(out.split("(0):")[1].split()[0]), value, delta=1e-3)
            whole = subprocess.run(["h5dump", "-o", "/dev/null", path], capture_output=True, text=True)
            self.assertEqual((whole.returncode, whole.stderr), (0, ""))

    def test_equal_runs_are_equal_bytes(self):
        for command in (("simulate", HEALTHY, *SHORT), ("fit", HEALTHY, "--trace", "../t.csv", *FAST_FIT, "--free", "k_muscle", "--timing", "trace")):
            copies = []
            for name in ("a", "b"):
                (self.folder / name).mkdir(exist_ok=True)
                shutil.copy(self.made / "t.csv", self.folder / "t.csv")
                outcome = Outcome(start(*command, "-o", f"x{name}.h5", "--force", cwd=self.folder / name, epoch=1700000000))
                self.assertIn(outcome.code, (0, 4), str(outcome))
                copies.append((self.folder / name / f"x{name}.h5").read_bytes())
            self.assertEqual(copies[0], copies[1])

    def test_sizes(self):
        self.succeeds("simulate", HEALTHY, "-o", "run.h5")
        self.assertLess((self.folder / "run.h5").stat().st_size, 2.5e6)
        json = self.succeeds("simulate", HEALTHY, "-o", "summary.h5", "--every", "0")
        self.assertLess((self.folder / "summary.h5").stat().st_size, 50e3)
        with h5py.File(self.folder / "summary.h5") as file:
            self.assertNotIn("particles", file)
            self.assertEqual(file["measures/delta_v_ml"][()], json["delta_v_ml"])
            self.assertEqual(len(file["curves/time"]), 451)
        self.succeeds("simulate", HEALTHY, "-o", "every.h5", "--every", "50")
        with h5py.File(self.folder / "every.h5") as file:
            np.testing.assert_allclose(np.diff(file["particles/trajectory/position/time"]), 0.05)
        self.refused("simulate", HEALTHY, "-o", "x.h5", "--every", "-1", says="--every")


class NetCDF(Written):
    def groups(self, path):
        with h5py.File(path) as file:
            found = ["/"]
            file.visititems(lambda name, o: found.append(name) if isinstance(o, h5py.Group) else None)
        return found

    @needs("netCDF4", "python3-netcdf4")
    def test_netcdf(self):
        import netCDF4
        for path in self.files():
            with netCDF4.Dataset(path) as file:
                run = file if path == self.run_file else file["best_run"]
                self.assertEqual(run["measures/delta_v_ml"].units, "ml")
                position = run["particles/trajectory/position"]
                self.assertEqual(position["value"].dimensions, ("time", "particle", "xyz"))
                self.assertEqual(position["value"].units, "m")
                np.testing.assert_array_equal(position["value"][:], self.positions[path])
                np.testing.assert_array_equal(run["VTKHDF/Points"][:], self.positions[path].reshape(-1, 3))
                every = []
                def read(group):
                    for name, variable in group.variables.items():
                        variable[...]
                        every.append(name)
                    for child in group.groups.values():
                        read(child)
                read(file)
                self.assertGreater(len(every), 80)
            if path == self.run_file:
                with netCDF4.Dataset(path) as file:
                    self.assertEqual(float(file["measures/delta_v_ml"][()]), self.run_json["delta_v_ml"])

    @needs("xarray", "python3-xarray python3-h5netcdf")
    def test_xarray_by_both_engines(self):
        import xarray
        engines = [e for e, m in (("h5netcdf", "h5netcdf"), ("netcdf4", "netCDF4")) if importlib.util.find_spec(m)]
        self.assertTrue(engines)
        for path in self.files():
            for engine in engines:
                for group in self.groups(path):
                    with self.subTest(engine + group), xarray.open_dataset(path, engine=engine, group=group) as data:
                        data.load()
                        self.assertEqual([d for d in data.dims if d.startswith("phony")], [])
        for engine in engines:
            with xarray.open_dataset(self.run_file, engine=engine, group="curves") as curves:
                self.assertAlmostEqual(float(curves.dV_model.max()), self.run_json["delta_v_ml"], delta=1e-9)
            with xarray.open_dataset(self.fit_file, engine=engine, group="result") as result:
                nrmse = 100 * float((result.residual ** 2).mean() ** 0.5) / self.fit_json["tidal_volume_measured_ml"]
                self.assertAlmostEqual(nrmse, self.fit_json["nrmse_percent"], delta=1e-9)


@needs("MDAnalysis", "python3-mdanalysis")
class Trajectories(Written):
    def test_mdanalysis(self):
        import MDAnalysis
        for path in self.files():
            positions = self.positions[path]
            universe = MDAnalysis.Universe.empty(positions.shape[1], trajectory=True)
            universe.load_new(path, format="H5MD", convert_units=False)
            self.assertEqual(len(universe.trajectory), len(positions))
            for frame in (0, len(positions) // 2, len(positions) - 1):
                step = universe.trajectory[frame]
                np.testing.assert_allclose(step.positions, positions[frame], atol=1e-7)  # single precision
                self.assertTrue(step.has_velocities)
            with h5py.File(path) as file:
                self.assertAlmostEqual(step.time, file["particles/trajectory/position/time"][-1])
                self.assertAlmostEqual(float(step.data["dV"]), file["observables/dV/value"][-1])
            if path == self.run_file:
                read = lambda i: universe.trajectory[i].positions.astype(float).copy()
                self.check_volume(read, self.lung(path), self.peak(path))


class Vtk(Written):
    def export(self, name):
        self.succeeds("export", name, "--vtk", "out", "--force")
        sets = ElementTree.parse(self.folder / "out/trunk.pvd").getroot().findall("Collection/DataSet")
        return [(float(s.get("timestep")), str(self.folder / "out" / s.get("file"))) for s in sets]

    @needs("vtkmodules", "python3-vtk9")
    def test_xml_frames(self):
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

        def read(file):
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(file)
            reader.Update()
            return reader.GetOutput()
        for path in self.files():
            series, positions = self.export(path), self.positions[path]
            self.assertEqual(len(series), len(positions))
            for frame in (0, self.peak(path)):
                time, name = series[frame]
                data = read(name)
                points = vtk_to_numpy(data.GetPoints().GetData())
                np.testing.assert_allclose(points, positions[frame], rtol=0, atol=1e-10)
                self.assertEqual(data.GetFieldData().GetArray("TimeValue").GetValue(0), time)
                self.assertEqual((data.GetNumberOfPolys(), data.GetNumberOfLines()), (len(self.all_triangles(path)), 12))
                moved = vtk_to_numpy(data.GetPointData().GetArray("displacement"))
                np.testing.assert_allclose(moved, positions[frame] - positions[0], rtol=0, atol=1e-10)
                component = vtk_to_numpy(data.GetCellData().GetArray("component"))
                self.assertEqual([int((component == c).sum()) for c in (1, 2)], [len(self.lung(path)), 12])
            if path == self.run_file:
                triangles = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)[component[12:] == 1]
                self.check_volume(lambda i: vtk_to_numpy(read(series[i][1]).GetPoints().GetData()), triangles, self.peak(path))

    @staticmethod
    def all_triangles(path):
        with h5py.File(path) as file:
            return file["connectivity/triangles"][()]

    def test_vtkhdf_by_the_letter(self):
        """As vtkHDFReader of VTK 9.3 goes about it: Debian's own, 9.1, knows neither PolyData nor time."""
        for path in self.files():
            self.export(path)
            with h5py.File(self.folder / "out/view.vtkhdf") as view:
                vtk = view["VTKHDF"]
                self.assertEqual(vtk.attrs["Version"].tolist(), [2, 0])
                kind = h5py.h5a.open(vtk.id, b"Type").get_type()
                self.assertEqual((kind.get_size(), bytes(vtk.attrs["Type"])), (8, b"PolyData"))
                steps = vtk["Steps"]
                count, positions = int(steps.attrs["NSteps"]), self.positions[path]
                self.assertEqual((count, len(steps["Values"])), (len(positions), len(positions)))
                self.assertTrue(vtk["Points"].is_virtual)
                for step in (0, count // 2, count - 1):
                    part, first = steps["PartOffsets"][step], steps["PointOffsets"][step]
                    points = vtk["Points"][first:first + vtk["NumberOfPoints"][part]]
                    np.testing.assert_array_equal(points, positions[step])
                    at = steps["PointDataOffsets/velocity"][step]
                    self.assertEqual(vtk["PointData/velocity"][at:at + len(points)].shape, points.shape)
                    for number, name in enumerate(("Vertices", "Lines", "Polygons", "Strips")):
                        cells = vtk[name]
                        start, ids = steps["CellOffsets"][step, number], steps["ConnectivityIdOffsets"][step, number]
                        offsets = cells["Offsets"][start:start + cells["NumberOfCells"][part] + 1]
                        corners = cells["Connectivity"][ids:ids + cells["NumberOfConnectivityIds"][part]]
                        self.assertEqual((offsets[0], offsets[-1]), (0, len(corners)))
                        if name == "Polygons":
                            np.testing.assert_array_equal(corners.reshape(-1, 3), self.all_triangles(path))
                self.assertEqual(len(vtk["CellData/component"]), 12 + len(self.all_triangles(path)))


if __name__ == "__main__":
    unittest.main()
