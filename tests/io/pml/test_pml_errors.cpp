#include "errors/input_error.hpp"
#include "pml/cell_types.hpp"
#include "pml/read_pml.hpp"
#include "support/catch.hpp"

using namespace trunk;
using namespace trunk::pml;

namespace {

/// Lines 1 to 6 of a model are its head, from line 7 on stands what is in the exclusive multiComponent.
const std::string head_lines =
    "<physicalModel>\n<atoms><structuralComponent>\n"
    "<atom><atomProperties index='1' x='1' y='2' z='3'/></atom>\n"
    "<atom><atomProperties index='5' x='1' y='2' z='3'/></atom>\n"
    "</structuralComponent></atoms>\n<exclusiveComponents><multiComponent>\n";
const std::string tail = "</multiComponent></exclusiveComponents>\n</physicalModel>\n";

std::string part(const std::string& items) {
  return head_lines + "<structuralComponent>\n" + items + "</structuralComponent>" + tail;
}
std::string atoms(const std::string& properties) {
  return "<physicalModel>\n<atoms><structuralComponent>\n<atom>\n<atomProperties " + properties +
         "/></atom></structuralComponent></atoms>\n<exclusiveComponents><multiComponent/></"
         "exclusiveComponents>\n"
         "</physicalModel>";
}
std::string cell(const std::string& properties, int references) {
  std::string text = "<cell>\n<cellProperties " + properties + "/>\n";
  for (int i = 0; i < references; ++i) text += "<atomRef index='1'/>\n";
  return text + "</cell>";
}
std::string nested(int depth) {
  std::string text = head_lines;
  for (int i = 1; i < depth; ++i) text += "<multiComponent>\n";
  for (int i = 1; i < depth; ++i) text += "</multiComponent>";
  return text + tail;
}

std::string pml_message(const std::string& text) {
  try {
    read_pml(text, "bad.pml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("Every kind of bad PML names line, what was found and what was expected", "[unit][pml]") {
  struct Bad {
    std::string text, line;
    std::vector<std::string> parts;
  };
  const Bad cases[] = {
      {"", ":1:", {"malformed XML", "PML"}},
      {"not XML", ":1:", {"malformed XML"}},
      {head_lines, ":6:", {"malformed XML"}},
      {"<physicalModel>\n<atoms>\n</physicalModel>", ":3:", {"malformed XML", "whole PML file"}},
      {"<loads/>", ":1:", {"<loads>", "<physicalModel>"}},
      {"\n<physicalModel/>\n<physicalModel/>", ":3:", {"after the end"}},
      {"<physicalModel/>", ":1:", {"without <atoms>"}},
      {"<physicalModel>\n<atoms><structuralComponent/></atoms></physicalModel>",
       ":1:",
       {"<exclusiveComponents>"}},
      {"<physicalModel>\n<atoms/></physicalModel>", ":2:", {"without <structuralComponent>"}},
      {"<physicalModel>\n<atom/>\n</physicalModel>", ":2:", {"unknown element <atom>", "atoms"}},
      {"<physicalModel>\n\nstray</physicalModel>", ":1:", {"text", "stray"}},
      {"<physicalModel a='1' b='2' a='3'/>", ":1:", {"'a' twice"}},
      {"<physicalModel a='&#1;'/>", ":1:", {"control character", "'a'"}},
      {"<physicalModel>\n\xE9</physicalModel>", ":2:", {"not UTF-8"}},
      {"<physicalModel a='\xE0\x80\xAF'/>", ":1:", {"not UTF-8"}},  // overlong
      {"<physicalModel a='\xED\xA0\x80'/>", ":1:", {"not UTF-8"}},  // half a surrogate pair
      {std::string("<physicalModel>\n\n\0</physicalModel>", 34), ":3:", {"control character"}},
      {atoms("index='0' x='0' y='0'"), ":4:", {"<atomProperties>", "'z'"}},
      {atoms("index='0' x='0' y='0' z=''"), ":4:", {"z=''", "finite number"}},
      {atoms("index='0' x='nan' y='0' z='0'"), ":4:", {"x='nan'", "finite number"}},
      {atoms("index='0' x='0' y='-inf' z='0'"), ":4:", {"y='-inf'"}},
      {atoms("index='0' x='0' y='1e999' z='0'"), ":4:", {"y='1e999'"}},
      {atoms("index='0' x='0' y='1,5' z='0'"), ":4:", {"y='1,5'"}},
      {atoms("index='0' x='0' y='0x10' z='0'"), ":4:", {"y='0x10'"}},
      {atoms("index='0' x='&#10;a' y='0' z='0'"), ":4:", {"x=' a'"}},
      {atoms("x='0' y='0' z='0'"), ":4:", {"'index'"}},
      {atoms("index='-1' x='0' y='0' z='0'"), ":4:", {"index='-1'", "0 to 2147483647"}},
      {atoms("index='99999999999999999999' x='0' y='0' z='0'"), ":4:", {"index='9999"}},
      {atoms("index='0' x='0' y='0' z='0'/></atom>\n\n<atom><atomProperties index='0' x='0' y='0' z='0'"),
       ":6:",
       {"second atom of index 0"}},
      {part("<atomRef index='1'/>\n<atomRef index='2'/>\n"), ":9:", {"atomRef to 2", "index of an atom"}},
      {part("<atomRef/>\n"), ":8:", {"<atomRef>", "'index'"}},
      {part("<atomRef index='1' x='2'/>\n"), ":8:", {"unknown attribute 'x'"}},
      {part("<cellRef index='1'/>\n"), ":8:", {"cellRef to 1", "index of a cell"}},
      {part("<bone/>\n"), ":8:", {"unknown element <bone>", "cell"}},
      {part("<nrOfStructures value='many'/>\n"), ":8:", {"value='many'"}},
      {part("<cell>\n</cell>"), ":8:", {"<cell> without <cellProperties>"}},
      {part(cell("", 3)), ":9:", {"'type'"}},
      {part(cell("type='BLOB'", 3)), ":9:", {"'BLOB'", "TRIANGLE", "POLY_VERTEX"}},
      {part(cell("type='POLY_LINE'", 0)), ":9:", {"POLY_LINE of 0", "at least 1"}},
      {part(cell("index='7' type='LINE'", 2) + "\n" + cell("index='7' type='LINE'", 2)),
       ":14:",
       {"second cell of index 7"}},
      {head_lines + "<cell/>" + tail, ":7:", {"unknown element <cell>", "structuralComponent"}},
      {head_lines + "</multiComponent>\n<multiComponent>" + tail, ":8:", {"second <multiComponent>"}},
      {head_lines + "</multiComponent></exclusiveComponents>\n<informativeComponents>\n<multiComponent/>"
                    "</informativeComponents></physicalModel>",
       ":9:",
       {"informative", "nothing in it"}},
      {nested(65), ":70:", {"depth 65", "at most 64"}},
  };
  for (const Bad& bad : cases) {
    const std::string message = pml_message(bad.text);
    INFO(bad.text << "\n" << message);
    CHECK(message.starts_with("bad.pml" + bad.line));
    for (const std::string& wanted : bad.parts) CHECK_THAT(message, Contains(wanted));
    CHECK(message.find('\n') == std::string::npos);
  }
}

TEST_CASE("Cells have the number of atoms that their type requires", "[unit][pml]") {
  const std::pair<std::string, int> types[] = {{"LINE", 2},        {"TRIANGLE", 3}, {"QUAD", 4},
                                               {"TETRAHEDRON", 4}, {"PYRAMID", 5},  {"WEDGE", 6},
                                               {"HEXAHEDRON", 8}};
  for (const auto& [type, size] : types) {
    CHECK(pml_message(part(cell("type='" + type + "'", size))) == "no error");
    for (const int wrong : {size - 1, size + 1})
      CHECK_THAT(
          pml_message(part(cell("type='" + type + "'", wrong))),
          Contains(type + " of " + std::to_string(wrong) + " atoms; expected " + std::to_string(size)));
  }
  for (const std::string type : {"POLY_LINE", "POLY_VERTEX"})
    for (const int size : {1, 2, 9})
      CHECK(pml_message(part(cell("type='" + type + "'", size))) == "no error");
}

TEST_CASE("Entities are neither expanded nor fetched", "[unit][pml]") {
  const std::string laughs =
      "<?xml version='1.0'?>\n<!DOCTYPE physicalModel [\n<!ENTITY a 'ha'>\n<!ENTITY b '&a;&a;&a;&a;'>\n]>\n";
  CHECK_THAT(pml_message(laughs + part("")), Contains("bad.pml:2: DOCTYPE") && Contains("remove it"));
  CHECK_THAT(pml_message("<!DOCTYPE a SYSTEM 'file:///etc/passwd'>\n" + part("")), Contains("DOCTYPE"));
  CHECK_THAT(pml_message("<!DOCTYPE a [<!ENTITY x SYSTEM 'file:///etc/passwd'>"), Contains("malformed"));
  CHECK_THAT(pml_message(atoms("index='&x;' x='0' y='0' z='0'")), Contains("index='&x;'"));
  CHECK(*find(read_pml("<physicalModel name='&x;'" + part("").substr(14), "").attributes, "name") == "&x;");
}

TEST_CASE("Unusual but clear texts are read", "[unit][pml]") {
  CHECK(pml_message(part("")) == "no error");
  CHECK(pml_message(nested(64)) == "no error");
  CHECK(pml_message("\xEF\xBB\xBF<?xml version='1.0' encoding='UTF-16'?>\n<!-- c -->" + part("")) ==
        "no error");
  CHECK(pml_message(head_lines + tail.substr(0, 39) + "<informativeComponents/></physicalModel>") ==
        "no error");
  SECTION("counts that disagree, as in existing files") {
    CHECK(pml_message(part("<nrOfStructures value='35'/><atomRef index='1'/>")) == "no error");
  }
  SECTION("a cell that comes after a reference to it") {
    CHECK(pml_message(part("<cellRef index='7'/>" + cell("index='7' type='LINE'", 2))) == "no error");
  }
  SECTION("numbers with a plus sign or white space") {
    const auto model = read_pml(atoms("index=' 3 ' x='+1.5' y=' 2&#10;' z='-0.0'"), "");
    CHECK(model.atoms.at(0) == Atom{3, {1.5, 2.0, 0.0}, {}});
  }
}

TEST_CASE("Texts that are too long or too deep give an error", "[unit][pml]") {
  CHECK_THAT(pml_message(std::string(100'000'001, ' ')), Contains("bad.pml: ") && Contains("at most 100 MB"));
  std::string deep;
  for (int i = 0; i < 300'000; ++i) deep += "<a>";
  CHECK_THAT(pml_message(deep), Contains("malformed"));
  for (int i = 0; i < 300'000; ++i) deep += "</a>";
  CHECK_THAT(pml_message(deep), Contains("<a> found"));
  CHECK_THAT(pml_message(nested(200'000)), Contains("depth 65"));
}
