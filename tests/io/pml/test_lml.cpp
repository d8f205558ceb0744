#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>

#include "errors/input_error.hpp"
#include "pml/load_vocabulary.hpp"
#include "pml/read_lml.hpp"
#include "pml/write_lml.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/shared_data.hpp"

using namespace trunk;
using namespace trunk::pml;
using trunk::test::Random;
using trunk::test::shared_surface;

namespace {

constexpr Axis fixed{Axis::Kind::fixed, 0.0};
constexpr Axis along(double factor) {
  return {Axis::Kind::along, factor};
}

/// What a load needs; `line` is line 2, what is in it line 3.
const std::string open_loads =
    "<loads xmlns='http://www-timc.imag.fr/load' xmlns:xsi='http://www.w3.org/2001/XMLSchema-instance'>\n";
const std::string applied = "<appliedTo>0-3</appliedTo>";
const std::string event = "<valueEvent date='0' value='1'/>";
const std::string direction = "<direction x='1'/>";

std::string loads(const std::string& inside, const std::string& type = "xsi:type='Force'") {
  return open_loads + "<load " + type + ">\n" + inside + "</load>\n</loads>";
}

std::string lml_message(const std::string& text) {
  try {
    read_lml(text, "bad.lml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::vector<LoadTarget> targets_of(const std::string& text) {
  return read_lml(loads("<appliedTo>" + text + "</appliedTo>" + event + direction), "").loads.at(0).targets;
}

LoadTarget random_target(Random& random) {
  const std::string names[] = {"Lung", "left-lung", "3rd rib", "Zwerchfell, rechts"};
  const std::size_t first = random.below(1000);
  switch (random.below(4)) {
    case 0:
      return AllAtoms{};
    case 1:
      return ComponentName{names[random.below(3)]};
    case 2:
      return pml::AtomRange{first, first};
    default:
      return pml::AtomRange{first, first + random.below(100)};
  }
}

Axis random_axis(Random& random) {
  const Axis axes[] = {{}, fixed, along(random.finite())};
  return axes[random.below(3)];
}

Load random_load(Random& random) {
  const std::pair<Load::Type, const char*> units[] = {
      {Load::Type::translation, ""},   {Load::Type::translation, "mm"}, {Load::Type::force, "kN"},
      {Load::Type::pressure, "cmH2O"}, {Load::Type::rotation, "°"},     {Load::Type::acceleration, "m/s2"}};
  Load load;
  std::tie(load.type, load.unit) = units[random.below(std::size(units))];
  for (std::size_t i = 1 + random.below(4); i > 0; --i) load.targets.push_back(random_target(random));
  double date = -5.0;
  for (std::size_t i = 1 + random.below(4); i > 0; --i)
    load.events.push_back({date += 0.1 + random.unit(), random.finite()});
  if (random.below(4) == 0) {
    load.direction = Toward{random.below(100)};
  } else {
    load.direction = Axes{random_axis(random), random_axis(random), along(random.finite())};
  }
  if (random.below(2) == 0) load.attributes = {{"name", "\"<&>'\n\t größer"}, {"note", ""}};
  return load;
}

}  // namespace

TEST_CASE("The published compressions are read, but not loads in comments", "[shared][lml]") {
  const std::string text = shared_surface("compression-12.lml");
  const Loads read = read_lml(text, "compression-12.lml");
  REQUIRE(read.loads.size() == 2);
  const Load held{
      Load::Type::translation, {pml::AtomRange{648, 728}}, {{0, 1}}, Axes{fixed, fixed, fixed}, "mm", {}, 0};
  const Load pushed{Load::Type::translation,
                    {pml::AtomRange{0, 80}},
                    {{0, 0}, {10, 10}},
                    Axes{along(0), along(0), along(1)},
                    "mm",
                    {},
                    0};
  CHECK(read.loads[0] == held);
  CHECK(read.loads[1] == pushed);
  CHECK(read.loads[0].line == 8);
  CHECK(read.loads[1].line == 17);

  const PiecewiseLinear over_time = course(read.loads[1], to_si(read.loads[1]));
  CHECK(over_time(-1.0) == 0.0);
  CHECK(over_time(5.0) == Approx(5e-3));
  CHECK(over_time(11.0) == Approx(10e-3));
}

TEST_CASE("Published loads survive writing", "[shared][lml]") {
  for (const char* name : {"compression-12.lml", "compression-18.lml"}) {
    const std::string text = shared_surface(name);
    const Loads read = read_lml(text, name);
    REQUIRE(read.loads.size() == 2);
    CHECK(read_lml(write_lml(read), "again") == read);
  }
}

TEST_CASE("Loads are written as other programs expect them", "[unit][lml]") {
  Load load;
  load.targets = {pml::AtomRange{0, 3}, pml::AtomRange{7, 7}, ComponentName{"left lung"}};
  load.events = {{0, 0}, {0.5, 1e-3}};
  load.direction = Axes{fixed, Axis{}, along(-1)};
  load.unit = "mm";
  CHECK(write_lml({{}, {load}}) ==
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<loads xmlns=\"http://www-timc.imag.fr/load\" "
        "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\">\n"
        "<load xsi:type=\"Translation\">\n<appliedTo>0-3,7,left lung</appliedTo>\n"
        "<valueEvent date=\"0\" value=\"0\" />\n<valueEvent date=\"0.5\" value=\"0.001\" />\n"
        "<direction x=\"NULL\" z=\"-1\" />\n<unit>mm</unit>\n</load>\n</loads>\n");
}

TEST_CASE("Load targets are indexes, ranges, names and all atoms", "[unit][lml]") {
  using Targets = std::vector<LoadTarget>;
  CHECK(targets_of("0-3,7,9-11") ==
        Targets{pml::AtomRange{0, 3}, pml::AtomRange{7, 7}, pml::AtomRange{9, 11}});
  CHECK(targets_of(" \n 0-3 ,\t7 \n") == Targets{pml::AtomRange{0, 3}, pml::AtomRange{7, 7}});
  CHECK(targets_of("*") == Targets{AllAtoms{}});
  CHECK(targets_of("Lung 2, left-lung,5-5") ==
        Targets{ComponentName{"Lung 2"}, ComponentName{"left-lung"}, pml::AtomRange{5, 5}});
  CHECK(targets_of("0-<!-- not 9 -->4,&#53;") == Targets{pml::AtomRange{0, 4}, pml::AtomRange{5, 5}});
  for (const std::string bad :
       {"", " ", "1,,2", "1,", "-3", "3-", "1-2-3", "1.5", "+", "99999999999", "0-1000000000"})
    CHECK_THAT(lml_message(loads("<appliedTo>" + bad + "</appliedTo>" + event + direction)),
               Contains("bad.lml:3: ") && Contains("appliedTo"));
  CHECK_THAT(lml_message(loads("<appliedTo>7-3</appliedTo>" + event + direction)),
             Contains("'7-3'") && Contains("smaller index first"));
}

TEST_CASE("Ranges are expanded up to a bound", "[unit][lml]") {
  Load load;
  load.targets = {pml::AtomRange{4, 6}, ComponentName{"Lung"}, pml::AtomRange{5, 7}, pml::AtomRange{0, 0}};
  CHECK(listed_indices(load, 8) == std::vector<std::size_t>{4, 5, 6, 7, 0});
  CHECK_THROWS_WITH(listed_indices(load, 7), Contains("5-7") && Contains("below 7"));
  load.targets = {pml::AtomRange{0, 1'000'000'000'000}};
  CHECK_THROWS_AS(listed_indices(load, 8), InputError);
  load.targets = {pml::AtomRange{3, 2}};
  CHECK_THROWS_AS(listed_indices(load, 8), InputError);
}

TEST_CASE("Names are compared by namespace and not by prefix", "[unit][lml]") {
  const std::string text =
      "<l:loads xmlns:l='http://www-timc.imag.fr/load'>\n"
      "<l:load xmlns:i='http://www.w3.org/2001/XMLSchema-instance' i:type='l:Force' name='a'>"
      "<l:appliedTo>*</l:appliedTo><l:valueEvent date='0' value='1'/><l:direction "
      "toward='3'/></l:load></l:loads>";
  const Loads read = read_lml(text, "");
  REQUIRE(read.loads.size() == 1);
  CHECK(read.loads[0].type == Load::Type::force);
  CHECK(read.loads[0].direction == std::variant<Axes, Toward>(Toward{3}));
  CHECK(read.loads[0].attributes == Attributes{{"name", "a"}});
  CHECK(read_lml(write_lml(read), "") == read);
}

TEST_CASE("Every unit has its factor, for its own type of load", "[unit][lml]") {
  using enum Load::Type;
  CHECK(si_factor(translation, "mm") == 1e-3);
  CHECK(si_factor(translation, "") == 1e-3);
  CHECK(si_factor(force, "kN") == 1e3);
  CHECK(si_factor(pressure, "cmH2O") == 98.0665);
  CHECK(*si_factor(pressure, "mmHg") * 760 == Approx(101325).epsilon(1e-6));
  CHECK(*si_factor(rotation, "°") * 180 == Approx(std::numbers::pi));
  CHECK(si_factor(rotation, "rad") == 1.0);
  CHECK(si_factor(acceleration, "mm/s2") == 1e-3);
  CHECK_FALSE(si_factor(pressure, ""));
  CHECK_FALSE(si_factor(force, "mm"));
  Load load;
  load.unit = "furlong";
  CHECK_THROWS_WITH(to_si(load), Contains("'furlong'") && Contains("mm, m,"));
}

TEST_CASE("Every kind of bad LML names line, what was found and what was expected", "[unit][lml]") {
  struct Bad {
    std::string text, line;
    std::vector<std::string> parts;
  };
  const std::string good = applied + event + direction;
  REQUIRE(lml_message(loads(good)) == "no error");
  REQUIRE(lml_message(loads("<unit>N</unit>" + good)) == "no error");
  const Bad cases[] = {
      {"", ":1:", {"malformed XML", "LML"}},
      {"<loads/>", ":1:", {"namespace ''", "www-timc.imag.fr/load"}},
      {"<loads xmlns='http://example.org'/>", ":1:", {"'http://example.org'"}},
      {"<x:loads/>", ":1:", {"prefix in 'x:loads'", "xmlns:x"}},
      {"<physicalModel xmlns='http://www-timc.imag.fr/load'/>", ":1:", {"<physicalModel>", "<loads>"}},
      {open_loads + "<force/></loads>", ":2:", {"<force>", "<load>"}},
      {loads(good, ""), ":2:", {"without xsi:type", "Translation, Force"}},
      {loads(good, "type='Force'"), ":2:", {"without xsi:type"}},
      {loads(good, "xsi:type='Push'"), ":2:", {"'Push'", "Translation, Force"}},
      {loads(good, "xs:type='Force'"), ":2:", {"prefix in 'xs:type'"}},
      {loads(good, "xsi:type='Force' xmlns:a='b' a:b='1'"), ":2:", {"'a:b'", "another namespace"}},
      {loads(event + direction), ":2:", {"without <appliedTo>"}},
      {loads(applied + direction), ":2:", {"without <valueEvent>"}},
      {loads(applied + event), ":2:", {"without <direction>"}},
      {loads(good + "\n" + applied), ":4:", {"second <appliedTo>"}},
      {loads(good + "\n" + direction), ":4:", {"second <direction>"}},
      {loads(good + "\n<colour/>"), ":4:", {"unknown element <colour>", "valueEvent"}},
      {loads(good + "\n<appliedTo xmlns=''>1</appliedTo>"), ":4:", {"namespace ''"}},
      {loads(good + "text"), ":3:", {"text 'text'"}},
      {loads("<appliedTo><b/></appliedTo>" + event + direction), ":3:", {"element <b>"}},
      {loads(applied + "\n<valueEvent date='nan' value='1'/>" + direction), ":4:", {"date='nan'"}},
      {loads(applied + "\n<valueEvent date='0' value='inf'/>" + direction), ":4:", {"value='inf'"}},
      {loads(applied + "\n<valueEvent date='0'/>" + direction), ":4:", {"'value'"}},
      {loads(applied + event + "\n" + event + direction), ":4:", {"date 0 after date 0", "increasing"}},
      {loads(applied + event + "\n<valueEvent date='-1' value='1'/>" + direction), ":4:", {"date -1 after"}},
      {loads(applied + event + "<direction/>"), ":3:", {"neither axes nor toward"}},
      {loads(applied + event + "<direction x='1' toward='3'/>"), ":3:", {"both axes and toward"}},
      {loads(applied + event + "<direction x='null'/>"), ":3:", {"x='null'", "NULL"}},
      {loads(applied + event + "<direction y='1e999'/>"), ":3:", {"y='1e999'"}},
      {loads(applied + event + "<direction toward='head'/>"), ":3:", {"toward='head'"}},
      {loads(applied + event + "<direction w='1'/>"), ":3:", {"'w'"}},
      {loads(good + "\n<unit>mm</unit>"), ":4:", {"Force in unit 'mm'", "N, kN"}},
      {loads(good, "xsi:type='Pressure'"), ":2:", {"Pressure in unit ''", "Pa, hPa, kPa"}},
  };
  for (const Bad& bad : cases) {
    const std::string message = lml_message(bad.text);
    INFO(bad.text << "\n" << message);
    CHECK(message.starts_with("bad.lml" + bad.line));
    for (const std::string& part : bad.parts) CHECK_THAT(message, Contains(part));
  }
}

TEST_CASE("Loads that would not be read back equal are not written", "[unit][lml]") {
  Load load;
  load.targets = {AllAtoms{}};
  load.events = {{0, 1}};
  load.direction = Toward{1};
  REQUIRE_NOTHROW(write_lml({{}, {load}}));
  const auto refuses = [&](auto damage, const std::string& part) {
    Load damaged = load;
    damage(damaged);
    CHECK_THROWS_WITH(write_lml({{}, {damaged}}), Contains(part));
  };
  refuses([](Load& l) { l.targets = {ComponentName{"left, right"}}; }, "read back changed");
  refuses([](Load& l) { l.targets = {ComponentName{"12"}}; }, "read back changed");
  refuses([](Load& l) { l.targets.clear(); }, "appliedTo is empty");
  refuses([](Load& l) { l.events = {{1, 1}, {0, 1}}; }, "increasing dates");
  refuses([](Load& l) { l.events = {{0, std::nan("")}}; }, "finite");
  refuses([](Load& l) { l.unit = "Pa"; }, "'Pa'");
  refuses([](Load& l) { l.direction = Axes{}; }, "neither");
  refuses([](Load& l) { l.attributes = {{"xsi:type", "Force"}}; }, "twice");
}

TEST_CASE("Any loads survive writing and reading", "[property][lml]") {
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    Loads loads;
    for (std::size_t n = random.below(4); n > 0; --n) loads.loads.push_back(random_load(random));
    if (random.below(2) == 0) loads.attributes = {{"comment", "a \"b\" & <c>"}};
    REQUIRE(read_lml(write_lml(loads), "again") == loads);
  }
}

TEST_CASE("Truncated or damaged loads are read or refused with a line", "[property][lml]") {
  Random random(4);
  Loads some;
  for (int i = 0; i < 5; ++i) some.loads.push_back(random_load(random));
  const std::string text = write_lml(some);
  REQUIRE(text.size() > 1000);
  for (std::size_t length = 0; length < text.size() - 2; ++length)
    CHECK_THAT(lml_message(text.substr(0, length)), Contains("bad.lml:"));
  std::size_t refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string damaged = text;
    for (std::size_t n = 1 + random.below(3); n > 0; --n)
      damaged[random.below(damaged.size())] = static_cast<char>(random.below(256));
    refused += lml_message(damaged) != "no error";
  }
  CHECK(refused > 1000);
}
