#include "trunks/region_loads_lml.hpp"

#include <cmath>
#include <numeric>

#include "errors/input_error.hpp"
#include "scenarios/build_trunk.hpp"
#include "support/catch.hpp"
#include "support/shared_data.hpp"
#include "support/temporary_folder.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;
using Kind = RegionLoad::Kind;

namespace {

std::string load(const std::string& type, const std::string& applied_to, const std::string& towards,
                 const std::string& unit = "",
                 const std::string& events = "<valueEvent date='0' value='1'/>") {
  return "<load xsi:type='" + type + "'><appliedTo>" + applied_to + "</appliedTo>" + events + "<direction " +
         towards + "/>" + (unit.empty() ? "" : "<unit>" + unit + "</unit>") + "</load>\n";
}

/// The first load is on line 2.
std::string lml(const std::string& loads) {
  return "<loads xmlns='http://www-timc.imag.fr/load' "
         "xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance'>\n" +
         loads + "</loads>\n";
}

std::vector<RegionLoad> loads_of(const std::string& loads) {
  TemporaryFolder folder;
  return read_region_loads(folder.write("some.lml", lml(loads)));
}

RegionLoad one(const std::string& text) {
  const auto loads = loads_of(text);
  REQUIRE(loads.size() == 1);
  return loads[0];
}

/// A trunk with the loads that a scenario takes from an LML file, as the program builds it.
Trunk trunk_with(const std::string& loads, const std::string& more = "") {
  TemporaryFolder folder;
  folder.write("some.lml", lml(loads));
  return build_trunk(read_scenario(folder.write("own.toml", "loads = \"some.lml\"\n" + more)));
}

std::string loads_message(const std::string& loads, const std::string& more = "") {
  try {
    trunk_with(loads, more);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

void check_same(const RegionLoad& a, const RegionLoad& b) {
  CHECK(a.kind == b.kind);
  CHECK(a.region == b.region);
  CHECK(norm(a.direction - b.direction) == 0.0);
  if (a.kind == Kind::displacement) CHECK(norm(a.axes - b.axes) == 0.0);
  REQUIRE(a.magnitude.events().size() == b.magnitude.events().size());
  for (std::size_t k = 0; k < a.magnitude.events().size(); ++k) {
    CHECK(a.magnitude.events()[k].time_s == b.magnitude.events()[k].time_s);
    const double value =
        b.magnitude.events()[k].value;  // in mm or kPa it may move by one unit in its last place
    CHECK(std::abs(a.magnitude.events()[k].value - value) <=
          std::abs(std::nextafter(value, HUGE_VAL) - value));
  }
}

}  // namespace

TEST_CASE("Each kind of load is read in SI units", "[unit][io]") {
  const std::string x = "x='2' y='0' z='-1'";
  const auto is = [&](const std::string& type, const std::string& unit, Kind kind, double si) {
    CAPTURE(type, unit);
    const RegionLoad read = one(load(type, "pelvis", x, unit));
    CHECK(read.kind == kind);
    CHECK(read.region == "pelvis");
    CHECK(norm(read.direction - Vec3d{2, 0, -1}) == 0.0);
    CHECK(read.magnitude(0.0) == Approx(si).epsilon(1e-15));
    CHECK_THAT(read.at.text(), EndsWith("some.lml:2"));
  };
  is("Translation", "", Kind::displacement, 1e-3);
  is("Translation", "mm", Kind::displacement, 1e-3);
  is("Translation", "m", Kind::displacement, 1.0);
  is("Force", "", Kind::force, 1.0);
  is("Force", "kN", Kind::force, 1e3);
  is("Acceleration", "m/s2", Kind::acceleration, 1.0);
  is("Pressure", "Pa", Kind::pressure, 1.0);
  is("Pressure", "cmH2O", Kind::pressure, 98.0665);
  is("Pressure", "kPa", Kind::pressure, 1e3);
}

TEST_CASE("Every unit of CamiTK's schema is read, and loads are written in these", "[unit][io][faults]") {
  const std::string x = "x='1' y='0' z='0'";
  const auto si = [&](const std::string& type, const std::string& unit) {
    return one(load(type, "pelvis", x, unit)).magnitude(0.0);
  };
  CHECK(si("Translation", "mm") == 1e-3);
  CHECK(si("Translation", "micron") == 1e-6);
  CHECK(si("Translation", "nm") == 1e-9);
  CHECK(si("Force", "pN") == 1e-12);
  CHECK(si("Force", "N") == 1.0);
  CHECK(si("Force", "kN") == 1e3);
  CHECK(si("Pressure", "kPa") == 1e3);
  CHECK(si("Pressure", "mmHg") == Approx(133.322));
  CHECK(si("Acceleration", "m/s^2") == 1.0);
  CHECK(si("Acceleration", "cm/s^2") == 1e-2);
  CHECK(si("Acceleration", "mm/s^2") == 1e-3);
  std::vector<RegionLoad> all(4);
  for (std::size_t k = 0; k < 4; ++k) {
    all[k].kind = static_cast<Kind>(k);
    all[k].region = "pelvis";
    all[k].direction = all[k].axes = {0, 0, 1};
    all[k].magnitude = PiecewiseLinear({{0.0, 0.25}});
  }
  const std::string text = region_loads_lml(all);
  for (const char* unit : {"<unit>N</unit>", "<unit>mm</unit>", "<unit>m/s^2</unit>", "<unit>kPa</unit>"})
    CHECK_THAT(text, Contains(unit));
  for (const char* other : {"<unit>m</unit>", "<unit>Pa</unit>", "m/s2"}) CHECK_THAT(text, !Contains(other));
  CHECK_THAT(text, Contains("value=\"250\"") && Contains("value=\"0.00025\""));  // mm and kPa
}

TEST_CASE("A load is 0 before its first event, linear between events and constant after the last",
          "[unit][io]") {
  const auto course =
      one(load("Force", "pelvis", "x='1'", "N",
               "<valueEvent date='1' value='2'/><valueEvent date='2' value='4'/><valueEvent date='4' "
               "value='-4'/>"))
          .magnitude;
  CHECK(course(0.999) == 0.0);
  CHECK(course(1.0) == 2.0);
  CHECK(course(1.5) == 3.0);
  CHECK(course(3.0) == 0.0);
  CHECK(course(3.5) == -2.0);
  CHECK(course(9.0) == -4.0);
}

TEST_CASE("In a translation, a number imposes an axis, NULL holds it, and an absent axis stays free",
          "[unit][io]") {
  const RegionLoad read = one(load("Translation", "pelvis", "x='NULL' z='3'", "mm"));
  CHECK(norm(read.axes - Vec3d{1, 0, 1}) == 0.0);
  CHECK(norm(read.direction - Vec3d{0, 0, 3}) == 0.0);
  CHECK(norm(one(load("Translation", "pelvis", "y='0'")).axes - Vec3d{0, 1, 0}) == 0.0);

  const Trunk trunk = trunk_with(load("Translation", "60", "x='NULL' z='3'", "mm"));
  const Vec3d mobility = trunk.model.mobility[60];
  CHECK(norm(mobility - Vec3d{0, 1, 0}) == 0.0);
  REQUIRE(trunk.model.imposed_displacements.size() == 1);
  std::vector<Vec3d> position = trunk.model.rest;
  position[60] += Vec3d{0.1, 0.2, 0.3};
  impose_displacements<double>(trunk.model, 0.0, position);
  CHECK(norm(position[60] - trunk.model.rest[60] - Vec3d{0, 0.2, 3e-3}) < 1e-15);
}

TEST_CASE("Load targets are indexes, ranges, names, all atoms, and lists of these", "[unit][io]") {
  const auto particles_of = [](const std::string& applied_to) {
    std::vector<int> particles;
    for (const FocalForce& f : trunk_with(load("Force", applied_to, "z='1'")).model.focal_forces)
      particles.push_back(f.particle);
    return particles;
  };
  const TrunkMesh mesh = mesh_of(Scenario{});
  std::vector<int> all(113);
  std::iota(all.begin(), all.end(), 0);
  CHECK(particles_of("7") == std::vector<int>{7});
  CHECK(particles_of("0-3,7,9-11") == std::vector<int>{0, 1, 2, 3, 7, 9, 10, 11});
  CHECK(particles_of("5,3-6,4") == std::vector<int>{3, 4, 5, 6});  // each once
  CHECK(particles_of("central_tendon") == mesh.named("central_tendon"));
  CHECK(particles_of("*") == all);
  CHECK(particles_of("3, *") == all);
  auto tendon_and_two = mesh.named("central_tendon");
  tendon_and_two.insert(tendon_and_two.begin(), {0, 1});
  CHECK(particles_of("central_tendon,0-1") == tendon_and_two);
}

TEST_CASE("A force acts on each particle, and an acceleration acts on its mass", "[unit][io]") {
  const Trunk forced = trunk_with(load("Force", "60-62", "z='2'", "kN"));
  REQUIRE(forced.model.focal_forces.size() == 3);
  for (const FocalForce& f : forced.model.focal_forces)
    CHECK(norm(f.magnitude(1.0) * f.direction - Vec3d{0, 0, 2000}) < 1e-9);

  const Trunk shaken = trunk_with(load("Acceleration", "*", "z='-9.81'", "m/s2"));
  Scenario heavy;
  heavy.gravity = {0, 0, -9.81};
  std::vector<Vec3d> force(113), weight(113);
  add_focal<double>(shaken.model.focal_forces, 0.5, force);
  set_gravity<double>(make_trunk(heavy).model, weight);
  CHECK(largest(weight) > 1.0);
  CHECK(largest(difference(force, weight)) < 1e-14);
}

TEST_CASE("A pressure acts on the triangles within its targets, or along its direction if it has one",
          "[unit][io]") {
  const Trunk tendon = trunk_with(load("Pressure", "central_tendon", "x='0' y='0' z='0'", "kPa"));
  REQUIRE(tendon.model.pressures.size() == 1);
  CHECK(tendon.model.focal_forces.empty());
  CHECK(tendon.model.pressures[0].triangles.size() == 24);  // 12 + 6 to the ring of 6, 6 to the saddle
  CHECK(tendon.model.pressures[0].magnitude(1.0) == 1000.0);

  const Trunk along = trunk_with(load("Pressure", "central_tendon", "z='-1'", "kPa"));
  CHECK(along.model.pressures.empty());
  double area = 0.0;
  for (const Triangle& t : tendon.model.pressures[0].triangles) {
    const auto corner = [&](std::size_t k) { return along.model.rest[static_cast<std::size_t>(t[k])]; };
    area += 0.5 * norm(cross(corner(1) - corner(0), corner(2) - corner(0)));
  }
  std::vector<Vec3d> force(113);
  add_focal<double>(along.model.focal_forces, 1.0, force);
  CHECK(norm(total(force) - Vec3d{0, 0, -1000.0 * area}) < 1e-10);
  CHECK_THAT(loads_message(load("Pressure", "60", "x='0'", "Pa")), Contains("no triangle"));
}

TEST_CASE("Loads written as LML and read again are the same", "[property][io]") {
  Random random(111);
  const char* regions[] = {"pelvis", "*", "0-3,7", "central_tendon,5", "3rd_rib", "3x", "3x7", "12-", "7"};
  TemporaryFolder folder;
  for (int i = 0; i < 200; ++i) {
    std::vector<RegionLoad> loads;
    for (int k = 0; k < 3; ++k) {
      RegionLoad load;
      load.kind = static_cast<Kind>(random.bits() % 4);
      load.region = regions[random.bits() % (std::size(regions) - 2)];
      const auto some = [&] { return random.unit() < 0.4 ? 0.0 : random.between(-2, 2); };
      load.direction = {some(), some(), some()};
      if (load.kind == Kind::force || load.kind == Kind::acceleration) load.direction += Vec3d{0, 0, 3};
      if (load.kind == Kind::displacement) {
        const auto mark = [&] { return random.unit() < 0.5 ? 1.0 : 0.0; };
        load.axes = {mark(), mark(), 1.0};
        load.direction = hadamard(load.axes, load.direction);
      }
      load.magnitude = PiecewiseLinear(
          {{random.unit(), random.between(-5, 5)}, {1.0 + random.unit(), random.between(-5, 5)}});
      loads.push_back(load);
    }
    const std::string text = region_loads_lml(loads);
    INFO(text);
    const auto again = read_region_loads(folder.write("again.lml", text));
    REQUIRE(again.size() == loads.size());
    for (std::size_t k = 0; k < loads.size(); ++k) check_same(again[k], loads[k]);
  }
}

TEST_CASE("A pressure without a direction and axes left free survive LML", "[regression][io]") {
  RegionLoad pressure;
  pressure.kind = Kind::pressure;
  pressure.region = "abdominal_wall";
  pressure.magnitude = PiecewiseLinear({{0.0, 500.0}});
  RegionLoad sideways;  // a direction along x, of which only z is imposed
  sideways.kind = Kind::displacement;
  sideways.region = "central_tendon";
  sideways.direction = {1, 0, 2};
  sideways.axes = {0, 1, 1};
  sideways.magnitude = PiecewiseLinear({{0.0, 0.001}});
  TemporaryFolder folder;
  const auto again = read_region_loads(folder.write("a.lml", region_loads_lml({pressure, sideways})));
  REQUIRE(again.size() == 2);
  check_same(again[0], pressure);
  sideways.direction = {0, 0, 2};  // what it does
  check_same(again[1], sideways);
}

TEST_CASE("The published compression is read as loads of regions", "[shared][io]") {
  const auto loads = read_region_loads(test::shared_file("surfaces/compression-12.lml"));
  REQUIRE(loads.size() == 2);
  CHECK(loads[0].region == "648-728");
  CHECK(loads[1].region == "0-80");
  for (const RegionLoad& load : loads) {
    CHECK(load.kind == Kind::displacement);
    CHECK(norm(load.axes - Vec3d{1, 1, 1}) == 0.0);
  }
  CHECK(norm(loads[0].magnitude(1.0) * loads[0].direction) == 0.0);  // held
  CHECK(norm(loads[1].magnitude(5.0) * loads[1].direction - Vec3d{0, 0, 5e-3}) < 1e-17);
  CHECK(loads[1].magnitude(20.0) == Approx(10e-3));
  CHECK_THAT(loads[1].at.text(), Contains("compression-12.lml:17"));
}

TEST_CASE("A load that cannot be simulated is refused with file and line", "[unit][io]") {
  const std::string good = load("Force", "pelvis", "z='1'");
  REQUIRE(loads_message(good) == "no error");
  const auto refused = [&](const std::string& bad, const std::vector<std::string>& parts) {
    const std::string message = loads_message(good + bad);
    INFO(message);
    CHECK_THAT(message, Contains("some.lml:3: "));
    for (const std::string& part : parts) CHECK_THAT(message, Contains(part));
    CHECK(message.find("some.lml") == message.rfind("some.lml"));
    CHECK(message.find('\n') == std::string::npos);
  };
  refused(load("Rotation", "pelvis", "z='1'", "deg"), {"Rotation", "[[rigid]]", "events_deg"});
  refused(load("Force", "pelvis", "toward='3'"), {"toward", "x, y and z"});
  refused(load("Force", "pelvis", "x='0' y='NULL'"), {"direction of zero"});
  refused(load("Acceleration", "pelvis", "z='0'"), {"direction of zero"});
  refused(load("Force", "liver", "z='1'"), {"'liver'", "abdominal_wall", "dome_top_right"});
  refused(load("Force", "pelvis,liver", "z='1'"), {"'liver'"});
  refused(load("Force", "113", "z='1'"), {"'113'", "0 to 112"});
  refused(load("Force", "110-113", "z='1'"), {"'110-113'", "0 to 112"});
  refused(load("Force", "pelvis", "z='1'", "mm"), {"'mm'", "N, kN"});
  refused(load("Pressure", "60,61", "x='0'", "Pa"), {"no triangle", "60"});
  refused(load("Push", "pelvis", "z='1'"), {"'Push'"});
  refused(load("Force", "pelvis", "z='1'", "",
               "<valueEvent date='1' value='1'/><valueEvent date='1' value='2'/>"),
          {"increasing"});
}

TEST_CASE("A displacement from LML on a moving part is refused with its line", "[unit][io]") {
  const std::string message = loads_message(load("Translation", "central_tendon", "z='1'"),
                                            "[[rigid]]\nregion = \"central_tendon\"\nmotion = \"free\"\n");
  CHECK_THAT(message, Contains("some.lml:2: ") && Contains("moving rigid part"));
}

TEST_CASE("A scenario reads its loads from an LML file beside it, in addition to its own", "[unit][io]") {
  TemporaryFolder folder;
  std::filesystem::create_directory(folder / "sub");
  folder.write("sub/some.lml", lml(load("Force", "pelvis", "z='1'") + load("Translation", "61", "z='1'")));
  const auto path = folder.write(
      "sub/own.toml",
      "loads = \"some.lml\"\n[[force]]\nregion = \"central_tendon\"\ndirection = [0, 0, -1]\nevents_N = "
      "[[0, 3]]\n");
  const ScenarioFile file = read_scenario(path);
  REQUIRE(file.scenario.loads.size() == 3);
  CHECK(file.scenario.loads[0].region == "central_tendon");
  CHECK(file.scenario.loads[1].region == "pelvis");
  CHECK(file.scenario.loads[2].kind == Kind::displacement);
  REQUIRE(file.inputs.size() == 2);  // both are named in the results
  CHECK(file.inputs.back() == folder / "sub/some.lml");
  const Trunk trunk = build_trunk(file);
  CHECK(trunk.model.focal_forces.size() == 13 + 19);
  CHECK(trunk.model.imposed_displacements.size() == 1);

  // All of it is in the scenario's own text, which needs the file no more.
  std::filesystem::remove(folder / "sub/some.lml");
  const ScenarioFile again = read_scenario(folder.write("again.toml", to_toml(file.scenario)));
  CHECK(again.scenario.loads.size() == 3);
  CHECK(build_trunk(again).model.focal_forces.size() == 13 + 19);
}

TEST_CASE("An LML file that cannot be read is named", "[unit][io]") {
  TemporaryFolder folder;
  const auto message = [&](const std::string& text) -> std::string {
    try {
      read_scenario(folder.write("own.toml", text));
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  CHECK_THAT(message("loads = \"none.lml\"\n"),
             Contains("none.lml: no such file") && Contains("own.toml:1)"));
  CHECK_THAT(message("\nloads = 3\n"), Contains("own.toml:2: ") && Contains("3") && Contains("LML file"));
  folder.write("bad.lml", "<loads");
  CHECK_THAT(message("loads = \"bad.lml\"\n"), Contains("bad.lml:1: "));
}
