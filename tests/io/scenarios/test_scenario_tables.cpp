#include <filesystem>

#include "anatomy/template_mesh.hpp"
#include "errors/input_error.hpp"
#include "math/units.hpp"
#include "scenarios/build_trunk.hpp"
#include "support/catch.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"
#include "support/trunks.hpp"
#include "trunks/read_trunk_pml.hpp"

using namespace trunk;
using namespace trunk::test;
using Kind = RegionLoad::Kind;
using Motion = RigidBody::Motion;

namespace {

Scenario scenario_of(const std::string& text) {
  TemporaryFolder folder;
  return read_scenario(folder.write("own.toml", text)).scenario;
}

/// The program's working folder for as long as a test needs another.
class WorkingFolder {
 public:
  explicit WorkingFolder(const std::filesystem::path& folder) { std::filesystem::current_path(folder); }
  ~WorkingFolder() { std::filesystem::current_path(before_); }

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
};

std::string pml_of_resolution(int resolution, const std::vector<RigidPart>& rigid = {}) {
  Scenario s;
  s.geometry.resolution = resolution;
  s.rigid = rigid;
  return trunk_pml(s);
}

}  // namespace

TEST_CASE("Tables [[rigid]] describe parts that are fixed, free, or driven by angle and shift",
          "[unit][io]") {
  const Scenario s = scenario_of(R"(
[[rigid]]
region = "lung_top"

[[rigid]]
region = "central_tendon"
motion = "free"

[[rigid]]
region = "rib_cage_right"
motion = "driven"
surface_for = "zone_of_apposition_right"
axis_point_mm = [10, 20, 600]
axis = [0, 3, 4]
events_deg = [[0, 0], [2, 90]]
direction = [1, 0, -2]
events_mm = [[1, 0], [2, 5]]
)");
  REQUIRE(s.rigid.size() == 3);
  CHECK(s.rigid[0].region == "lung_top");
  CHECK(s.rigid[0].motion == Motion::fixed);  // the default
  CHECK(s.rigid[0].surface_for.empty());
  CHECK(s.rigid[1].motion == Motion::free);
  CHECK_THAT(s.rigid[1].at.text(), EndsWith("own.toml:5"));
  const RigidPart& half = s.rigid[2];
  CHECK(half.motion == Motion::driven);
  CHECK(half.surface_for == "zone_of_apposition_right");
  CHECK(norm(half.imposed.point - Vec3d{0.010, 0.020, 0.600}) < 1e-15);
  CHECK(norm(half.imposed.axis - Vec3d{0, 0.6, 0.8}) < 1e-15);
  CHECK(half.imposed.angle(1.0) == Approx(std::numbers::pi / 4));
  CHECK(norm(half.imposed.direction - Vec3d{1, 0, -2}) == 0.0);
  CHECK(half.imposed.shift(1.5) == Approx(2.5e-3));
  CHECK(half.imposed.shift(0.5) == 0.0);
}

TEST_CASE("A part driven by only an angle or only a shift needs no key of the other", "[unit][io]") {
  const Scenario turned = scenario_of(
      "[[rigid]]\nregion = \"lung_top\"\nmotion = \"driven\"\naxis = [0, 0, 1]\n"
      "axis_point_mm = [0, 0, 0]\nevents_deg = [[0, 0], [1, 3]]\n");
  CHECK(norm(turned.rigid[0].imposed.axis - Vec3d{0, 0, 1}) == 0.0);
  CHECK(turned.rigid[0].imposed.shift(1.0) == 0.0);
  const Scenario shifted = scenario_of(
      "[[rigid]]\nregion = \"lung_top\"\nmotion = \"driven\"\ndirection = [0, 0, 1]\n"
      "events_mm = [[0, 0], [1, 3]]\n");
  CHECK(shifted.rigid[0].imposed.angle(1.0) == 0.0);
  const Trunk trunk = make_trunk(shifted);
  CHECK(norm(imposed_pose(trunk.model.bodies[0], 1.0).centre - Vec3d{0, 0, 3e-3}) < 1e-15);
}

