#include <zlib.h>

#include <cstring>

#include "support/catch.hpp"
#include "support/shared_data.hpp"
#include "surfaces/formats/raw_surface.hpp"

using namespace trunk;

namespace {

// A pyramid without floor, 200 high over a square: four triangles.
const double pyramid_corners[5][3] = {{0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0, 100, 0}, {50, 50, 200}};
const int pyramid_faces[4][3] = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};

template <class Number>
std::string raw(Number value, bool big_endian = false) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return big_endian ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
}

template <class Number>
std::string raw_points(bool big_endian) {
  std::string bytes;
  for (const auto& p : pyramid_corners)
    for (const double x : p) bytes += raw(static_cast<Number>(x), big_endian);
  return bytes;
}

std::string text_points(const std::string& before = "", const std::string& end = "\n") {
  std::string text;
  for (const auto& p : pyramid_corners) {
    text += before;
    for (const double x : p) text += std::to_string(x) + " ";
    text += end;
  }
  return text;
}

std::string base64(const std::string& bytes) {
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63];
  }
  return text;
}

/// The same surface in every format; points in the same order except in STL, where each facet has its own.
void check_pyramid(const RawSurface& s, std::size_t points = 5) {
  REQUIRE(s.points.size() == points);
  REQUIRE(s.triangles.size() == 4);
  REQUIRE(s.part.size() == 4);
  for (std::size_t t = 0; t < 4; ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d& p = s.points.at(static_cast<std::size_t>(s.triangles[t][k]));
      const auto& q = pyramid_corners[pyramid_faces[t][k]];
      CHECK((p.x() == q[0] && p.y() == q[1] && p.z() == q[2]));
    }
}

std::string text_stl(const char* line_end = "\n", const char* name = "lungs") {
  std::string text = std::string("solid ") + name + line_end;
  for (const auto& face : pyramid_faces) {
    text += std::string("facet normal nan 0 0") + line_end + "outer loop" + line_end;
    for (const int i : face) {
      text += "  VERTEX";
      for (const double x : pyramid_corners[i]) text += " " + std::to_string(x);
      text += line_end;
    }
    text += std::string("endloop") + line_end + "endfacet" + line_end;
  }
  return text + "endsolid " + name + line_end;
}

std::string binary_stl(std::string header = "solid, or so it says: SPACE=LPS", std::uint32_t count = 4) {
  header.resize(80, ' ');
  std::string bytes = header + raw(count);
  for (const auto& face : pyramid_faces) {
    bytes += std::string(12, '\0');
    for (const int i : face)
      for (const double x : pyramid_corners[i]) bytes += raw(static_cast<float>(x));
    bytes += std::string(2, '\0');
  }
  return bytes;
}

std::string ply_text(const std::string& format, const std::string& body) {
  return "ply\nformat " + format +
         " 1.0\ncomment SPACE=RAS\nelement vertex 5\nproperty double x\nproperty double y\nproperty double "
         "z\n"
         "property uchar red\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n" +
         body;
}

std::string ply_body(bool big_endian) {
  std::string bytes;
  for (const auto& p : pyramid_corners) {
    for (const double x : p) bytes += raw(x, big_endian);
    bytes += '\x7';
  }
  for (const auto& face : pyramid_faces) {
    bytes += '\x3';
    for (const int i : face) bytes += raw(i, big_endian);
  }
  return bytes;
}

std::string vtk_text(const std::string& coding, const std::string& body) {
  return "# vtk DataFile Version 3.0\ntitle\n" + coding + "\nDATASET POLYDATA\n" + body;
}

struct Coded {
  std::string points, list, ends;  // attributes and content of the three arrays
  std::string file_attributes, appended;
};

std::string vtp_file(const Coded& c) {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" " + c.file_attributes +
         ">\n<PolyData>\n<Piece NumberOfPoints=\"5\" NumberOfPolys=\"4\">\n<Points>\n"
         "<DataArray type=\"Float32\" NumberOfComponents=\"3\" " +
         c.points + "</DataArray>\n</Points>\n<Polys>\n<DataArray type=\"Int64\" Name=\"connectivity\" " +
         c.list + "</DataArray>\n<DataArray type=\"Int64\" Name=\"offsets\" " + c.ends +
         "</DataArray>\n</Polys>\n</Piece>\n</PolyData>\n" + c.appended + "</VTKFile>\n";
}

std::string whole_numbers(bool big_endian, bool ends) {
  std::string bytes;
  for (int t = 0; t < 4; ++t)
    for (int k = 0; k < (ends ? 1 : 3); ++k)
      bytes += raw<std::int64_t>(ends ? 3 * t + 3 : pyramid_faces[t][k], big_endian);
  return bytes;
}

template <class Size>
std::string sized(const std::string& data, bool big_endian) {
  return raw(static_cast<Size>(data.size()), big_endian) + data;
}

