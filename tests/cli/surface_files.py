"""One surface as many programs write it: bytes by the name of the layout. Points in mm, [n, 3]; triangles [m, 3]."""

import base64
import gzip
import lzma
import struct
import zlib

import numpy as np

SLICER = b"3D Slicer output. SPACE=LPS"


def stl(points, triangles, header=SLICER):
    facets = np.zeros(len(triangles), dtype=[("normal", "<3f4"), ("corners", "<9f4"), ("bytes", "<u2")])
    facets["corners"] = points[triangles].reshape(-1, 9)
    return header.ljust(80)[:80] + struct.pack("<I", len(triangles)) + facets.tobytes()


def text_stl(points, triangles, header=SLICER, more=""):
    return b"solid " + header + b"\n" + "".join(
        "facet normal 0 0 0\n" + more + "outer loop\n" + "".join("vertex {:.7f} {:.7f} {:.7f}\n".format(*points[i]) for i in t) +
        "endloop\nendfacet\n" for t in triangles).encode() + b"endsolid\n"


def obj(points, triangles, comments=SLICER, faces_first=False):
    vertices = "".join("v {:.7f} {:.7f} {:.7f}\n".format(*p) for p in points)
    faces = "".join("f {} {} {}\n".format(*(t + 1)) for t in triangles)
    return b"# " + comments + b"\n" + (faces + vertices if faces_first else vertices + faces).encode()


def ply(points, triangles, comment=SLICER):
    return (b"ply\nformat binary_little_endian 1.0\ncomment " + comment + f"\nelement vertex {len(points)}\nproperty float x\n"
            f"property float y\nproperty float z\nelement face {len(triangles)}\nproperty list uchar int vertex_indices\n"
            "end_header\n".encode() + np.asarray(points, "<f4").tobytes() +
            b"".join(struct.pack("<B3i", 3, *t) for t in triangles))


def ply_strips(points, triangles):
    """Every triangle a strip, in one list with -1 between them."""
    strips = [i for t in triangles for i in (*t, -1)]
    return (f"ply\nformat ascii 1.0\ncomment SPACE=LPS\nelement vertex {len(points)}\nproperty float x\nproperty float y\n"
            "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n" +
            "".join("{:.7f} {:.7f} {:.7f}\n".format(*p) for p in points) +
            f"{len(strips)} " + " ".join(map(str, strips)) + "\n").encode()


def vtk(points, triangles, title=SLICER, field=False, grid=False, binary=False):
    """VTK's legacy format: axes in the title, or in a field."""
    number = lambda a, kind: np.asarray(a, ">" + kind).tobytes() if binary else (" ".join(map(str, np.ravel(a).tolist()))).encode()
    cells = np.column_stack((np.full(len(triangles), 3), triangles))
    text = b"# vtk DataFile Version 3.0\n" + title + (b"\nBINARY" if binary else b"\nASCII") + b"\nDATASET "
    text += b"UNSTRUCTURED_GRID\n" if grid else b"POLYDATA\n"
    if field:
        text += b"FIELD FieldData 1\nSPACE 1 1 string\n" + (b"\xc3LPS\n" if binary else b"LPS\n")
    text += f"POINTS {len(points)} float\n".encode() + number(points, "f4") + b"\n"
    text += f"{'CELLS' if grid else 'POLYGONS'} {len(cells)} {cells.size}\n".encode() + number(cells, "i4") + b"\n"
    if grid:
        text += f"CELL_TYPES {len(cells)}\n".encode() + number(np.full(len(cells), 5), "i4") + b"\n"
    return text


def lz4_block(data):
    """LZ4 of literals only."""
    if len(data) < 15:
        return bytes([len(data) << 4]) + data
    more, rest = b"", len(data) - 15
    while rest >= 255:
        more, rest = more + b"\xff", rest - 255
    return b"\xf0" + more + bytes([rest]) + data


PACKERS = {"vtkZLibDataCompressor": zlib.compress, "vtkLZ4DataCompressor": lz4_block,
           "vtkLZMADataCompressor": lambda data: lzma.compress(data, lzma.FORMAT_XZ)}


