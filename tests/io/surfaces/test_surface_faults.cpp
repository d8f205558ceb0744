#include "errors/input_error.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "support/zoo.hpp"
#include "surfaces/formats/raw_surface.hpp"
#include "surfaces/read_surface.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

std::string message_of_surface(const std::string& content, const SurfaceOptions& options = {}) {
  TemporaryFolder folder;
  try {
    read_surface(folder.write("x", content), options);
  } catch (const InputError& error) {
    const std::string text = error.what();
    CHECK(text.find('\n') == std::string::npos);
    return text.substr((folder / "x").string().size());
  }
  return "no error";
}

std::string obj_of(const Mesh& mesh, double unit = 1000.0) {
  std::string text;
  for (const Vec3d& p : mesh.position)
    text += "v " + std::to_string(unit * p.x()) + " " + std::to_string(unit * p.y()) + " " +
            std::to_string(unit * p.z()) + "\n";
  for (const Triangle& t : mesh.triangles)
    text += "f " + std::to_string(t[0] + 1) + " " + std::to_string(t[1] + 1) + " " +
            std::to_string(t[2] + 1) + "\n";
  return text;
}

const std::string three_points = "v 0 0 0\nv 100 0 0\nv 0 100 0\n";
const std::string vtk_head = "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\n";
const std::string ply_head =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string vtp_head = "<VTKFile type=\"PolyData\">\n<PolyData><Piece>\n<Points>";

}  // namespace

TEST_CASE("Every fault of a surface gives an error of one line, with the line of the file",
          "[unit][surfaces]") {
  struct Fault {
    std::string content, says;
  };
  const Fault faults[] = {
      {"", "empty"},
      {"hello world\n", "format is not known"},
      {"\x89PNG\r\n\x1a\n" + std::string(500, '\xFF'), "a picture found; expected a surface"},
      {"v 0 0 0\nv 1 nan 0\n", ":2: 'nan' found; expected a coordinate, a finite number"},
      {"v 0 0 0\nv 1 1e999 0\n", ":2: '1e999' found"},
      {"v 0 0\nv 1 1 0\n", ":1: the line ends here; expected a coordinate"},
      {"v 0 0 zero\n", ":1: 'zero' found; expected a coordinate"},
      {"v 0 0 1e300\n", ":1: coordinate 1e+300 of point 0"},
      {three_points + "f 1 2 4\n", ":4: a polygon has corner 3 (counted from 0), but there are 3 points"},
      {three_points + "f 1 2 0\n", ":4: corner '0' found; expected the number of a point, from 1"},
      {three_points + "f 1 2 -4\n", ":4: a polygon has corner -1"},
      {three_points + "f 1 2 99999999999999999999\n", ":4: corner '9999"},
      {three_points + "f 1 2\n", "3 points and no triangle"},
      {three_points, "no triangle"},
      {three_points + "f 1 2 3\n", "one plane"},
      {three_points + "f 1 1 1\n", "degenerate"},
      {"solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\n", ":4: 'x' found; expected a coordinate"},
      {"solid x\nfacet\nouter loop\nvertex 0 0 0\n", "ends within a facet"},
      {"solid x\nendsolid x\n", "no triangle"},
      {"solid x\nnonsense\n", ":2: 'nonsense' found"},
      {std::string(80, 'x') + std::string("\x05\0\0\0", 4) + std::string(60, '\0'),
       "144 bytes found; expected 334 for the 5 triangles"},
      {"ply\nformat middle 1.0\n", ":2: format 'middle'"},
      {"ply\nformat ascii 1.0\nelement vertex 99999999999\n", ":3: '99999999999' found; expected how many"},
      {"ply\nformat ascii 1.0\nelement vertex 3\nproperty quad x\n", ":4: property of type 'quad'"},
      {"ply\nformat ascii 1.0\nelement vertex 3\n", "no end"},
      {ply_head + "end_header\n0 0 0\n1 0\n", "the file ends here; expected a number"},
      {ply_head + "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 "
                  "0\n3 0 1 7\n",
       ":13: a polygon has corner 7"},
      {ply_head + "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 "
                  "0\n-3 0 1 7\n",
       "a list of -3 numbers"},
      {"ply\nformat binary_little_endian 1.0\nelement vertex 90000000\nproperty float x\nproperty float "
       "y\nproperty float "
       "z\nend_header\n",
       "ends within"},
      {"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n1\n2\n3\n", "no x, y and z"},
      {"# vtk DataFile Version 3.0\nt\nOTHER\n", ":4: 'OTHER' found; expected ASCII or BINARY"},
      {"# vtk DataFile Version 3.0\nt\nASCII\nDATASET RECTILINEAR_GRID\n",
       "expected POLYDATA or UNSTRUCTURED_GRID"},
      {vtk_head + "POINTS 99999999999 float\n", ":5: '99999999999' found"},
      {vtk_head + "POINTS 2 string\n", "type 'string'"},
      {vtk_head + "POINTS 2 float\n0 0 0 1 1\n", "the file ends here"},
      {vtk_head + "POINTS 1 float\n0 0 0\nPOLYGONS 1 4\n9 0 0 0\n",
       "a polygon of 9 corners found where 3 numbers"},
      {vtk_head + "POINTS 1 float\n0 0 0\nPOLYGONS 1 4\n3 0 0 1\n",
       "corner 1 (counted from 0), but there are 1"},
      {"# vtk DataFile Version 3.0\nt\nBINARY\nDATASET POLYDATA\nPOINTS 1000 float\nabc",
       "ends within its binary"},
      {"<VTKFile type=\"RectilinearGrid\"/>", "not of type PolyData"},
      {"<VTKFile type=\"PolyData\" compressor=\"vtkOtherCompressor\"><PolyData/></VTKFile>",
       "compressor 'vtkOtherCompressor' found; expected vtkZLibDataCompressor, vtkLZ4DataCompressor"},
      {"<VTKFile type=\"PolyData\"><PolyData/></VTKFile>", "no triangle"},
      {vtp_head, "malformed XML"},
      {vtp_head + "<DataArray type=\"Float32\" NumberOfComponents=\"3\" "
                  "format=\"binary\">AAAAgA==</DataArray></Points>"
                  "</Piece></PolyData></VTKFile>",
       ":3: an array of 2147483648 bytes found"},
      {vtp_head + "<DataArray type=\"Float32\" NumberOfComponents=\"3\" "
                  "format=\"binary\">CAAAAAAA</DataArray></Points>"
                  "</Piece></PolyData></VTKFile>",
       "but its header names 8"},
      {vtp_head +
           "<DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"appended\" offset=\"7\"/></Points>"
           "</Piece></PolyData></VTKFile>",
       "offset 7 found in appended data of 0 bytes"},
      {"<physicalModel><atoms/></physicalModel>", "expected one"},
      {"<!DOCTYPE x><VTKFile/>", "DOCTYPE"}};
  for (const Fault& fault : faults) {
    INFO(fault.content.substr(0, 200));
    CHECK_THAT(message_of_surface(fault.content), Contains(fault.says));
  }
}

