"""Results files made to harm: they claim to be ours and are not. One line, exit 2, no hang, no crash."""

import os
import unittest
from pathlib import Path

from support import FAST_FIT, HEALTHY, TrunkTest, coarse_run, trace

try:
    import h5py
    import numpy as np
except ImportError as missing:
    raise unittest.SkipTest(f"{missing}: apt install python3-h5py")

POSITION = "particles/trajectory/position/value"


written = b""  # a run, once for all


def setUpModule():
    global written
    written = coarse_run()


class Hostile(TrunkTest):
    def setUp(self):
        super().setUp()
        self.file("r.h5", written)

    def changed(self, change):
        """What `change` does to a file of ours; another program drops the seal."""
        self.file("x.h5", written)
        with h5py.File(self.folder / "x.h5", "r+") as file:
            change(file)

    def refused_by_all(self, says):
        for command in (("inspect", "x.h5"), ("replay", "x.h5"), ("diff", "x.h5", "r.h5"), ("export", "x.h5", "--csv", "out"),
                        ("report", "x.h5", "-o", "x.html")):
            with self.subTest(command[0]):
                self.refused(*command, says="x.h5: .*" + says)

    def refused_by_readers(self, says):
        for command in (("replay", "x.h5"), ("diff", "r.h5", "x.h5"), ("export", "x.h5", "--vtk", "out"),
                        ("report", "r.h5", "x.h5", "-o", "x.html")):
            with self.subTest(command[0]):
                self.refused(*command, says="x.h5: .*" + says)

    @staticmethod
    def replaced(name, make):
        def change(file):
            units = file[name].attrs.get("units")
            del file[name]
            make(file, name)
            if units is not None and name in file:
                file[name].attrs["units"] = units
        return change

    def test_changed_by_another_program_is_still_read(self):
        def note(file):
            file.attrs["remark"] = np.bytes_("mine")
        self.changed(note)
        self.assertEqual((self.folder / "x.h5").read_bytes().count(b"sha256 "), 0)
        self.assertEqual(self.succeeds("inspect", "x.h5")["kind"], "run")
        self.assertTrue(self.succeeds("diff", "r.h5", "x.h5")["same"])

    def test_values_in_other_files(self):
        self.file("other.bin", bytes(80000))
        def virtual(file, name):
            layout = h5py.VirtualLayout((102,), "f8")
            layout[:] = h5py.VirtualSource("other.h5", "x", (102,))
            file.create_virtual_dataset(name, layout)
        self.changed(self.replaced("curves/dV_model", virtual))
        self.refused_by_readers("its values are elsewhere")
        def raw(file, name):
            file.create_dataset(name, (102,), "f8", external=[("/dev/zero", 0, 816)])
        self.changed(self.replaced("curves/dV_model", raw))
        self.refused_by_all("its values are elsewhere")
        os.mkfifo(self.folder / "pipe")  # opening it would never return
        def linked(file, name):
            file[name] = h5py.ExternalLink("pipe", "/x")
        self.changed(self.replaced("curves", linked))
        self.refused_by_readers("it is a link to somewhere else")

    def test_links_in_circles(self):
        def circle(file):
            file["curves/again"] = file["/"]
            file["particles/trajectory/box/up"] = file["particles"]
        self.changed(circle)
        self.assertEqual(self.succeeds("inspect", "x.h5")["kind"], "run")
        self.refused_by_readers("curves|again")

    def test_petabytes(self):
        def huge(file, name):
            file.create_dataset(name, (1 << 40,), "f8", chunks=(1 << 16,), compression="gzip")
        self.changed(self.replaced("curves/dV_model", huge))
        self.refused_by_all("more values than the file can hold")

    def test_shapes_that_disagree(self):
        for name, shape in ((POSITION, (3, 3, 3)), ("curves/dV_model", (7,)), ("particles/trajectory/position/step", (1,)),
                            ("connectivity/triangles", (7,)), ("observables/dL/value", (2,)),
                            ("particles/trajectory/species", (2,))):
            with self.subTest(name):
                self.changed(self.replaced(name, lambda file, n: file.create_dataset(n, shape, "f8" if "value" in n else "i4")))
                self.refused_by_readers("wrong|particle")

    def test_particles_that_do_not_exist(self):
        for name in ("connectivity/triangles", "connectivity/fibres", "connectivity/muscle_lines"):
            for number in (-1, 113, 2**31 - 1):
                with self.subTest(name, number=number):
                    def change(file):
                        file[name][0, 0] = number
                    self.changed(change)
                    self.refused_by_readers("names a particle that does not exist")

    def test_types_that_disagree(self):
        for name in (POSITION, "curves/time"):
            with self.subTest(name):
                self.changed(self.replaced(name, lambda file, n: file.create_dataset(n, data=np.array([b"text"] * 3))))
                self.refused_by_readers("cannot read|wrong")
        def pointers(file, name):
            file.create_dataset(name, (102,), h5py.vlen_dtype("f8"))
        self.changed(self.replaced("curves/dV_model", pointers))
        self.refused_by_readers("cannot read")

    def test_what_is_missing(self):
        for name in ("curves", "curves/time", "parameters", "parameters/scenario_toml", "measures", "provenance", POSITION,
                     "connectivity/triangles", "particles/trajectory/particle"):
            with self.subTest(name):
                def change(file):
                    del file[name]
                self.changed(change)
                self.refused_by_readers("cannot (open|find|read)")

    def test_a_stored_scenario_is_input_too(self):
        def change(file, name):
            file[name] = np.bytes_("title = 3\n")
        self.changed(self.replaced("parameters/scenario_toml", change))
        self.refused("replay", "x.h5", says="x.h5:1: ")

    def test_unfinished_newer_and_foreign(self):
        for key, value, says in (("complete", 0, "is unfinished"), ("schema_version", 2, "has version 2 of schema trunk.run"),
                                 ("schema", np.bytes_("trunk.walk"), "has schema 'trunk.walk'"),
                                 ("schema", np.bytes_("other"), r"is an HDF5 file of another program \(it holds ")):
            with self.subTest(key):
                def change(file):
                    del file.attrs[key]
                    file.attrs[key] = value
                self.changed(change)
                self.refused_by_all(says)
        with h5py.File(self.folder / "x.h5", "w", libver=("v110", "v110")) as file:
            file["\x1b[31mred"] = 1
            file["b"] = 2
        self.refused_by_all(r"of another program \(it holds \?\[31mred, b\)")
        with h5py.File(self.folder / "x.h5", "w", libver="earliest") as file:
            file["b"] = 2
        self.refused_by_all("of another program; expected")
        with h5py.File(self.folder / "r.h5") as ours, h5py.File(self.folder / "x.h5", "w", libver="earliest") as file:
            file.attrs["schema"] = ours.attrs["schema"]
        self.refused_by_all("holds results of trunk, but another program such as h5repack")


