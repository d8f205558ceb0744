#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "errors/input_error.hpp"
#include "pml/read_pml.hpp"
#include "pml/write_pml.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"
#include "support/shared_data.hpp"

using namespace trunk;
using namespace trunk::pml;
using trunk::test::Random;
using trunk::test::shared_surface;

namespace {

/// The value of an attribute as the text has it, first occurrence.
std::string written_value(const std::string& text, const std::string& attribute) {
  const auto at = text.find(attribute + "=\"");
  if (at == std::string::npos) return "missing";
  const auto from = at + attribute.size() + 2;
  return text.substr(from, text.find('"', from) - from);
}

const std::string nasty[] = {"",
                             "plain",
                             "\"quoted\" & 'so'",
                             "<a href=\"x\">",
                             "]]>",
                             "&amp;&lt;&#10;",
                             " two  spaces ",
                             "line\nbreak\r\n\ttab",
                             "Zwerchfell, größer, 横隔膜, 🫁",
                             "-->",
                             "<!--",
                             "0"};

Attributes random_attributes(Random& random) {
  const std::string names[] = {"name", "mass", "viscosityW", "mode", "k-m.2", "größe"};
  Attributes attributes;
  for (const std::string& name : names)
    if (random.below(3) == 0) attributes.push_back({name, nasty[random.below(std::size(nasty))]});
  if (random.below(2) == 0) std::reverse(attributes.begin(), attributes.end());
  return attributes;
}

class RandomModel {
 public:
  explicit RandomModel(std::uint64_t seed) : random_(seed) {}

  PhysicalModel model() {
    PhysicalModel model;
    model.attributes = random_attributes(random_);
    model.atom_list_attributes = random_attributes(random_);
    model.atom_list_color = color();
    for (std::size_t i = 0, index = random_.below(5); i < 12; ++i, index += 1 + random_.below(1000)) {
      model.atoms.push_back(
          {index, {random_.finite(), random_.finite(), random_.finite()}, random_attributes(random_)});
      atoms_.push_back(index);
    }
    std::reverse(model.atoms.begin(), model.atoms.begin() + 5);
    model.exclusive = component(3);
    if (random_.below(2) == 0) {
      model.informative = component(2);
      model.informative->structures.push_back(structure());
    }
    return model;
  }

 private:
  Attributes color() {
    if (random_.below(2) == 0) return {};
    return {{"r", "0.5"}, {"g", "1"}, {"b", "0"}, {"a", "1"}};
  }

  MultiComponent component(int depth) {
    MultiComponent component{random_attributes(random_), {}, {}};
    for (std::size_t i = random_.below(3); i > 0 && depth > 0; --i)
      component.components.push_back(this->component(depth - 1));
    for (std::size_t i = random_.below(3); i > 0; --i) component.structures.push_back(structure());
    return component;
  }

  StructuralComponent structure() {
    StructuralComponent structure{random_attributes(random_), color(), {}};
    for (std::size_t i = random_.below(5); i > 0; --i) {
      const std::size_t kind = random_.below(3);
      if (kind == 0) structure.items.push_back(AtomReference{atoms_[random_.below(atoms_.size())]});
      if (kind == 1) structure.items.push_back(cell());
      if (kind == 2 && cells_ > 0) structure.items.push_back(CellReference{7 * random_.below(cells_)});
    }
    return structure;
  }

  Cell cell() {
    const std::pair<const char*, std::size_t> types[] = {
        {"LINE", 2},  {"TRIANGLE", 3},   {"QUAD", 4},      {"TETRAHEDRON", 4}, {"PYRAMID", 5},
        {"WEDGE", 6}, {"HEXAHEDRON", 8}, {"POLY_LINE", 9}, {"POLY_VERTEX", 1}};
    const auto& [type, size] = types[random_.below(std::size(types))];
    Cell cell{std::nullopt, type, random_attributes(random_), color(), {}};
    if (random_.below(2) == 0) cell.index = 7 * cells_++;
    for (std::size_t i = 0; i < size; ++i) cell.atoms.push_back(atoms_[random_.below(atoms_.size())]);
    return cell;
  }

