#include "trunks/read_trunk_pml.hpp"

#include <algorithm>
#include <cmath>

#include "anatomy/template_mesh.hpp"
#include "errors/input_error.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

TrunkGeometry random_geometry(Random& random, int resolution) {
  TrunkGeometry g;
  g.half_width = random.between(0.12, 0.20);
  g.half_depth = random.between(0.08, 0.12);
  g.abdomen_height = random.between(0.15, 0.25);
  g.apposition_length = random.between(0.08, 0.16);
  g.dome_height_right = random.between(0.04, 0.08);
  g.dome_height_left = random.between(0.04, 0.08);
  g.end_expiratory_volume = random.between(6000e-6, 8000e-6);
  g.resolution = resolution;
  return g;
}

/// A scenario whose trunk is the one in the text.
Scenario from_pml(const Scenario& scenario, const std::string& text) {
  TrunkFile file = trunk_of_pml(text, "t.pml");
  Scenario again = scenario;
  again.mesh = std::make_shared<const TrunkMesh>(std::move(file.mesh));
  again.rigid = std::move(file.rigid);
  return again;
}

std::vector<Vec3d> after_steps(const Scenario& s, int steps) {
  const Trunk trunk = make_trunk(s);
  TimeGrid grid = s.time;
  grid.duration_s = steps * grid.dt_s;
  std::vector<Vec3d> position;
  const Ending ending =
      simulate(trunk.model, s.parameters, s.activation, grid,
               [&](int, double, const State<double>& state, const auto&) { position = state.position; });
  REQUIRE(ending.completed());
  return position;
}

void check_same_mesh(const TrunkMesh& a, const TrunkMesh& b) {
  CHECK(a.abdomen == b.abdomen);
  CHECK(a.lung == b.lung);
  CHECK(a.regions == b.regions);
  CHECK(a.landmarks == b.landmarks);
  CHECK(a.muscle_lines == b.muscle_lines);
  CHECK(a.fineness == b.fineness);
  REQUIRE(a.rest.size() == b.rest.size());
  double worst = 0.0;
  for (std::size_t i = 0; i < a.rest.size(); ++i)
    for (const double d :
         {a.rest[i].x() - b.rest[i].x(), a.rest[i].y() - b.rest[i].y(), a.rest[i].z() - b.rest[i].z()})
      worst = std::max(worst, std::abs(d));
  CHECK(worst <= 1.2e-16);  // one step of the last digit of the highest particles
}

std::string template_text() {
  return trunk_pml(Scenario{});
}