class FitFiles(TrunkTest):
    """Fits that an earlier program wrote are read; a fit of this one without its results is not."""

    fit = b""

    def setUp(self):
        super().setUp()
        if not FitFiles.fit:
            self.file("t.csv", trace())
            self.succeeds("fit", HEALTHY, "--trace", "t.csv", "-o", "f.h5", *FAST_FIT, codes=(0, 4))
            FitFiles.fit = (self.folder / "f.h5").read_bytes()
        self.file("f.h5", FitFiles.fit)

    def change(self, change):
        self.file("x.h5", FitFiles.fit)
        with h5py.File(self.folder / "x.h5", "r+") as file:
            change(file)

    def test_version_1_is_read_by_all(self):
        def earlier(file):
            file.attrs.modify("schema_version", np.int32(1))
            del file["results"], file["problem"].attrs["input"]
            del file["draws"]
            for profile in file["profiles"].values():
                del profile["threshold95"]
        self.change(earlier)
        kept = self.succeeds("inspect", "x.h5")
        self.assertEqual((kept["kind"], kept["results"], kept["gates"]), ("fit", {}, []))
        self.assertNotIn("grade", kept)
        now = self.succeeds("inspect", "f.h5")
        self.assertEqual((kept["parameters"], kept["verdict"]), (now["parameters"], now["verdict"]))
        self.assertTrue(self.succeeds("replay", "x.h5", "--tolerance", "0")["same"])
        files = [Path(f).name for f in self.succeeds("export", "x.h5", "--csv", "out")["files"]]
        self.assertIn("parameters.csv", files)
        self.assertNotIn("results.csv", files)
        self.succeeds("report", "x.h5", "-o", "x.html")
        self.succeeds("report", "x.h5", "f.h5", "-o", "both.html")
        self.assertTrue(self.succeeds("diff", "x.h5", "f.h5")["same"])
        again = self.succeeds("fit", HEALTHY, "--tidal-volume-ml", "300", "-o", "g.h5", "--fix", "k_elasticity=@x.h5", *FAST_FIT,
                              codes=(0, 4))
        self.assertEqual(set(again["parameters"]), {"k_muscle"})
        self.assertEqual(self.succeeds("inspect", "g.h5")["parameters"]["k_elasticity"]["value"],
                         kept["parameters"]["k_elasticity"]["value"])
        outcome = self.trunk("simulate", HEALTHY, "--from", "x.h5", "-o", "r.h5", *FAST_FIT)
        self.assertRegex(outcome.err, "note: x.h5 keeps no draws of its parameters, so no number here has an interval of the fit;")
        self.assertNotIn("delta_v_ml_lower95", self.succeeds("simulate", HEALTHY, "--from", "x.h5", "-o", "r.h5", "--force", *FAST_FIT))

    def refused_by_readers(self, says):
        for command in (("inspect", "x.h5"), ("export", "x.h5", "--csv", "out"), ("report", "x.h5", "-o", "x.html")):
            with self.subTest(command[0]):
                self.refused(*command, says="x.h5: is truncated or damaged: .*" + says)

    def test_damaged_results_are_refused(self):
        for path in ("results", "results/value", "results/grade", "results/headline", "results/straight_activation/lower95"):
            with self.subTest(path):
                def without(file):
                    del file[path]
                self.change(without)
                self.refused_by_readers(path.split("/")[-1])
        def short(file):
            del file["results/upper95"]
            file["results/upper95"] = np.zeros(3)
        self.change(short)
        self.refused_by_readers("results/upper95 has the wrong length")
        def ungraded(file):
            del file["results"].attrs["grade"]
        self.change(ungraded)
        self.refused_by_readers("grade")

    def test_a_later_version_is_refused(self):
        def later(file):
            file.attrs.modify("schema_version", np.int32(3))
        self.change(later)
        self.refused("inspect", "x.h5", says="x.h5: has version 3 of schema trunk.fit; expected version 1 or 2; use the version")


if __name__ == "__main__":
    unittest.main()