  Random random_;
  std::vector<std::size_t> atoms_;
  std::size_t cells_ = 0;
};

/// Two atoms, one line.
PhysicalModel small_model() {
  PhysicalModel model;
  model.atoms = {{3, {0.1, -2, 1e-30}, {}}, {10, {}, {{"mass", "2"}}}};
  model.exclusive.structures = {
      {{{"name", "edge"}}, {}, {Cell{5, "LINE", {}, {}, {10, 3}}, AtomReference{3}}}};
  return model;
}

}  // namespace

TEST_CASE("The published diaphragm is read without changes", "[shared][pml]") {
  const std::string text = shared_surface("diaphragm.pml");
  const PhysicalModel model = read_pml(text, "diaphragm.pml");

  REQUIRE(find(model.attributes, "name"));
  CHECK(*find(model.attributes, "name") == "Diaphragm model");
  CHECK(find(model.attributes, "globalProperty"));
  CHECK_FALSE(find(model.attributes, "nrOfCells"));
  CHECK(model.atom_list_attributes == Attributes{{"name", "Nodes"}});
  REQUIRE(model.atoms.size() == 283);
  CHECK(model.atoms[0] == Atom{0, {-52.5, 141.491, -88}, {{"additionalProperties", "OK"}}});

  REQUIRE(model.exclusive.structures.size() == 1);
  const auto& part = model.exclusive.structures[0];
  CHECK(part.color == Attributes{{"r", "0.8"}, {"g", "0.8"}, {"b", "0.2"}, {"a", "1"}});
  CHECK(std::get<Cell>(part.items.at(0)).atoms.size() == 283);

  REQUIRE(model.informative);
  REQUIRE(model.informative->structures.size() == 2);
  CHECK(*find(model.informative->structures[0].attributes, "name") == "Node Neighborhoods");
  CHECK(std::get<Cell>(model.informative->structures[0].items.at(0)) ==
        Cell{1, "POLY_VERTEX", {}, {}, {7, 17, 18, 8}});
  CHECK(std::get<Cell>(model.informative->structures[1].items.back()) ==
        Cell{781, "TRIANGLE", {}, {}, {13, 27, 28}});
}

TEST_CASE("The published cube has nested components and free attributes", "[shared][pml]") {
  const std::string text = shared_surface("truthcube.pml");
  const PhysicalModel model = read_pml(text, "truthcube.pml");
  REQUIRE(model.exclusive.components.size() == 1);
  const auto& enclosed = model.exclusive.components[0].structures.at(0);
  REQUIRE(find(enclosed.attributes, "incompressibility"));
  CHECK(*find(enclosed.attributes, "incompressibility") == "true");
  CHECK(enclosed.items.size() == 768);
  CHECK(model.exclusive.structures.size() == 2);
  CHECK(std::get<AtomReference>(model.informative->structures.at(0).items.at(0)).index == 604);
}

TEST_CASE("Published models survive writing, with their own counts", "[shared][pml]") {
  for (const char* name : {"diaphragm.pml", "truthcube.pml"}) {
    const std::string text = shared_surface(name);
    const PhysicalModel model = read_pml(text, name);
    const std::string again = write_pml(model);
    CHECK(read_pml(again, "again") == model);
    for (const char* count :
         {"nrOfAtoms", "nrOfExclusiveComponents", "nrOfInformativeComponents", "nrOfCells"})
      CHECK(written_value(again, count) == written_value(text, count));
  }
}