TEST_CASE("A compressed array cannot grow beyond its bound", "[unit][surfaces]") {
  // 3 blocks of 4 GB, announced in a header of 24 bytes.
  const std::string array =
      "<DataArray type=\"Float64\" NumberOfComponents=\"3\" "
      "format=\"binary\">AwAAAP////8AAAAAAQAAAAEAAAABAAAA"
      "AAAA</DataArray></Points></Piece></PolyData></VTKFile>";
  const std::string head = vtp_head;
  const std::string file =
      "<VTKFile type=\"PolyData\" compressor=\"vtkZLibDataCompressor\">" + head.substr(head.find('\n'));
  CHECK_THAT(message_of_surface(file + array), Contains("bytes found; thin the surface"));
}

TEST_CASE("The unit is guessed from the size, and a size that no trunk has is refused", "[unit][surfaces]") {
  TemporaryFolder folder;
  const Mesh ball = icosphere(0.1, 2);
  for (const auto& [scale, unit] : {std::pair{1000.0, "mm"}, {100.0, "cm"}, {1.0, "m"}}) {
    const ImportedSurface file = read_surface(folder.write("ball.obj", obj_of(ball, scale)));
    CHECK(file.unit == unit);
    CHECK(largest_extent(file.surface) == Approx(0.2).epsilon(0.01));
    CHECK_THAT(file.notes.at(1), Contains(std::string("taken as ") + unit));
    CHECK_THAT(file.notes.front(), Contains("axes assumed to be RAS") && Contains("--axes LPS"));
  }
  CHECK_THAT(message_of_surface(obj_of(ball, 1e5)), Contains("expected 0.05 to 1 m"));
  CHECK_THAT(message_of_surface(obj_of(ball, 0.01)), Contains("--surface-unit"));
  CHECK_THAT(message_of_surface(obj_of(ball, 1000.0), {"m", "", "", ""}), Contains("check the unit"));
  CHECK_THAT(message_of_surface(obj_of(ball, 1000.0), {"inch", "", "", ""}),
             Contains("expected mm, cm or m"));
  CHECK_THAT(message_of_surface(obj_of(ball), {"", "LLS", "", ""}), Contains("axes") || Contains("R/L"));
}

TEST_CASE("Axes that neither user nor file names are those of the subject's other surfaces",
          "[unit][surfaces]") {
  TemporaryFolder folder;
  const std::string ball = obj_of(icosphere(0.1, 1));
  const auto axes_of = [&](const std::string& content, const SurfaceOptions& options) {
    return read_surface(folder.write("x.obj", content), options).axes;
  };
  CHECK(axes_of(ball, {}) == "RAS");
  CHECK(axes_of(ball, {"", "", "", "LSA"}) == "LSA");
  CHECK(axes_of("# SPACE=LPS\n" + ball, {"", "", "", "LSA"}) == "LPS");
  CHECK(axes_of("# SPACE=LPS\n" + ball, {"", "ASR", "", "LSA"}) == "ASR");
}

TEST_CASE("One component can be chosen, and must be there", "[unit][surfaces]") {
  TemporaryFolder folder;
  const std::string ball = obj_of(icosphere(0.1, 1)), two = "o left\n" + ball + "o right\nf 1 2 3\n";
  const ImportedSurface left = read_surface(folder.write("two.obj", two), {"", "", "left", ""});
  CHECK(left.surface.triangles.size() == icosphere(0.1, 1).triangles.size());
  CHECK_THAT(message_of_surface(two, {"", "", "middle", ""}),
             Contains("'middle'") && Contains("'left' 'right'"));
}