TEST_CASE("Tables [[acceleration]] and [[pressure]] are converted to SI units", "[unit][io]") {
  const Scenario s = scenario_of(R"(
[[pressure]]
region = "abdominal_wall"
events_cmH2O = [[0, 0], [1, 5]]

[[pressure]]
region = "central_tendon"
direction = [0, 0, -1]
events_cmH2O = [[0, 2]]

[[acceleration]]
region = "*"
direction = [0, 1, 0]
events_m_s2 = [[0, 0], [1, 9.81]]
)");
  REQUIRE(s.loads.size() == 3);
  CHECK(s.loads[0].kind == Kind::acceleration);
  CHECK(s.loads[0].magnitude(1.0) == 9.81);
  CHECK(s.loads[1].kind == Kind::pressure);
  CHECK(s.loads[1].magnitude(0.5) == Approx(2.5 * 98.0665));
  CHECK(norm(s.loads[1].direction) == 0.0);
  CHECK(norm(s.loads[2].direction - Vec3d{0, 0, -1}) == 0.0);
  CHECK(make_trunk(s).model.pressures.size() == 1);
}

TEST_CASE("The axes of a displacement are the given ones, or else those of its direction", "[unit][io]") {
  const auto displacement = [](const std::string& keys) {
    const Scenario s = scenario_of("[[displacement]]\nregion = \"60\"\nevents_mm = [[0, 2]]\n" + keys);
    REQUIRE(s.loads.size() == 1);
    return s.loads[0];
  };
  CHECK(norm(displacement("direction = [0, 0, -2]\n").axes - Vec3d{0, 0, 1}) == 0.0);
  CHECK(norm(displacement("direction = [0, 0, 1]\naxes = [1, 0, 1]\n").axes - Vec3d{1, 0, 1}) == 0.0);
  CHECK(norm(displacement("axes = [7, 0, 0]\n").axes - Vec3d{1, 0, 0}) == 0.0);  // held at rest
  CHECK(norm(displacement("axes = [1, 1, 1]\ndirection = [0, 0, 0]\n").direction) == 0.0);
}

TEST_CASE("The resolution of the template is a whole number from 1 to 16", "[unit][io]") {
  CHECK(mesh_of(scenario_of("[geometry]\nresolution = 2\n")).rest.size() == 455);
  CHECK(scenario_of("title = \"a\"\n").geometry.resolution == 1);
  for (const char* bad : {"0", "17", "-1", "1.5", "2.0", "\"2\"", "true", "[2]", "99999999999999"}) {
    const std::string message = message_about("[geometry]\nresolution = " + std::string(bad) + "\n");
    INFO(message);
    CHECK_THAT(message, Contains("bad.toml:2: ") && Contains("geometry.resolution") &&
                            Contains("a whole number, 1 to 16"));
  }
  const auto healthy = scenario_folder() / "healthy_no_lung.toml";
  CHECK(read_scenario(healthy, {"geometry.resolution=3"}).scenario.geometry.resolution == 3);
  CHECK_THAT(message_of(healthy, {"geometry.resolution=1.5"}),
             Contains("--set geometry.resolution=1.5") && Contains("a whole number"));
  CHECK_THAT(message_of(healthy, {"geometry.resolution=4"}), Contains("time.dt_ms"));  // needs shorter steps
  CHECK(message_of(healthy, {"geometry.resolution=4", "time.dt_ms=0.2"}) == "no error");
}

TEST_CASE("The file of geometry.pml is beside the file that names it, or in the working folder with --set",
          "[unit][io]") {
  TemporaryFolder folder;
  std::filesystem::create_directory(folder / "sub");
  folder.write("sub/t.pml", pml_of_resolution(2));
  folder.write("t.pml", pml_of_resolution(1));
  const auto parent = folder.write("sub/parent.toml", "[geometry]\npml = \"t.pml\"\n[time]\ndt_ms = 0.2\n");
  const auto child = folder.write("child.toml", "extends = \"sub/parent.toml\"\n");
  const auto particles = [](const ScenarioFile& file) { return build_trunk(file).model.particles(); };
  for (const auto& path : {parent, child}) {
    const ScenarioFile file = read_scenario(path);
    CHECK(particles(file) == 455);
    CHECK(file.scenario.mesh_file == (folder / "sub/t.pml").string());
    CHECK(file.inputs.back() == folder / "sub/t.pml");
  }
  const WorkingFolder here(folder / "");
  CHECK(particles(read_scenario(parent, {"geometry.pml=t.pml"})) == 113);
  CHECK(particles(read_scenario(parent, {"geometry.pml=sub/../sub/t.pml"})) == 455);
  const ScenarioFile none = read_scenario(parent, {"geometry.pml="});
  CHECK(particles(none) == 113);
  CHECK(none.scenario.mesh == nullptr);
  CHECK_THAT(message_of(parent, {"geometry.pml=none.pml"}),
             Contains("none.pml: no such file") && Contains("(named in --set geometry.pml=none.pml)"));
  CHECK(scenario_of("[geometry]\npml = \"\"\n").mesh == nullptr);
  CHECK_THAT(message_about("[geometry]\npml = 3\n"), Contains("bad.toml:2: ") && Contains("name of a file"));
  CHECK_THAT(message_about("[geometry]\npml = \"bad.toml\"\n"),
             Contains("bad.toml:3: malformed XML") && EndsWith("bad.toml:2)"));
  CHECK_THAT(message_about("\n[geometry]\npml = \"none.pml\"\n"),
             Contains("none.pml: no such file") && EndsWith("bad.toml:3)"));
}