TEST_CASE("A model is written as other programs expect it", "[unit][pml]") {
  CHECK(write_pml(small_model()) ==
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<physicalModel nrOfAtoms=\"2\" nrOfExclusiveComponents=\"1\" nrOfInformativeComponents=\"0\" "
        "nrOfCells=\"1\">\n"
        "<atoms>\n<structuralComponent>\n<nrOfStructures value=\"2\" />\n"
        "<atom>\n<atomProperties index=\"3\" x=\"0.1\" y=\"-2\" z=\"1e-30\" />\n</atom>\n"
        "<atom>\n<atomProperties index=\"10\" x=\"0\" y=\"0\" z=\"0\" mass=\"2\" />\n</atom>\n"
        "</structuralComponent>\n</atoms>\n"
        "<exclusiveComponents>\n<multiComponent>\n<structuralComponent name=\"edge\">\n<nrOfStructures "
        "value=\"2\" />\n"
        "<cell>\n<cellProperties index=\"5\" type=\"LINE\" />\n<nrOfStructures value=\"2\" />\n"
        "<atomRef index=\"10\" />\n<atomRef index=\"3\" />\n</cell>\n"
        "<atomRef index=\"3\" />\n"
        "</structuralComponent>\n</multiComponent>\n</exclusiveComponents>\n</physicalModel>\n");
}

TEST_CASE("An empty informative part is left out", "[unit][pml]") {
  PhysicalModel model = small_model();
  model.informative = MultiComponent{{{"name", "nothing"}}, {}, {}};
  CHECK(write_pml(model) == write_pml(small_model()));
}

TEST_CASE("A model that would not be read back equal is not written", "[unit][pml]") {
  const auto refuses = [](auto damage, const std::string& part) {
    PhysicalModel model = small_model();
    REQUIRE_NOTHROW(write_pml(model));
    damage(model);
    CHECK_THROWS_WITH(write_pml(model), Contains(part));
  };
  refuses([](auto& m) { m.atoms[0].position = {std::nan(""), 0, 0}; }, "x='nan'");
  refuses([](auto& m) { m.atoms[0].index = 10; }, "second atom of index 10");
  refuses([](auto& m) { m.atoms.pop_back(); }, "atomRef to 10");
  refuses([](auto& m) { m.atoms[1].attributes = {{"index", "4"}}; }, "'index' twice");
  refuses([](auto& m) { m.attributes = {{"nrOfCells", "4"}}; }, "'nrOfCells' twice");
  refuses([](auto& m) { m.attributes = {{"two words", "4"}}; }, "malformed");
  refuses([](auto& m) { m.attributes = {{"name", std::string("a\0b", 3)}}; }, "read back changed");
  refuses([](auto& m) { m.attributes = {{"name", "a\x01"}}; }, "control character");
  refuses([](auto& m) { m.attributes = {{"name", "\xE9t\xE9"}}; }, "UTF-8");
  refuses([](auto& m) { std::get<Cell>(m.exclusive.structures[0].items[0]).type = "TRIANGLE"; },
          "TRIANGLE of 2");
}

TEST_CASE("Any model survives writing and reading", "[property][pml]") {
  std::size_t cells = 0, informative = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const PhysicalModel model = RandomModel(seed).model();
    const std::string text = write_pml(model);
    INFO("seed " << seed << "\n" << text);
    REQUIRE(read_pml(text, "again") == model);
    cells += text.find("<cell>") != std::string::npos;
    informative += model.informative.has_value();
  }
  REQUIRE(cells > 50);
  REQUIRE(informative > 50);
}

TEST_CASE("A truncated or damaged model is read or refused with a line", "[property][pml]") {
  const std::string text = write_pml(RandomModel(1).model());
  REQUIRE(text.size() > 1000);
  std::size_t refused = 0;
  const auto survives = [&](const std::string& damaged) {
    try {
      read_pml(damaged, "damaged.pml");
    } catch (const InputError& error) {
      ++refused;
      const std::string message = error.what();
      CHECK(message.starts_with("damaged.pml:"));
      CHECK(message.find('\n') == std::string::npos);
    }
  };
  for (std::size_t length = 0; length < text.size() - 1; length += 1 + length % 7) {
    refused = 0;
    survives(text.substr(0, length));
    CHECK(refused == (length < text.rfind("</physicalModel>") + 16 ? 1 : 0));
  }
  Random random(2);
  refused = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string damaged = text;
    for (std::size_t n = 1 + random.below(3); n > 0; --n)
      damaged[random.below(damaged.size())] = static_cast<char>(random.below(256));
    survives(damaged);
  }
  CHECK(refused > 500);
}