/// In blocks of 32 bytes, the last one shorter.
std::string deflated(const std::string& data) {
  const std::uint32_t block = 32, blocks = static_cast<std::uint32_t>((data.size() + block - 1) / block);
  std::string head = raw(blocks) + raw(block) + raw(static_cast<std::uint32_t>(data.size() % block)), all;
  for (std::uint32_t i = 0; i < blocks; ++i) {
    const std::string part = data.substr(i * block, block);
    std::string packed(100, '\0');
    uLongf length = packed.size();
    REQUIRE(compress(reinterpret_cast<Bytef*>(packed.data()), &length,
                     reinterpret_cast<const Bytef*>(part.data()), part.size()) == Z_OK);
    head += raw(static_cast<std::uint32_t>(length));
    all += packed.substr(0, length);
  }
  return base64(head) + base64(all);
}

}  // namespace

TEST_CASE("STL as text is read with any line ends and in any case", "[unit][surfaces]") {
  for (const char* line_end : {"\n", "\r\n", "\r"}) {
    const RawSurface s = read_raw_surface("\xEF\xBB\xBF" + text_stl(line_end), "a.stl");
    check_pyramid(s, 12);
    CHECK(s.parts == std::vector<std::string>{"lungs"});
    CHECK(s.axes.empty());
  }
}

TEST_CASE("Binary STL is recognised by its length, even if it begins with solid", "[unit][surfaces]") {
  const RawSurface s = read_raw_surface(binary_stl(), "b.stl");
  check_pyramid(s, 12);
  CHECK(s.format == "STL, binary");
  CHECK(s.axes == "LPS");
  check_pyramid(read_raw_surface(binary_stl("x") + "trailing", "b.stl"), 12);
}

