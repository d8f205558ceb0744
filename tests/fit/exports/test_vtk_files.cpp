#include "errors/input_error.hpp"
#include "exports/vtk_files.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "surfaces/read_surface.hpp"

using namespace trunk;

namespace {

/// A triangle with one fibre that moves up by 1 m.
Trajectory moving_triangle() {
  Trajectory t;
  t.particles = 3;
  t.time_s = {0.0, 0.25};
  t.position_m = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1};
  t.triangles = {{0, 1, 2}};
  t.triangle_component = {0};
  t.component_names = {"abdomen"};
  t.fibres = {{0, 2}};
  return t;
}

}  // namespace

TEST_CASE("A trajectory becomes one file for each frame, and a list of them over time", "[exports]") {
  const auto files = vtk_files(moving_triangle(), "r.h5");
  REQUIRE(files.size() == 3);
  CHECK(files[0].name == "frames/frame_00000.vtp");
  CHECK(files[1].name == "frames/frame_00001.vtp");
  CHECK(files[2].name == "trunk.pvd");
  for (std::size_t i : {0u, 1u}) CHECK_THAT(files[2].text, Contains("file=\"" + files[i].name + "\""));
  CHECK_THAT(files[2].text, Contains("timestep=\"0.25\""));
  CHECK_THAT(files[1].text, Contains("Name=\"displacement\" NumberOfComponents=\"3\" format=\"ascii\">\n"
                                     "0 0 1 0 0 1 0 0 1 \n"));
  CHECK_THAT(files[1].text,
             Contains("Name=\"component\" format=\"ascii\">\n1 0 \n"));      // the fibre comes first
  CHECK_THAT(files[1].text, !Contains("velocity") && !Contains("contact"));  // the run has none
}

TEST_CASE("A run without trajectory is refused", "[exports]") {
  CHECK_THROWS_WITH(vtk_files({}, "r.h5"),
                    "r.h5: has no trajectory; expected a run simulated without --every 0");
}

TEST_CASE("The surface reader reads a written surface back", "[exports]") {
  const std::vector<double> points{0, 0, 0, 0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.123456789};
  const std::vector<std::array<std::int32_t, 3>> triangles{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  const test::TemporaryFolder folder;
  const auto path = folder.write("s.vtp", surface_vtp(points, triangles, {{"side_mm", "mm", {1, 2, 3, 4}}}));
  const auto read = read_surface(path, {.unit = "m", .axes = "RAS", .component = "", .axes_of_others = ""});
  REQUIRE(read.surface.points.size() == 4);
  REQUIRE(read.surface.triangles.size() == 4);
  double highest = 0.0;
  for (const Vec3d& p : read.surface.points) highest = std::max(highest, p.z());
  CHECK(highest == Approx(0.123456789).epsilon(1e-9));
}
