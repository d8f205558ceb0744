#include <fstream>
#include <sstream>

#include "errors/input_error.hpp"
#include "scenarios/build_trunk.hpp"
#include "scenarios/keys.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

std::string content(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// Another value for every key, inside its limits, so that a round trip cannot pass by keeping defaults.
Scenario unusual(Random& random) {
  Scenario s;
  s.lung_acts = true;
  for (const ScenarioKey& key : scenario_keys()) {
    if (const auto* c = std::get_if<ScenarioKey::Course>(&key.kind)) {
      const double value = c->to_si * random.between(c->low, c->high);
      c->field(s) = random.unit() < 0.5 ? PiecewiseLinear({{0.0, value}}, value)
                                        : PiecewiseLinear({{0.1, value}, {0.3, 0.0}});
    }
    if (const auto* n = std::get_if<ScenarioKey::Number>(&key.kind))
      n->field(s) = n->to_si * random.between(n->low, std::min(n->high, n->low + 1000.0));
    if (const auto* i = std::get_if<ScenarioKey::Integer>(&key.kind))
      i->field(s) = i->low + 1 + static_cast<int>(random.bits() % static_cast<unsigned>(i->high - i->low));
    if (const auto* c = std::get_if<ScenarioKey::Choice>(&key.kind))
      c->set(s, static_cast<int>(c->names.size()) - 1);
    if (const auto* b = std::get_if<ScenarioKey::Switch>(&key.kind)) b->field(s) = !b->field(s);
    if (const auto* t = std::get_if<ScenarioKey::Text>(&key.kind))
      t->field(s) = R"(a "quoted" back\slash = [x] # no comment, µ)";
  }
  return s;
}

PiecewiseLinear random_course(Random& random, double size) {
  return PiecewiseLinear({{random.unit(), random.between(-size, size)},
                          {1.0 + random.unit(), random.between(-size, size)},
                          {2.0 + random.unit(), size / 3.0}});
}

/// One of each kind, by the names of their tables, as they are read: the order of kinds has no meaning.
std::vector<RegionLoad> random_loads(Random& random) {
  using enum RegionLoad::Kind;
  std::vector<RegionLoad> loads;
  for (const RegionLoad::Kind kind : {acceleration, displacement, force, pressure, pressure}) {
    RegionLoad load;
    load.kind = kind;
    load.region = random.unit() < 0.5 ? "abdominal_wall,0-3" : "*";
    load.direction = random.vector(2.0);
    if (kind == displacement) load.axes = {1, 0, random.unit() < 0.5 ? 1.0 : 0.0};
    if (kind == pressure && random.unit() < 0.5) load.direction = {};
    load.magnitude = random_course(random, 10.0);
    loads.push_back(load);
  }
  return loads;
}

/// The same course, beginning at 0, as a part that moves must.
PiecewiseLinear from_zero(const PiecewiseLinear& course) {
  auto events = course.events();
  events.front().value = 0.0;
  return PiecewiseLinear(events);
}

std::vector<RigidPart> random_parts(Random& random) {
  using enum RigidBody::Motion;
  std::vector<RigidPart> parts;
  for (const auto motion : {fixed, driven, free, driven}) {
    RigidPart part;
    part.region = "a \"part\"";
    part.motion = motion;
    if (random.unit() < 0.5) part.surface_for = "zone_of_apposition";
    const bool turns = random.unit() < 0.6;
    if (motion == driven && turns) {
      part.imposed.point = random.vector(0.5);
      const Vec3d axis = random.vector(1.0);
      part.imposed.axis = (1.0 / norm(axis)) * axis;
      part.imposed.angle = from_zero(random_course(random, 0.2));
    }
    if (motion == driven && (!turns || random.unit() < 0.5)) {
      part.imposed.direction = random.vector(1.0);
      part.imposed.shift = from_zero(random_course(random, 0.01));
    }
    parts.push_back(part);
  }
  return parts;
}

void check_equal(const PiecewiseLinear& a, const PiecewiseLinear& b) {
  REQUIRE(a.events().size() == b.events().size());
  for (std::size_t k = 0; k < a.events().size(); ++k) {
    CHECK(a.events()[k].time_s == b.events()[k].time_s);
    CHECK(a.events()[k].value == Approx(b.events()[k].value).epsilon(1e-15));
  }
}

void check_equal(const RigidPart& a, const RigidPart& b) {
  CHECK(a.region == b.region);
  CHECK(a.motion == b.motion);
  CHECK(a.surface_for == b.surface_for);
  check_equal(a.imposed.angle, b.imposed.angle);
  check_equal(a.imposed.shift, b.imposed.shift);
  CHECK(norm(a.imposed.direction - b.imposed.direction) == 0.0);
  if (a.imposed.angle.empty()) return;
  CHECK(norm(a.imposed.point - b.imposed.point) < 1e-15);
  CHECK(norm(a.imposed.axis - b.imposed.axis) < 1e-15);
}

void check_equal(const Scenario& a, const Scenario& b) {
  for (const ScenarioKey& key : scenario_keys()) {
    INFO(key.path);
    if (const auto* n = std::get_if<ScenarioKey::Number>(&key.kind)) {
      Scenario first = a, second = b;
      CHECK(n->field(first) == Approx(n->field(second)).epsilon(1e-15));
    } else {
      CHECK(toml_value(key, a) == toml_value(key, b));
    }
  }
}

}  // namespace