TEST_CASE("OBJ is read with groups, with texture and normal indexes, and with negative indexes",
          "[unit][surfaces]") {
  const std::string points = "# SPACE=LPS\nmtllib x.mtl\n" + text_points("v ") + "vn 0 0 1\nvt 0 0\n";
  const RawSurface s = read_raw_surface(
      points + "g left\nf 1 2/1 5/1/1\nf 2//1 3 5\ng right one\nf 3 4 \\\n 5\r\nf -2 -5 -1 # the last\n",
      "a.obj");
  check_pyramid(s);
  CHECK(s.axes == "LPS");
  CHECK(s.parts == std::vector<std::string>{"left", "right one"});
  CHECK(s.part == std::vector<int>{0, 0, 1, 1});
  const RawSurface quad = read_raw_surface(points + "f 1 2 3 4\n", "a.obj");
  CHECK(quad.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("Numbers are read with decimal commas, signs and exponents of Fortran", "[unit][surfaces]") {
  const RawSurface s = read_raw_surface("v 1.5D+02 +2,25 -.5\nv 1e2 0 1e-400\nv 0 0 0 1\nf 1 2 3\n", "a.obj");
  CHECK((s.points[0].x() == 150.0 && s.points[0].y() == 2.25 && s.points[0].z() == -0.5));
  CHECK((s.points[1].x() == 100.0 && s.points[1].z() == 0.0));
}

TEST_CASE("PLY is read as text and with either byte order", "[unit][surfaces]") {
  const RawSurface s = read_raw_surface(
      ply_text("ascii", text_points("", "7\n") + "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n"), "a.ply");
  check_pyramid(s);
  CHECK(s.axes == "RAS");
  check_pyramid(read_raw_surface(ply_text("binary_little_endian", ply_body(false)), "a.ply"));
  check_pyramid(read_raw_surface(ply_text("binary_big_endian", ply_body(true)), "a.ply"));
}

TEST_CASE("VTK's legacy format is read as text and binary, old and new", "[unit][surfaces]") {
  const std::string old_cells =
      "VERTICES 1 2\n1 0\nPOLYGONS 4 16\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\nPOINT_DATA 5\n?";
  check_pyramid(read_raw_surface(vtk_text("ASCII", "POINTS 5 float\n" + text_points() + old_cells), "a.vtk"));
  check_pyramid(read_raw_surface(
      vtk_text("ASCII",
               "FIELD FieldData 1\nname 1 1 string\nx\nPOINTS 5 float\n" + text_points() +
                   "METADATA\nINFORMATION 0\n\nPOLYGONS 5 12\nOFFSETS vtktypeint64\n0 3 6 9 12\nCONNECTIVITY "
                   "vtktypeint64\n0 1 4 1 2 4 2 3 4 3 0 4\n"),
      "a.vtk"));
  std::string binary = "POINTS 5 double\n" + raw_points<double>(true) + "\nPOLYGONS 4 16\n";
  for (const auto& face : pyramid_faces) {
    binary += raw(3, true);
    for (const int i : face) binary += raw(i, true);
  }
  check_pyramid(read_raw_surface(vtk_text("BINARY", binary + "\n"), "b.vtk"));
  binary = "POINTS 5 float\n" + raw_points<float>(true) + "\nPOLYGONS 5 12\nOFFSETS vtktypeint64\n" +
           raw<std::int64_t>(0, true) + whole_numbers(true, true) + "\nCONNECTIVITY vtktypeint64\n" +
           whole_numbers(true, false) + "\n";
  check_pyramid(read_raw_surface(vtk_text("BINARY", binary), "b.vtk"));
  const RawSurface strip = read_raw_surface(
      vtk_text("ASCII", "POINTS 5 float\n" + text_points() + "TRIANGLE_STRIPS 1 5\n4 0 1 3 2\n"), "a.vtk");
  CHECK(strip.triangles == std::vector<Triangle>{{0, 1, 3}, {3, 1, 2}});
}

TEST_CASE("VTP is read as text", "[unit][surfaces]") {
  check_pyramid(read_raw_surface(
      vtp_file({"format=\"ascii\">" + text_points() + "<InformationKey>7</InformationKey>",
                "format=\"ascii\">0 1 4 1 2 4 2 3 4 3 0 4", "format=\"ascii\">3 6 9 12", "", ""}),
      "a.vtp"));
}

TEST_CASE("VTP is read in base64, plain and compressed", "[unit][surfaces]") {
  const std::string binary = "format=\"binary\">";
  for (const bool big : {false, true}) {
    const std::string order =
        big ? "byte_order=\"BigEndian\" header_type=\"UInt64\"" : "byte_order=\"LittleEndian\"";
    const auto coded = [&](const std::string& data) {
      return binary + "\n  " +
             base64(big ? sized<std::uint64_t>(data, big) : sized<std::uint32_t>(data, big)) + "\n";
    };
    check_pyramid(read_raw_surface(vtp_file({coded(raw_points<float>(big)), coded(whole_numbers(big, false)),
                                             coded(whole_numbers(big, true)), order, ""}),
                                   "a.vtp"));
  }
  check_pyramid(read_raw_surface(
      vtp_file({binary + deflated(raw_points<float>(false)), binary + deflated(whole_numbers(false, false)),
                binary + deflated(whole_numbers(false, true)), "compressor=\"vtkZLibDataCompressor\"", ""}),
      "a.vtp"));
}

TEST_CASE("VTP is read with appended data, raw and in base64", "[unit][surfaces]") {
  const std::string points = sized<std::uint32_t>(raw_points<float>(false), false),
                    list = sized<std::uint32_t>(whole_numbers(false, false), false),
                    ends = sized<std::uint32_t>(whole_numbers(false, true), false);
  for (const bool is_raw : {true, false}) {
    const auto coded = [&](const std::string& data) { return is_raw ? data : base64(data); };
    const auto at = [](std::size_t offset) {
      return "format=\"appended\" offset=\"" + std::to_string(offset) + "\">";
    };
    const std::size_t second = coded(points).size(), third = second + coded(list).size();
    check_pyramid(read_raw_surface(
        vtp_file({at(0), at(second), at(third), "",
                  std::string("<AppendedData encoding=\"") + (is_raw ? "raw" : "base64") + "\">\n  _" +
                      coded(points) + coded(list) + coded(ends) + "\n</AppendedData>\n"}),
        "a.vtp"));
  }
}

TEST_CASE("PML is read with every component of triangles and quadrilaterals, also by reference",
          "[unit][surfaces]") {
  std::string text = "<physicalModel unit='mm'>\n<atoms><structuralComponent>\n";
  for (int i = 0; i < 5; ++i) {
    const auto& p = pyramid_corners[i];
    text += "<atom><atomProperties index='" + std::to_string(10 + i) + "' x='" + std::to_string(p[0]) +
            "' y='" + std::to_string(p[1]) + "' z='" + std::to_string(p[2]) + "'/></atom>\n";
  }
  const auto cell = [](int index, const char* type, std::vector<int> atoms) {
    std::string xml = "<cell><cellProperties index='" + std::to_string(index) + "' type='" + type + "'/>";
    for (const int atom : atoms) xml += "<atomRef index='" + std::to_string(10 + atom) + "'/>";
    return xml + "</cell>\n";
  };
  text +=
      "</structuralComponent></atoms>\n<exclusiveComponents><multiComponent>\n<structuralComponent "
      "name='side'>" +
      cell(0, "TRIANGLE", {0, 1, 4}) + cell(1, "LINE", {0, 1}) + cell(2, "TRIANGLE", {1, 2, 4}) +
      "</structuralComponent><structuralComponent name='floor'><cellRef index='0'/>" +
      cell(3, "QUAD", {0, 1, 2, 3}) +
      "</structuralComponent></multiComponent></exclusiveComponents>\n</physicalModel>\n";
  const RawSurface s = read_raw_surface(text, "a.pml");
  CHECK(s.triangles == std::vector<Triangle>{{0, 1, 4}, {1, 2, 4}, {0, 1, 4}, {0, 1, 2}, {0, 2, 3}});
  CHECK(s.part == std::vector<int>{0, 0, 1, 1, 1});
  CHECK(s.parts == std::vector<std::string>{"side", "floor"});
  CHECK(s.unit == "mm");
}

TEST_CASE("Real surfaces are read completely", "[shared][surfaces]") {
  const RawSurface diaphragm = read_raw_surface(test::shared_surface("diaphragm.pml"), "diaphragm.pml");
  CHECK(diaphragm.points.size() == 283);
  CHECK(diaphragm.triangles.size() == 498);
  const std::string thorax = test::shared_surface("eidors_vh_male_thorax.obj");
  CHECK(read_raw_surface(thorax, "thorax.obj").points.size() == 1974);
}