TEST_CASE("Replacing or removing a trunk also removes its rigid parts", "[regression][io]") {
  TemporaryFolder folder;
  folder.write("free.pml", pml_of_resolution(1, {{"central_tendon", Motion::free, {}, "", {}}}));
  folder.write("plain.pml", pml_of_resolution(1));
  const auto path = folder.write("own.toml", "[geometry]\npml = \"free.pml\"\n");
  const auto bodies = [&](const std::vector<std::string>& settings) {
    return build_trunk(read_scenario(path, settings)).model.bodies.size();
  };
  CHECK(bodies({}) == 2);
  CHECK(bodies({"geometry.pml="}) == 1);
  CHECK(bodies({"geometry.pml=" + (folder / "plain.pml").string()}) == 1);
  ScenarioFile file = read_scenario(path);
  for (int i = 0; i < 2; ++i) {
    apply_settings(std::vector<std::string>{"geometry.pml="}, file);
    CHECK(build_trunk(file).model.bodies.size() == 1);
    apply_settings(std::vector<std::string>{"geometry.pml=" + (folder / "free.pml").string()}, file);
    CHECK(build_trunk(file).model.bodies.size() == 2);
  }
  // As results keep it: the text names the file, and the trunk stands beside the text.
  const std::string text = "[geometry]\npml = \"" + (folder / "free.pml").string() + "\"\n";
  ScenarioFile kept =
      scenario_of_text(text, "run.h5", pml_of_resolution(1, {{"lung_top", Motion::fixed, {}, "", {}}}));
  REQUIRE(kept.scenario.rigid.size() == 1);
  CHECK(kept.scenario.rigid[0].region == "lung_top");  // the text's trunk counts, the file is not read
  apply_settings(std::vector<std::string>{"geometry.pml="}, kept);
  CHECK(kept.scenario.rigid.empty());
}

TEST_CASE("A rigid part of the scenario overrides the same part of its trunk", "[unit][io]") {
  TemporaryFolder folder;
  folder.write("free.pml", pml_of_resolution(1, {{"central_tendon", Motion::free, {}, "", {}},
                                                 {"lung_top", Motion::fixed, {}, "", {}}}));
  const Scenario s = read_scenario(folder.write("own.toml",
                                                "[geometry]\npml = \"free.pml\"\n[[rigid]]\nregion = "
                                                "\"central_tendon\"\nmotion = \"fixed\"\n"))
                         .scenario;
  REQUIRE(s.rigid.size() == 2);
  CHECK(s.rigid[0].motion == Motion::fixed);
  CHECK(s.rigid[1].region == "lung_top");
}

