"""Surfaces made to harm, and surfaces as other programs write them. One line, exit 2, no hang, no crash."""

import random
import struct
import unittest

from support import TrunkTest, coarse_run

written = b""  # a run, once for all


def setUpModule():
    global written
    written = coarse_run()


def ball(rings=6, around=8, radius=100.0):
    import math
    points = [(0.0, 0.0, radius), (0.0, 0.0, -radius)]
    for i in range(1, rings):
        for k in range(around):
            a, b = math.pi * i / rings, 2 * math.pi * k / around
            points.append((radius * math.sin(a) * math.cos(b), radius * math.sin(a) * math.sin(b), radius * math.cos(a)))
    at = lambda i, k: 2 + (i - 1) * around + k % around
    triangles = []
    for k in range(around):
        triangles += [(0, at(1, k), at(1, k + 1)), (1, at(rings - 1, k + 1), at(rings - 1, k))]
        for i in range(1, rings - 1):
            triangles += [(at(i, k), at(i + 1, k), at(i + 1, k + 1)), (at(i, k), at(i + 1, k + 1), at(i, k + 1))]
    return points, triangles


POINTS, TRIANGLES = ball()


def binary_stl():
    return b" " * 80 + struct.pack("<I", len(TRIANGLES)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *(x for i in t for x in POINTS[i]), 0) for t in TRIANGLES)


def text_stl():
    return "solid x\n" + "".join("facet normal 0 0 0\nouter loop\n" + "".join(
        "vertex {} {} {}\n".format(*POINTS[i]) for i in t) + "endloop\nendfacet\n" for t in TRIANGLES) + "endsolid x\n"


def obj():
    return "".join("v {} {} {}\n".format(*p) for p in POINTS) + "".join("f {} {} {}\n".format(*(i + 1 for i in t)) for t in TRIANGLES)


def ply():
    return (f"ply\nformat binary_big_endian 1.0\nelement vertex {len(POINTS)}\nproperty float x\nproperty float y\n"
            f"property float z\nelement face {len(TRIANGLES)}\nproperty list uchar int vertex_indices\nend_header\n").encode() + \
        b"".join(struct.pack(">3f", *p) for p in POINTS) + b"".join(struct.pack(">B3i", 3, *t) for t in TRIANGLES)


def vtk():
    return (f"# vtk DataFile Version 3.0\nx\nBINARY\nDATASET POLYDATA\nPOINTS {len(POINTS)} float\n").encode() + \
        b"".join(struct.pack(">3f", *p) for p in POINTS) + f"\nPOLYGONS {len(TRIANGLES)} {4 * len(TRIANGLES)}\n".encode() + \
        b"".join(struct.pack(">4i", 3, *t) for t in TRIANGLES)


def vtp():
    numbers = lambda rows: " ".join(str(x) for row in rows for x in row)
    return ('<VTKFile type="PolyData"><PolyData><Piece><Points><DataArray type="Float32" NumberOfComponents="3">'
            f'{numbers(POINTS)}</DataArray></Points><Polys><DataArray type="Int32" Name="connectivity">{numbers(TRIANGLES)}'
            f'</DataArray><DataArray type="Int32" Name="offsets">{numbers([[3 * i + 3] for i in range(len(TRIANGLES))])}'
            '</DataArray></Polys></Piece></PolyData></VTKFile>')