TEST_CASE("Every shipped scenario loads, builds and is stable", "[unit][io][long]") {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scenario_folder())) {
    if (entry.path().extension() != ".toml") continue;
    if (content(entry.path()).find("trunk.scenario/1") == std::string::npos)
      continue;  // a sweep, not a scenario
    INFO(entry.path());
    ++count;
    const ScenarioFile file = read_scenario(entry.path());
    CHECK(build_trunk(file).model.particles() == 113);
    CHECK(file.scenario.title != "trunk");
    CHECK(file.text == content(entry.path()));
    CHECK(file.inputs.front() == entry.path());
  }
  CHECK(count >= 7);
}

TEST_CASE("The scenario healthy.toml is converted to SI units", "[unit][io]") {
  const Scenario s = shipped("healthy");
  CHECK(s.geometry.half_width == Approx(0.160));
  CHECK(s.geometry.end_expiratory_volume == Approx(4718.6e-6));
  CHECK(s.parameters.elasticity == 1930.0);
  CHECK(s.time.dt_s == Approx(1e-3));
  CHECK(s.frame_every_s == Approx(0.01));
  CHECK(s.activation.fast_fall_level == 0.4);
  CHECK(s.tissue.ribs);
  CHECK(s.lung_acts);
  CHECK(s.parameters.lung_elastance == Approx(5.0 * 98.0665e3));
  CHECK(s.parameters.resistance == Approx(2.75 * 98.0665e3));
}

TEST_CASE("A scenario that extends another one inherits all values that it does not set", "[unit][io]") {
  const ScenarioFile file = read_scenario(scenario_folder() / "exercise_hemiparalysis_right.toml");
  CHECK(file.inputs.size() == 3);
  CHECK(file.scenario.tissue.paralysed == Side::right);              // its own
  CHECK(file.scenario.activation.rise_s == 1.1);                     // its parent's
  CHECK(file.scenario.geometry.apposition_length == Approx(0.149));  // its grandparent's
  CHECK_THAT(file.where("paralysis.side").text(), Contains("exercise_hemiparalysis_right.toml:7"));
  CHECK_THAT(file.where("geometry.half_width_mm").text(), Contains("healthy.toml:10"));
  CHECK(file.where("activation.onset_s") == Place{file.path});  // nobody set it
}

TEST_CASE("A scenario written and read again is the same", "[property][io]") {
  Random random(71);
  TemporaryFolder folder;
  for (int i = 0; i < 20; ++i) {
    Scenario s = i == 0 ? Scenario{} : unusual(random);
    if (i > 1) s.gravity = {0.0, random.between(-1, 1), -9.81};
    if (i > 2) s.abdominal_volume = PiecewiseLinear({{0.0, 1.0}, {random.between(0.1, 2), 1.1}}, 1.0);
    if (i > 3) s.loads = random_loads(random);
    if (i > 4) s.rigid = random_parts(random);
    const std::string text = to_toml(s);
    INFO(text);
    const ScenarioFile file = read_scenario(folder.write("again.toml", text));
    const Scenario& again = file.scenario;
    check_equal(s, again);
    for (const ScenarioKey& key : scenario_keys())
      CHECK((file.origin.contains(std::string(key.path)) || (key.left_out && key.left_out(s))));
    CHECK(norm(again.gravity - s.gravity) == 0.0);
    CHECK(again.abdominal_volume(0.05) == s.abdominal_volume(0.05));
    REQUIRE(again.loads.size() == s.loads.size());
    for (std::size_t k = 0; k < s.loads.size(); ++k) {
      CHECK(again.loads[k].kind == s.loads[k].kind);
      CHECK(again.loads[k].region == s.loads[k].region);
      CHECK(norm(again.loads[k].direction - s.loads[k].direction) == 0.0);
      if (s.loads[k].kind == RegionLoad::Kind::displacement)
        CHECK(norm(again.loads[k].axes - s.loads[k].axes) == 0.0);
      check_equal(again.loads[k].magnitude, s.loads[k].magnitude);
    }
    REQUIRE(again.rigid.size() == s.rigid.size());
    for (std::size_t k = 0; k < s.rigid.size(); ++k) check_equal(again.rigid[k], s.rigid[k]);
    CHECK(to_toml(again) == text);
  }
}

