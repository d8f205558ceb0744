"""Surfaces that were read wrong, or taken for what they are not: each gives the right value or the words of a refusal."""

import math
import struct
import unittest

from support import SCENARIOS, TrunkTest
from test_register import dome

try:
    import h5py
    import numpy as np
    import surface_files
except ImportError as missing:
    raise unittest.SkipTest(f"{missing}: apt install python3-h5py")

LPS = np.array((-1.0, -1.0, 1.0))
run = b""  # of a registered trunk, once for all


def points_of(obj_text):
    rows = [line.split() for line in obj_text.splitlines()]
    return (np.array([list(map(float, r[1:])) for r in rows if r[0] == "v"]),
            np.array([[int(i) - 1 for i in r[1:]] for r in rows if r[0] == "f"]))


class Surfaces(TrunkTest):
    def setUp(self):
        super().setUp()
        global run
        if not run:
            outcome = self.trunk("simulate", str(SCENARIOS / "craighero.toml"), "-o", "r.h5", "--set", "time.dt_ms=3",
                                 "--set", "time.duration_s=0.3")
            self.assertEqual(outcome.code, 0, str(outcome))
            run = (self.folder / "r.h5").read_bytes()
        self.file("r.h5", run)

    def own(self, component):
        """The trunk's own surface at the start, in mm, LPS."""
        with h5py.File(self.folder / "r.h5") as file:
            points = 1e3 * file["particles/trajectory/position/value"][0]
            triangles = file["connectivity/triangles"][()][file["connectivity/triangle_component"][()] == component]
        used = np.unique(triangles)
        return points[used] * LPS, np.searchsorted(used, triangles)


class Files(Surfaces):
    def test_a_trunks_own_surface_is_no_distance_away_however_slicer_writes_it(self):
        surface = self.own(component=1)
        for name, content in surface_files.layouts(*surface):
            with self.subTest(name):
                result = self.succeeds("compare", "r.h5", "--surface", self.file("own", content), "--region", "lung",
                                       "--at", "start")
                self.assertEqual((result["axes"], result["surface_triangles"]), ("LPS", 100))
                self.assertLess(result["hausdorff_mm"], 0.005)  # 0.00 in all
                self.assertTrue(any("axes LPS, as the file says" in note for note in result["notes"]), result["notes"])

    def test_a_list_of_pieces_is_read_and_leads_nowhere_else(self):
        points, triangles = self.own(component=1)
        self.file("parts_0.vtp", surface_files.vtp(points, triangles[:50], "binary"))
        self.file("parts_1.vtp", surface_files.vtp(points, triangles[50:], "appended"))
        listed = '<VTKFile type="PPolyData"><PPolyData GhostLevel="0">{}</PPolyData></VTKFile>'
        pieces = '<Piece Source="parts_0.vtp"/><Piece Source="parts_1.vtp"/>'
        result = self.succeeds("compare", "r.h5", "--surface", self.file("parts.pvtp", listed.format(pieces)), "--region",
                               "lung", "--at", "start")
        self.assertLess(result["hausdorff_mm"], 0.005)
        self.assertEqual(result["surface_triangles"], 100)
        for source in ("/etc/passwd", "../parts_0.vtp", "a/../../x.vtp"):
            name = self.file("bad.pvtp", listed.format(f'<Piece Source="{source}"/>'))
            self.refused("compare", "r.h5", "--surface", name, says="in the folder of this list or below it")
        name = self.file("loop.pvtp", listed.format('<Piece Source="loop.pvtp"/>'))
        self.refused("compare", "r.h5", "--surface", name, says="a list of pieces in a list")

    def test_unmarked_axes_are_said_first(self):
        points, triangles = self.own(component=1)
        for content in (surface_files.stl(points, triangles, b"exported"), surface_files.vtp(points, triangles, space="")):
            result = self.succeeds("compare", "r.h5", "--surface", self.file("own", content), "--region", "lung")
            self.assertRegex(result["notes"][0], r"axes assumed to be RAS .*neither the file .* --axes LPS")
        unknown = surface_files.vtp(points, triangles, "binary", space="scanner-xyz")
        self.refused("compare", "r.h5", "--surface", self.file("own", unknown), says="axes 'scanner-xyz' found")
        self.succeeds("compare", "r.h5", "--surface", "own", "--axes", "LPS", "--region", "lung")

    def test_other_formats_are_named_with_the_way_out(self):
        tetrahedron = b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n" \
                      b"0 0 0 100 0 0 0 100 0 0 0 100\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"
        nifti = struct.pack("<i", 348) + bytes(340) + b"n+1\0" + bytes(8)
        import gzip
        import io
        import zipfile
        archive = io.BytesIO()
        with zipfile.ZipFile(archive, "w") as file:
            file.writestr("3D/3dmodel.model", "<model/>")
        for content, says in (
                (b"NRRD0005\ntype: uchar\ndimension: 3\nsizes: 2 2 2\n\n" + bytes(8), "label map .NRRD..*3D Slicer"),
                (nifti, "label map .NIfTI..*Segmentations, Export"),
                (gzip.compress(nifti), "label map .NIfTI."),
                (bytes(128) + b"DICM" + bytes(60), "RTSTRUCT.*SlicerRT"),
                (archive.getvalue(), "3MF.*save it as STL"),
                (b"glTF\2\0\0\0" + bytes(60), "GLB.*Blender"),
                (b'{"asset": {"version": "2.0"}}', "glTF"),
                (b"ObjectType = Image\nNDims = 3\n", "MetaImage"),
                (b'<?xml version="1.0"?>\n<COLLADA/>', "COLLADA"),
                (b'<?xml version="1.0"?>\n<GIFTI/>', "GIFTI"),
                (b"#VRML V2.0 utf8\n", "VRML"),
                (b"ISO-10303-21;\n", "STEP"),
                (b"OFF\n3 1 0\n", "OFF.*MeshLab"),
                (b"# vtk DataFile Version 3.0\nx\nASCII\nDATASET STRUCTURED_POINTS\n", "label map found"),
                (b'<VTKFile type="ImageData"/>', "label map found"),
                (tetrahedron, "VTK's type 10.*Extract Surface"),
                (gzip.compress(b"solid x\n" * 100)[:-20], "gzip. are damaged or cut short")):
            with self.subTest(says):
                self.refused("compare", "r.h5", "--surface", self.file("other", content), says=says)

    def test_a_bomb_in_gzip_is_refused(self):
        import gzip
        bomb = gzip.compress(gzip.compress(b" " * 1000) and b" " * 300_000_000, 1)
        self.refused("compare", "r.h5", "--surface", self.file("bomb.gz", bomb), says="holds too much")