class Surfaces(TrunkTest):
    def setUp(self):
        super().setUp()
        self.file("r.h5", written)

    def compare(self, surface, *options):
        return self.succeeds("compare", "r.h5", "--surface", surface, *options)

    def test_the_same_surface_from_every_format(self):
        results = []
        for make in (binary_stl, text_stl, obj, ply, vtk, vtp):
            with self.subTest(make.__name__):
                result = self.compare(self.file("surface", make()), "--at", "start")
                results.append(result)
                self.assertEqual(result["unit"], "mm")
                self.assertEqual(result["surface_triangles"], len(TRIANGLES))
                self.assertIn("closed, 1 piece", result["notes"][-1])
                self.assertEqual((result["repairs"]["closed"], result["repairs"]["pieces"]), (True, 1))
                self.assertAlmostEqual(result["surface_to_model"]["rms_mm"], results[0]["surface_to_model"]["rms_mm"], 4)

    def test_damaged_files_are_refused_or_read_and_never_crash(self):
        chance = random.Random(7)
        inserts = (b"99999999999", b"-1 ", b" nan ", b"\xff\xff\xff\xff", b"\0\0\0\x80", b"1e999", b"<", b'"', b"\n")
        refused = 0
        for make in (binary_stl, text_stl, obj, ply, vtk, vtp):
            good = make() if isinstance(make(), bytes) else make().encode()
            for trial in range(6):
                bad = bytearray(good)
                for _ in range(chance.choice((1, 3))):
                    at = chance.randrange(chance.choice((300, len(bad))))
                    kind = chance.randrange(3)
                    if kind == 0:
                        bad[at] = chance.randrange(256)
                    elif kind == 1:
                        bad[at:at] = chance.choice(inserts)
                    else:
                        del bad[at:at + chance.choice((1, 4, 2000))]
                with self.subTest(make.__name__, trial=trial):
                    self.file("bad", bytes(bad))
                    outcome = self.trunk("compare", "r.h5", "--surface", "bad", "--json")
                    self.assertIn(outcome.code, (0, 2), str(outcome))
                    if outcome.code == 2:
                        refused += 1
                        self.assert_one_line(outcome)
                        self.assertIn("bad", outcome.err)
                    else:
                        outcome.json()
        self.assertGreater(refused, 10)

    def test_damaged_files_of_more_layouts(self):
        try:
            import gzip
            import numpy as np
            import surface_files as files
        except ImportError as missing:
            self.skipTest(f"{missing}: apt install python3-numpy")
        surface = np.array(POINTS), np.array(TRIANGLES)
        chance = random.Random(11)
        for good in (files.vtp(*surface, "binary", "vtkLZ4DataCompressor"), files.vtp(*surface, "raw", "vtkLZMADataCompressor"),
                     files.vtp(*surface, "appended", grid=True), files.vtk(*surface, b"t", field=True, grid=True, binary=True),
                     files.ply_strips(*surface), gzip.compress(files.stl(*surface))):
            for _ in range(4):
                bad = bytearray(good)
                at = chance.randrange(chance.choice((400, len(bad))))
                if chance.random() < 0.5:
                    bad[at] = chance.randrange(256)
                else:
                    del bad[at:at + chance.choice((1, 4, 2000))]
                self.file("bad", bytes(bad))
                outcome = self.trunk("compare", "r.h5", "--surface", "bad", "--json")
                self.assertIn(outcome.code, (0, 2), str(outcome))
                if outcome.code == 2:
                    self.assert_one_line(outcome)

    def test_bombs(self):
        vertices = "ply\nformat binary_little_endian 1.0\nelement vertex 3000000000\nproperty float x\nend_header\n"
        self.refused("compare", "r.h5", "--surface", self.file("bomb.ply", vertices), says="bomb.ply:3: '3000000000'")
        nothing = "ply\nformat ascii 1.0\nelement vertex 90000000\nelement face 0\nend_header\n"
        self.refused("compare", "r.h5", "--surface", self.file("nothing.ply", nothing), says="x, y and z")
        self.refused("compare", "r.h5", "--surface", self.file("lots.stl", b"\0" * 80 + b"\xff\xff\xff\xff" + b"\0" * 500),
                     says="lots.stl: ")
        deep = "<physicalModel>" + "<multiComponent>" * 100000
        self.refused("compare", "r.h5", "--surface", self.file("deep.pml", deep), says="deep.pml:1: malformed XML")
        self.refused("compare", "r.h5", "--surface", self.file("line.obj", "v " + "1" * 1_000_000), says="line.obj:1: ")
        self.refused("compare", "r.h5", "--surface", "/dev/null", says="empty")
        self.refused("compare", "r.h5", "--surface", ".", says="directory")

    def test_files_that_vtk_writes(self):
        try:
            import vtk as vtk9
        except ImportError as missing:
            self.skipTest(f"{missing}: apt install python3-vtk9")
        points, cells = vtk9.vtkPoints(), vtk9.vtkCellArray()
        for p in POINTS:
            points.InsertNextPoint(*p)
        for t in TRIANGLES:
            cells.InsertNextCell(3, t)
        surface = vtk9.vtkPolyData()
        surface.SetPoints(points)
        surface.SetPolys(cells)
        writers = [(vtk9.vtkSTLWriter, ("SetFileTypeToASCII",)), (vtk9.vtkSTLWriter, ("SetFileTypeToBinary",)),
                   (vtk9.vtkPLYWriter, ("SetFileTypeToASCII",)), (vtk9.vtkPLYWriter, ("SetDataByteOrderToBigEndian",)),
                   (vtk9.vtkOBJWriter, ()), (vtk9.vtkPolyDataWriter, ("SetFileTypeToASCII",)),
                   (vtk9.vtkPolyDataWriter, ("SetFileTypeToBinary",))]
        for mode in ("SetDataModeToAscii", "SetDataModeToBinary", "SetDataModeToAppended"):
            for packing in (("SetCompressorTypeToNone", "SetHeaderTypeToUInt32"),
                            ("SetCompressorTypeToZLib", "SetHeaderTypeToUInt64")):
                for encode in ("EncodeAppendedDataOn", "EncodeAppendedDataOff"):
                    if mode == "SetDataModeToAppended" or encode == "EncodeAppendedDataOn":
                        writers.append((vtk9.vtkXMLPolyDataWriter, (mode, *packing, encode)))
        for kind, settings in writers:
            with self.subTest(kind.__name__, settings=settings):
                writer = kind()
                for setting in settings:
                    getattr(writer, setting)()
                writer.SetFileName(str(self.folder / "by_vtk"))
                writer.SetInputData(surface)
                self.assertEqual(writer.Write(), 1)
                result = self.compare("by_vtk", "--axes", "LPS")
                self.assertEqual(result["surface_triangles"], len(TRIANGLES))
                self.assertIn("closed, 1 piece", result["notes"][-1])


if __name__ == "__main__":
    unittest.main()