TEST_CASE("A title may hold any character and comes back", "[property][io]") {
  TemporaryFolder folder;
  for (const std::string title : {"two\nlines", "a\ttab", "bell \x07", "\"", "\\", "", "\\u0041"}) {
    Scenario s;
    s.title = title;
    INFO(to_toml(s));
    CHECK(read_scenario(folder.write("title.toml", to_toml(s))).scenario.title == title);
  }
}

TEST_CASE("Settings override the file and become the origin of the value", "[unit][io]") {
  const auto path = scenario_folder() / "healthy.toml";
  const ScenarioFile file =
      read_scenario(path, {"parameters.k_muscle_N_per_m=42.5", "tissue.ribs=false", "paralysis.side=left",
                           "title=a = b", "parameters.k_muscle_N_per_m=43"});
  CHECK(file.scenario.parameters.muscle == 43.0);  // the last one counts
  CHECK_FALSE(file.scenario.tissue.ribs);
  CHECK(file.scenario.tissue.paralysed == Side::left);
  CHECK(file.scenario.title == "a = b");
  CHECK(file.where("tissue.ribs") == Place{"--set tissue.ribs=false"});
}

TEST_CASE("A lung acts once a scenario or a setting names it or the airway", "[unit][io]") {
  TemporaryFolder folder;
  const auto of = [&](const std::string& tables, const std::vector<std::string>& settings = {}) {
    return read_scenario(folder.write("lung.toml", "schema = \"trunk.scenario/1\"\n" + tables), settings)
        .scenario;
  };
  CHECK_FALSE(of("").lung_acts);
  CHECK_FALSE(make_trunk(of("")).model.pleura);
  const Scenario lung = of("[lung]\nelastance_cmH2O_per_L = 5\nresistance_cmH2O_s_per_L = 2\n");
  CHECK(lung.lung_acts);
  CHECK(lung.parameters.lung_elastance == Approx(5 * 98.0665 / 1e-3));
  CHECK(lung.parameters.resistance == Approx(2 * 98.0665 / 1e-3));
  const Scenario airway = of("[airway]\npressure_cmH2O = 8\ntube_resistance_cmH2O_s_per_L = 3\n");
  CHECK(airway.lung_acts);
  for (const double time_s : {-1.0, 0.0, 9.0})
    CHECK(airway.pleura.airway_pressure(time_s) == Approx(8 * 98.0665));
  CHECK(make_trunk(airway).model.pleura->tube_resistance == Approx(3 * 98.0665 / 1e-3));
  const Scenario course = of("[airway]\npressure_cmH2O = [[1.0, 0.0], [2.0, 10.0]]\n");
  CHECK(course.pleura.airway_pressure(0.5) == 0.0);
  CHECK(course.pleura.airway_pressure(1.5) == Approx(5 * 98.0665));
  CHECK(of("", {"airway.pressure_cmH2O=-4"}).pleura.airway_pressure(0.0) == Approx(-4 * 98.0665));
  CHECK(of("", {"lung.elastance_cmH2O_per_L=0"}).lung_acts);
}

TEST_CASE("Keys of the lung and the airway are checked", "[unit][io]") {
  TemporaryFolder folder;
  const auto message = [&](const std::string& tables) -> std::string {
    try {
      make_trunk(
          read_scenario(folder.write("lung.toml", "schema = \"trunk.scenario/1\"\n" + tables)).scenario);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  };
  CHECK_THAT(message("[airway]\npressure_mbar = 5\n"), Contains("airway.pressure_cmH2O"));
  CHECK_THAT(message("[lung]\ncompliance = 5\n"), Contains("unknown key 'lung.compliance'"));
  CHECK_THAT(message("[airway]\npressure_cmH2O = \"high\"\n"), Contains("pairs"));
  CHECK_THAT(message("[airway]\npressure_cmH2O = [[0.0, 0.0], [1.0, 300.0]]\n"), Contains("-200 to 200"));
  CHECK_THAT(message("[airway]\npressure_cmH2O = [[1.0, 0.0], [0.0, 3.0]]\n"), Contains("increas"));
  CHECK_THAT(message("[lung]\nelastance_cmH2O_per_L = -1\n"), Contains("0 to 1000"));
  const std::string rises = "[airway]\npressure_cmH2O = [[0.0, 0.0], [1.0, 5.0]]\n";
  CHECK(message(rises) == "");
  CHECK_THAT(message(rises + "[time]\nstart = \"periodic\"\n"),
             Contains("airway.pressure_cmH2O") && Contains("cannot repeat"));
}