TEST_CASE("Bad tables of a scenario name file, line, what was found and what was expected", "[unit][io]") {
  const std::string part = "[[rigid]]\nregion = \"lung_top\"\n";
  const std::string driven = part + "motion = \"driven\"\n";
  struct Bad {
    std::string text, line;
    std::vector<std::string> parts;
  };
  const Bad cases[] = {
      {"\n[[rigid]]\nmotion = \"fixed\"\n", ":2:", {"[[rigid]]", "incomplete", "region"}},
      {part + "motion = \"loose\"\n", ":3:", {"rigid.motion", "loose", "\"fixed\", \"driven\" or \"free\""}},
      {part + "motion = 1\n", ":3:", {"rigid.motion", "1"}},
      {driven, ":1:", {"events_deg", "driven"}},
      {part + "events_deg = [[0, 1]]\n", ":1:", {"driven"}},
      {part + "motion = \"free\"\nevents_mm = [[0, 1]]\n", ":1:", {"driven"}},
      {driven + "events_deg = 3\n", ":4:", {"rigid.events_deg", "pairs"}},
      {driven + "events_deg = [[1, 0], [1, 2]]\n", ":4:", {"rigid.events_deg", "increase"}},
      {driven + "events_deg = [[0, nan]]\n", ":4:", {"rigid.events_deg", "finite"}},
      {driven + "axis = [0, 0, 0]\nevents_deg = [[0, 1]]\n", ":4:", {"rigid.axis", "zero"}},
      {driven + "axis = [0, 1]\nevents_deg = [[0, 1]]\n", ":4:", {"rigid.axis", "three numbers"}},
      {driven + "axis_point_mm = 5\nevents_deg = [[0, 1]]\n", ":4:", {"axis_point_mm", "three numbers"}},
      {driven + "events_rad = [[0, 1]]\n", ":4:", {"events_rad", "events_deg"}},
      {driven + "direction = [0, 0, 0]\nevents_mm = [[0, 1]]\n", ":1:", {"direction"}},
      {driven + "events_mm = [[0, 1]]\n", ":1:", {"direction"}},
      {driven + "direction = [0, 0, 1]\nevents_mm = [[0, 1]]\n", ":1:", {"jump"}},
      {driven + "events_deg = [[0, 0], [1, 1]]\n", ":1:", {"axis_point_mm"}},
      {"[[rigid]]\nregion = 7\n", ":2:", {"region"}},
      {"[rigid]\nregion = \"lung_top\"\n", ":1:", {"[[rigid]]"}},
      {"[[rigid]]\nregion = \"sternum\"\n", ":1:", {"'sternum'", "rib_cage_right"}},
      {"[[rigid]]\nregion = \"lung_wall\"\nsurface_for = \"lung_top\"\n", ":1:", {"cannot slide"}},
      {"[[pressure]]\nregion = \"60\"\nevents_cmH2O = [[0, 1]]\n", ":1:", {"no triangle"}},
      {"[[pressure]]\nregion = \"pelvis\"\nevents_Pa = [[0, 1]]\n", ":3:", {"events_Pa", "events_cmH2O"}},
      {"[[pressure]]\nregion = \"pelvis\"\n", ":1:", {"incomplete", "events_cmH2O"}},
      {"[[pressure]]\nregion = \"pelvis\"\naxes = [0, 0, 1]\n", ":3:", {"axes"}},
      {"[[acceleration]]\nregion = \"*\"\nevents_m_s2 = [[0, 1]]\n", ":1:", {"incomplete", "direction"}},
      {"[[acceleration]]\nregion = \"*\"\ndirection = [0, 0, 0]\nevents_m_s2 = [[0, 1]]\n", ":3:", {"zero"}},
      {"[[acceleration]]\nregion = \"*\"\nevents_N = [[0, 1]]\n", ":3:", {"events_N", "events_m_s2"}},
      {"[[displacement]]\nregion = \"60\"\naxes = [0, 0, 0]\ndirection = [0, 0, 1]\nevents_mm = [[0, 0], [1, "
       "1]]\n",
       ":1:",
       {"incomplete"}},
      {"[[displacement]]\nregion = \"60\"\naxes = \"z\"\nevents_mm = [[0, 1]]\n", ":3:", {"three numbers"}},
      {"[[displacement]]\nregion = \"lung_top\"\ndirection = [0, 0, 1]\nevents_mm = [[0, 1]]\n[[rigid]]\n"
       "region = \"lung_top\"\nmotion = \"driven\"\ndirection = [0, 0, 1]\nevents_mm = [[0, 0], [1, 1]]\n",
       ":1:",
       {"moving rigid part"}},
  };
  for (const Bad& bad : cases) {
    const std::string message = message_about(bad.text);
    INFO(bad.text << "--> " << message);
    CHECK_THAT(message, Contains("bad.toml" + bad.line));
    for (const std::string& wanted : bad.parts) CHECK_THAT(message, Contains(wanted));
    CHECK(message.find("bad.toml") == message.rfind("bad.toml"));
    CHECK(message.find('\n') == std::string::npos);
  }
}