class RegisterTest(Surfaces):
    def registered(self, points, triangles, *options, code=0):
        name = self.file("s.stl", surface_files.stl(points, triangles, b""))
        outcome = self.trunk("register", "--surface", name, "-o", "me.pml", "--force", "--json", *options)
        self.assertIn(outcome.code, code if isinstance(code, tuple) else (code,), str(outcome))
        report = outcome.json()
        report["stderr"] = outcome.err
        return report


class Kinds(RegisterTest):
    def test_a_surface_in_inches_is_doubted(self):
        points, triangles = points_of(dome())
        report = self.registered(points / 25.4, triangles, "--axes", "RAS", code=3)
        self.assertEqual(report["status"], "implausible")
        self.assertIn("(registration in doubt: implausible)", (self.folder / "me.toml").read_text())
        self.assertRegex(report["message"], r"the trunk became 0\.\d+ times as large; expected 0\.6 to 1\.5 .*check the unit")

    def test_align_has_a_limit(self):
        points, triangles = self.own(component=1)
        angle = math.radians(40)
        turned = points @ np.array([(math.cos(angle), math.sin(angle), 0), (-math.sin(angle), math.cos(angle), 0), (0, 0, 1)])
        name = self.file("turned.stl", surface_files.stl(turned, triangles))
        outcome = self.trunk("compare", "r.h5", "--surface", name, "--region", "lung", "--align")
        self.assertEqual(outcome.code, 3, str(outcome))
        self.assertRegex(outcome.err, r"--align turned the surface by \d+ degrees; expected at most 30; check its axes")
        self.succeeds("compare", "r.h5", "--surface", self.file("straight.stl", surface_files.stl(points, triangles)),
                      "--region", "lung", "--align")


if __name__ == "__main__":
    unittest.main()