std::string trunk_message(const std::string& text) {
  try {
    trunk_of_pml(text, "bad.pml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// The text with the first `from`, which must be there, replaced.
std::string with(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// The text without the component of that name.
std::string without(const std::string& text, const std::string& name) {
  const auto named = text.find("name=\"" + name + "\"");
  REQUIRE(named != std::string::npos);
  const auto begin = text.rfind("<structuralComponent", named);
  const std::string close = "</structuralComponent>";
  const auto end = text.find(close, named) + close.size();
  return text.substr(0, begin) + text.substr(end);
}

std::string component_of(const std::string& text, const std::string& name) {
  const auto begin = text.rfind("<structuralComponent", text.find("name=\"" + name + "\""));
  const std::string close = "</structuralComponent>";
  return text.substr(begin, text.find(close, begin) + close.size() - begin);
}

}  // namespace

TEST_CASE("A trunk written as PML and read again is the same trunk", "[property][io]") {
  Random random(101);
  for (int i = 0; i < 8; ++i) {
    CAPTURE(i);
    Scenario s;
    s.title = "a \"trunk\" <& more>";
    s.geometry.resolution = 1 + i % 2;
    if (i > 1) s.geometry = random_geometry(random, 1 + i % 2);
    s.tissue.particle_mass = random.between(0.1, 0.3);
    s.tissue.tendon_factor = random.between(1.0, 4.0);
    const TrunkMesh mesh = mesh_of(s);
    const TrunkMesh::Given expected = healthy_tissue(mesh, s.tissue);
    const std::string text = trunk_pml(s);
    const TrunkFile file = trunk_of_pml(text, "t.pml");
    check_same_mesh(mesh, file.mesh);
    CHECK(file.mesh.given.mass == expected.mass);
    CHECK(file.mesh.given.stiffness == expected.stiffness);
    CHECK(file.mesh.given.damping == expected.damping);
    CHECK(file.mesh.given.fibre_strength == expected.fibre_strength);
    CHECK(file.rigid.empty());
    CHECK(trunk_pml(from_pml(s, text)) == text);
  }
}

TEST_CASE("A trunk from PML moves like the trunk that was written", "[property][io]") {
  Random random(102);
  for (int i = 0; i < 4; ++i) {
    CAPTURE(i);
    Scenario s = without_lung("healthy");
    s.geometry.resolution = 1 + i % 2;
    if (i > 1) s.geometry = random_geometry(random, 1 + i % 2);
    if (s.geometry.resolution == 2) s.time.dt_s = 2e-4;
    s.activation.rise_s = 0.1;
    const auto moved = after_steps(s, 200);
    CHECK(largest(difference(moved, make_trunk(s).model.rest)) > 1e-4);
    const double apart = largest(difference(after_steps(from_pml(s, trunk_pml(s)), 200), moved));
    CAPTURE(apart);
    CHECK(apart <= 1e-14);
  }
}

TEST_CASE("A trunk in PML keeps its rigid parts, except driven ones", "[unit][io]") {
  Scenario s = without_lung("healthy");
  s.rigid = {{"rib_cage_right", RigidBody::Motion::fixed, {}, "zone_of_apposition_right", {"a"}},
             {"central_tendon", RigidBody::Motion::free, {}, "", {"b"}},
             {"rib_cage_left", RigidBody::Motion::driven, {}, "zone_of_apposition_left", {"c"}}};
  s.rigid[2].imposed.angle = PiecewiseLinear({{0.0, 0.0}, {1.0, 0.01}});
  s.rigid[2].imposed.axis = {0, 1, 0};
  const TrunkFile file = trunk_of_pml(trunk_pml(s), "t.pml");
  REQUIRE(file.rigid.size() == 2);
  for (const RigidPart& part : file.rigid) {
    const RigidPart& expected = s.rigid[part.region == "rib_cage_right" ? 0 : 1];
    CHECK(part.region == expected.region);
    CHECK(part.motion == expected.motion);
    CHECK(part.surface_for == expected.surface_for);
    CHECK(part.at == Place{"t.pml"});
  }
  s.rigid.pop_back();
  const Scenario again = from_pml(s, trunk_pml(s));
  CHECK(largest(difference(after_steps(again, 200), after_steps(s, 200))) <= 1e-14);
}

TEST_CASE("The trunk of a paralysed subject is written healthy; the scenario keeps the paralysis",
          "[unit][io]") {
  const Scenario s = without_lung("hemiparalysis_right");
  Scenario healthy = s;
  healthy.tissue.paralysed = Side::none;
  const std::string text = trunk_pml(s);
  CHECK(text == trunk_pml(healthy));
  const Trunk before = make_trunk(s), again = make_trunk(from_pml(s, text));
  CHECK(again.model.shape_memory.stiffness_weight == before.model.shape_memory.stiffness_weight);
  CHECK(before.model.shape_memory.stiffness_weight !=
        make_trunk(healthy).model.shape_memory.stiffness_weight);
  for (std::size_t k = 0; k < before.model.fibres.size(); ++k)
    CHECK(again.model.fibres[k].activity == before.model.fibres[k].activity);
  CHECK(largest(difference(after_steps(from_pml(s, text), 200), after_steps(s, 200))) <= 1e-14);
}

TEST_CASE("Values of single atoms override the tissue, and missing values do not", "[unit][io]") {
  const TrunkMesh mesh = make_template_mesh({});
  Tissue tissue;
  tissue.particle_mass = 0.3;
  TrunkMesh::Given given;  // nothing at all
  const std::string silent = trunk_pml(mesh, given, {}, "silent");
  CHECK_THAT(silent, !Contains("mass=") && !Contains("nan") && !Contains("strength="));
  const TrunkMesh plain = trunk_of_pml(silent, "t.pml").mesh;
  CHECK(healthy_tissue(plain, tissue).mass == healthy_tissue(mesh, tissue).mass);
  CHECK(healthy_tissue(plain, tissue).stiffness == healthy_tissue(mesh, tissue).stiffness);

  const double nothing = std::nan("");
  given.mass.assign(113, nothing);
  given.mass[5] = 0.7;
  given.stiffness.assign(113, nothing);
  given.stiffness[50] = 3.5;
  given.damping.assign(113, nothing);
  given.damping[51] = 0.0;
  given.fibre_strength = 1.25;
  const TrunkMesh read = trunk_of_pml(trunk_pml(mesh, given, {}, "some"), "t.pml").mesh;
  const TrunkMesh::Given field = healthy_tissue(read, tissue);
  CHECK(field.mass[5] == 0.7);
  CHECK(field.mass[6] == 0.3);
  CHECK(field.stiffness[50] == 3.5);
  CHECK(field.stiffness[51] == 1.0);
  CHECK(field.damping[51] == 0.0);
  CHECK(field.damping[50] == 1.0);
  const Trunk trunk = make_trunk(read, tissue, Reaction::variational);
  CHECK(trunk.model.mass[5] == 0.7);
  CHECK(trunk.model.damping_weight[51] == 0.0);
  for (const Fibre& fibre : trunk.model.fibres) CHECK(fibre.activity == 1.25);
  tissue.paralysed = Side::both;  // goes over what is given
  tissue.paralysed_stiffness = 0.5;
  const Trunk soft = make_trunk(read, tissue, Reaction::variational);
  const auto& vertex = soft.model.shape_memory.rings.vertex;
  const auto ring = std::find(vertex.begin(), vertex.end(), 50) - vertex.begin();
  CHECK(soft.model.shape_memory.stiffness_weight[static_cast<std::size_t>(ring)] == 1.75);
}

TEST_CASE("A trunk in metres is read as one in millimetres", "[unit][io]") {
  const TrunkMesh mesh = make_template_mesh({});
  TrunkMesh thousandth = mesh;
  for (Vec3d& p : thousandth.rest) p = 1e-3 * p;
  std::string text =
      with(trunk_pml(thousandth, healthy_tissue(mesh, {}), {}, "in metres"), "unit=\"mm\"", "unit=\"m\"");
  const TrunkMesh read = trunk_of_pml(text, "t.pml").mesh;
  for (std::size_t i = 0; i < mesh.rest.size(); ++i) CHECK(norm(read.rest[i] - mesh.rest[i]) < 1e-15);
  CHECK_THROWS_WITH(trunk_of_pml(with(template_text(), "unit=\"mm\"", "unit=\"m\""), "t.pml"),
                    Contains("unit") && Contains("t.pml") && Contains("20000"));
  text = with(template_text(), " unit=\"mm\"", "");  // PML's own default
  check_same_mesh(trunk_of_pml(text, "t.pml").mesh, mesh);
}

TEST_CASE("A PML that is not a trunk gives an error with the file, what was found and what was expected",
          "[unit][io]") {
  const std::string good = template_text();
  REQUIRE(trunk_message(good) == "no error");
  const std::string triangle = "<cellProperties type=\"TRIANGLE\"";
  struct Bad {
    std::string text;
    std::vector<std::string> parts;
  };
  std::vector<Bad> cases;
  for (const char* name : {"abdomen", "lung", "muscle_lines"}) {
    cases.push_back({without(good, name), {std::string("no component '") + name + "'", "export --pml"}});
    const std::string twice = component_of(good, name);
    cases.push_back({with(good, twice, twice + twice), {std::string("'") + name + "' occurs twice"}});
  }
  for (const char* name : {"apposition_top", "apposition_middle", "dome_top_left", "dome_top_right"})
    cases.push_back({without(good, name), {name}});
  const std::string abdomen = component_of(good, "abdomen");
  for (const char* name : {"abdomen", "lung"}) {  // a hole
    const std::string closed = component_of(good, name);
    const auto begin = closed.find("<cell>"), end = closed.find("</cell>") + 7;
    cases.push_back({with(good, closed, closed.substr(0, begin) + closed.substr(end)), {name, "edge"}});
  }
  const std::string lines = component_of(good, "muscle_lines");
  const auto reference = lines.find("<atomRef"), reference_end = lines.find("/>", reference) + 2;
  cases.push_back({with(good, lines, lines.substr(0, reference) + lines.substr(reference_end)),
                   {"muscle line", "3", "4"}});
  const std::string line_as_vertices = with(lines, "POLY_LINE", "POLY_VERTEX");
  cases.push_back({with(good, lines, line_as_vertices), {"muscle_lines", "POLY_LINE"}});
  cases.push_back({with(good, abdomen, with(abdomen, "TRIANGLE", "POLY_LINE")), {"abdomen", "TRIANGLE"}});
  const std::string tendon = component_of(good, "central_tendon");
  cases.push_back({with(good, tendon, tendon + tendon), {"'central_tendon' occurs twice"}});
  cases.push_back(
      {with(good, "name=\"spine\"", "name=\"central_tendon\""), {"'central_tendon' occurs twice"}});
  cases.push_back({with(good, "name=\"spine\"", "name=\"spine\" rigid=\"driven\""),
                   {"'spine'", "\"driven\"", "fixed or free", "[[rigid]]"}});
  cases.push_back({with(good, "name=\"spine\"", "name=\"spine\" rigid=\"\""), {"'spine'", "fixed or free"}});
  for (const char* field : {"mass", "stiffness", "damping"})
    for (const char* value : {"heavy", "-1", "", "nan", "inf", "1 kg", "1e999"}) {
      const auto at = good.find(std::string(" ") + field + "=\"");
      const auto end = good.find('"', at + std::string(field).size() + 3) + 1;
      const std::string changed = good.substr(0, at) + " " + field + "=\"" + value + "\"" + good.substr(end);
      cases.push_back({changed,
                       {std::string("the ") + field + " of atom 0", std::string("'") + value + "'",
                        "number of 0 or more"}});
    }
  cases.push_back({with(good, "axes=\"RAS\"", "axes=\"LPS\""), {"bad.pml:2:", "'LPS'", "RAS"}});
  cases.push_back({with(good, "unit=\"mm\"", "unit=\"inch\""), {"bad.pml:2:", "'inch'", "mm or m"}});
  for (const char* value : {"0", "-1", "fine", "nan"})
    cases.push_back({with(good, "fineness=\"1\"", std::string("fineness=\"") + value + "\""),
                     {"fineness", value, "expected a number"}});
  cases.push_back({with(good, "strength=\"1\"", "strength=\"-1\""), {"strength of muscle_lines", "'-1'"}});
  cases.push_back({with(with(with(good, "index=\"3\" x", "index=\"_\" x"), "index=\"4\" x", "index=\"3\" x"),
                        "index=\"_\" x", "index=\"4\" x"),
                   {"atom 4 follows 3 others", "in order"}});
  for (const Bad& bad : cases) {
    const std::string message = trunk_message(bad.text);
    INFO(message);
    CHECK(message.starts_with("bad.pml"));
    for (const std::string& part : bad.parts) CHECK_THAT(message, Contains(part));
    CHECK(message.find('\n') == std::string::npos);
    CHECK(message.find("bad.pml", 3) == std::string::npos);  // once
  }
}

TEST_CASE("An error in the trunk of a scenario names both the PML file and the line of the scenario",
          "[unit][io]") {
  TemporaryFolder folder;
  folder.write("t.pml", without(template_text(), "lung"));
  const auto scenario = folder.write("s.toml", "[geometry]\n\npml = \"t.pml\"\n");
  try {
    read_scenario(scenario);
    FAIL("no error");
  } catch (const InputError& error) {
    CHECK(error.mistake().at == Place{(folder / "t.pml").string()});
    CHECK(error.mistake().named_in == Place{scenario.string(), 3});
    CHECK_THAT(error.what(), Contains("t.pml: there is no component 'lung'") && EndsWith("s.toml:3)"));
  }
}

TEST_CASE("Truncated or damaged trunks are refused when they are read or built, or they are usable",
          "[property][io]") {
  Random random(103);
  const std::string good = template_text();
  int refused = 0, built = 0;
  const auto attempt = [&](const std::string& text) {
    try {
      Scenario s = from_pml({}, text);
      const Trunk trunk = make_trunk(s);
      s.time.duration_s = 5e-3;
      simulate(trunk.model, s.parameters, s.activation, s.time,
               [](int, double, const State<double>&, const auto&) {});
      ++built;
    } catch (const InputError& error) {
      CHECK(std::string(error.what()).size() > 10);
      ++refused;
    }
  };
  for (int i = 0; i < 100; ++i) attempt(good.substr(0, random.bits() % (good.size() - 2)));
  CHECK(refused == 100);
  for (int i = 0; i < 300; ++i) {
    std::string damaged = good;
    // Any bytes; or a digit in place of a digit, which gets past the reader of XML.
    const bool digit = i % 2 == 0;
    for (std::size_t n = 1 + random.bits() % (digit ? 1 : 3); n > 0; --n) {
      std::size_t at = random.bits() % damaged.size();
      if (digit) at = std::min(damaged.find_first_of("0123456789", at), damaged.size() - 1);
      damaged[at] = static_cast<char>(digit ? '0' + random.bits() % 10 : random.bits() % 256);
    }
    attempt(damaged);
  }
  WARN("damaged trunks: " << refused << " refused, " << built << " built");
  CHECK(built > 10);
  CHECK(refused > 150);
}