def vtp(points, triangles, coding="ascii", compressor="", space="LPS", grid=False, comment=""):
    """VTK's XML: `coding` is ascii, binary, appended or raw; SPACE is a string in FieldData, as 3D Slicer writes it."""
    appended = b""

    def packed(data):
        if not compressor:
            return struct.pack("<I", len(data)) + data, b""
        block = PACKERS[compressor](data)
        return struct.pack("<4I", 1, len(data), 0, len(block)), block

    def array(kind, name, values, more="", element="DataArray"):
        nonlocal appended
        values = np.asarray(values)
        head = f'<{element} type="{kind}" Name="{name}" {more} '
        if coding == "ascii":
            return head + 'format="ascii">' + " ".join(map(str, values.ravel().tolist())) + f"</{element}>\n"
        first, second = packed(values.tobytes())
        code = lambda data: base64.b64encode(data) if coding != "raw" else data
        data = code(first) + code(second) if compressor else code(first)
        if coding == "binary":
            return head + 'format="binary">\n' + data.decode() + f"\n</{element}>\n"
        offset, appended = len(appended), appended + data
        return head + f'format="appended" offset="{offset}"/>\n'

    kind = "UnstructuredGrid" if grid else "PolyData"
    body = ""
    if space:
        codes = np.frombuffer(space.encode() + b"\0", np.uint8)
        body += "<FieldData>\n" + array("String", "SPACE", codes, 'NumberOfTuples="1"', "Array") + "</FieldData>\n"
    body += f'<Piece NumberOfPoints="{len(points)}" NumberOfPolys="{len(triangles)}">\n<Points>\n'
    body += array("Float32", "Points", np.asarray(points, "<f4"), 'NumberOfComponents="3"') + "</Points>\n"
    body += "<Cells>\n" if grid else "<Polys>\n"
    body += array("Int64", "connectivity", np.asarray(triangles, "<i8"))
    body += array("Int64", "offsets", 3 * np.arange(1, len(triangles) + 1, dtype="<i8"))
    body += array("UInt8", "types", np.full(len(triangles), 5, np.uint8)) + "</Cells>\n" if grid else "</Polys>\n"
    text = f'<?xml version="1.0"?>\n{comment}<VTKFile type="{kind}" version="0.1" byte_order="LittleEndian" header_type="UInt32"'
    text += f' compressor="{compressor}">\n' if compressor else ">\n"
    text = (text + f"<{kind}>\n{body}</Piece>\n</{kind}>\n").encode()
    if appended:
        text += f'<AppendedData encoding="{"raw" if coding == "raw" else "base64"}">\n_'.encode() + appended + b"\n</AppendedData>\n"
    return text + b"</VTKFile>\n"


def layouts(points, triangles):
    """The surface in LPS in every layout that says so."""
    yield "STL", stl(points, triangles)
    yield "STL, text", text_stl(points, triangles)
    yield "STL, text with colours", text_stl(points, triangles, more="color 0.5 0.5 0.5\n")
    yield "OBJ", obj(points, triangles)
    yield "OBJ, faces first", obj(points, triangles, faces_first=True)
    yield "OBJ, long header", obj(points, triangles, SLICER + b"\n# and more" * 500)
    yield "PLY", ply(points, triangles)
    yield "PLY, strips", ply_strips(points, triangles)
    for binary in (False, True):
        yield f"VTK {binary}", vtk(points, triangles, binary=binary)
        yield f"VTK, field {binary}", vtk(points, triangles, b"vtk output", field=True, binary=binary)
        yield f"VTK, grid {binary}", vtk(points, triangles, grid=True, binary=binary)
    for coding in ("ascii", "binary", "appended", "raw"):
        for compressor in ("", *PACKERS) if coding != "ascii" else ("",):
            yield f"VTP, {coding} {compressor}", vtp(points, triangles, coding, compressor)
        yield f"VTU, {coding}", vtp(points, triangles, coding, grid=True)
    yield "VTP, comment", vtp(points, triangles, space="", comment="<!-- " + SLICER.decode() + " -->\n")
    yield "STL, packed", gzip.compress(stl(points, triangles))
    yield "VTP, packed", gzip.compress(vtp(points, triangles, "binary"))
