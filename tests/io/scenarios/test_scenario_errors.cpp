#include <limits>

#include "errors/input_error.hpp"
#include "scenarios/read_scenario.hpp"
#include "support/catch.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"
#include "support/trunks.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("Every kind of bad scenario names file, line, what was found and what was expected", "[unit][io]") {
  struct Bad {
    std::string text, line;
    std::vector<std::string> parts;
  };
  const Bad cases[] = {
      {"[geometry\nhalf_width_mm = 160\n", ":1", {"TOML"}},
      {"\n\ntitle = \"open\n", ":3", {"TOML"}},
      {"[geometry]\nhalf_width_cm = 16\n", ":2", {"half_width_cm", "half_width_mm", "50 to 400"}},
      {"[geometry]\nhalf_width_mm = 0.160\n", ":2", {"half_width_mm", "0.16", "mm", "50 to 400"}},
      {"[geometry]\nend_expiratory_volume_l = 4.76\n", ":2", {"end_expiratory_volume_ml"}},
      {"[time]\ndt_s = 0.001\n", ":2", {"dt_s", "time.dt_ms"}},
      {"[geometry]\n\nwidth = 160\n", ":3", {"unknown key", "geometry.width", "--keys"}},
      {"[muscles]\nk = 1\n", ":1", {"unknown key", "muscles"}},
      {"geometry = 3\n", ":1", {"geometry"}},
      {"[parameters]\nk_elasticity_N_per_m = -4000\n", ":2", {"-4000", "k_elasticity_N_per_m"}},
      {"[parameters]\nk_muscle_N_per_m = -1\n", ":2", {"-1", "0 to"}},
      {"[parameters]\nk_elasticity_N_per_m = nan\n", ":2", {"not finite"}},
      {"[parameters]\nk_elasticity_N_per_m = inf\n", ":2", {"not finite"}},
      {"[parameters]\nk_elasticity_N_per_m = \"4000\"\n", ":2", {"4000", "a number"}},
      {"[parameters]\nk_elasticity_N_per_m = true\n", ":2", {"true", "a number"}},
      {"[parameters]\nk_elasticity_N_per_m = [1, 2]\n", ":2", {"a number"}},
      {"[parameters]\nk_elasticity_N_per_m = 2026-01-01\n", ":2", {"a number"}},
      {"[tissue]\nparticle_mass_kg = -0.2\n", ":2", {"-0.2", "particle_mass_kg"}},
      {"[tissue]\nparticle_mass_kg = 0\n", ":2", {"particle_mass_kg"}},
      {"[tissue]\nreaction = \"newton\"\n", ":2", {"newton", "variational", "published"}},
      {"[tissue]\nribs = 1\n", ":2", {"true or false"}},
      {"[paralysis]\nside = \"Right\"\n", ":2", {"Right", "\"right\""}},
      {"title = 3\n", ":1", {"title", "text"}},
      {"schema = \"trunk.scenario/2\"\n", ":1", {"trunk.scenario/2", "trunk.scenario/1"}},
      {"gravity_m_s2 = [0, 0]\n", ":1", {"three numbers"}},
      {"gravity_m_s2 = 9.81\n", ":1", {"9.81", "three numbers"}},
      {"abdominal_volume_fraction = [[0, 1], [1, 50]]\n", ":1", {"50", "0.1 to 10"}},
      {"abdominal_volume_fraction = [[0, 1], [1]]\n", ":1", {"pairs"}},
      {"abdominal_volume_fraction = []\n", ":1", {"pairs"}},
      {"\n[[force]]\nregion = \"pelvis\"\ndirection = [0, 0, 1]\nevents_N = [[1, 0], [0.5, 2]]\n",
       ":5",
       {"increase", "0.5", "events_N"}},
      {"\n[[force]]\nregion = \"liver\"\ndirection = [0, 0, 1]\nevents_N = [[0, 1]]\n",
       ":2",
       {"'liver'", "abdominal_wall", "zone_of_apposition"}},
      {"[[force]]\nregion = \"pelvis\"\ndirection = [0, 0, 0]\nevents_N = [[0, 1]]\n", ":3", {"zero"}},
      {"[[force]]\nregion = \"pelvis\"\nevents_N = [[0, 1]]\n", ":1", {"incomplete", "direction"}},
      {"[[force]]\nregion = \"pelvis\"\nevents_mm = [[0, 1]]\n", ":3", {"events_mm", "events_N"}},
      {"[[displacement]]\nregion = 7\n", ":2", {"region"}},
      {"[force]\nregion = \"pelvis\"\n", ":1", {"[[force]]"}},
      {"extends = 5\n", ":1", {"extends"}},
      {"title = \"a\"\ntitle = \"b\"\n", ":2", {"TOML"}},
      {"[geometry]\nend_expiratory_volume_ml = 300\n", "", {"300 ml", "expected"}},
  };
  for (const Bad& bad : cases) {
    const std::string message = message_about(bad.text);
    INFO(bad.text << "--> " << message);
    CHECK_THAT(message, Contains("bad.toml" + bad.line));
    for (const std::string& part : bad.parts) CHECK_THAT(message, Contains(part));
    CHECK(occurrences(message, "bad.toml") == 1);  // the place is said once
    CHECK(occurrences(message, "\n") == 0);        // one line
  }
}

TEST_CASE("A file that cannot be read is named", "[unit][io]") {
  TemporaryFolder folder;
  CHECK_THAT(message_of(folder / "missing.toml"), Contains("missing.toml") && Contains("no such file"));
  std::filesystem::create_directory(folder / "sub");
  CHECK_THAT(message_of(folder / "sub"), Contains("sub") && Contains("directory"));
  CHECK_THAT(message_of(folder.write("binary.toml", std::string("\x00\x01\x02\xff", 4))),
             Contains("binary.toml:1"));
}

TEST_CASE("A missing parent is reported at the line that extends it", "[unit][io]") {
  TemporaryFolder folder;
  const std::string message = message_of(folder.write("child.toml", "\nextends = \"nobody.toml\"\n"));
  CHECK_THAT(message, Contains("nobody.toml"));
  CHECK_THAT(message, Contains("child.toml:2"));
}

TEST_CASE("A scenario that extends itself, directly or through others, is refused", "[unit][io]") {
  TemporaryFolder folder;
  CHECK_THAT(message_of(folder.write("self.toml", "extends = \"self.toml\"\n")),
             Contains("self.toml:1") && Contains("extends"));
  folder.write("a.toml", "extends = \"b.toml\"\n");
  folder.write("b.toml", "title = \"b\"\nextends = \"a.toml\"\n");
  CHECK_THAT(message_of(folder / "a.toml"), Contains("extends") && Contains("itself"));
}

TEST_CASE("An error in the parent names the parent's line", "[unit][io]") {
  TemporaryFolder folder;
  folder.write("parent.toml", "[time]\ndt_ms = 1\nduration_s = -3\n");
  const std::string message = message_of(folder.write("child.toml", "extends = \"parent.toml\"\n"));
  CHECK_THAT(message, Contains("parent.toml:3") && Contains("-3"));
}

TEST_CASE("A time step above the stability bound names the line that sets it", "[unit][io]") {
  const std::string message =
      message_about("[parameters]\nk_elasticity_N_per_m = 4000\n[time]\ndt_ms = 50\n");
  CHECK_THAT(message, Contains("bad.toml:4") && Contains("50 ms") && Contains("less than"));

  TemporaryFolder folder;
  folder.write("parent.toml", "[time]\ndt_ms = 5\n");
  // The child's stiffness makes the parent's step too long: the step is what to lower.
  const auto child =
      folder.write("child.toml", "extends = \"parent.toml\"\n[parameters]\nk_elasticity_N_per_m = 400000\n");
  CHECK_THAT(message_of(child), Contains("parent.toml:2"));
  CHECK_THAT(message_of(folder / "parent.toml", {"time.dt_ms=500"}), Contains("--set") && Contains("500"));
}

TEST_CASE("Bad settings are refused like bad files", "[unit][io]") {
  const auto path = scenario_folder() / "healthy.toml";
  for (const auto& [setting, part] : std::vector<std::pair<std::string, std::string>>{
           {"parameters.k_muscle_N_per_m", "key=value"},
           {"parameters.k_muscle=30", "k_muscle_N_per_m"},
           {"parameters.k_muscle_N_per_m=", "a number"},
           {"parameters.k_muscle_N_per_m=thirty", "a number"},
           {"parameters.k_muscle_N_per_m=nan", "finite"},
           {"parameters.k_muscle_N_per_m=-3", "-3"},
           {"parameters.k_muscle_N_per_m=3\ntitle=4", "a number"},
           {"paralysis.side=up", "right"},
           {"tissue.ribs=maybe", "true or false"},
           {"extends=other.toml", "extends"},
           {"=", "unknown key"},
           {"", "key=value"}}) {
    const std::string message = message_of(path, {setting});
    INFO(setting << " --> " << message);
    CHECK_THAT(message, Contains("--set") && Contains(part));
  }
}

TEST_CASE("No text makes the reader crash or hang", "[property][io]") {
  // Pieces of good and bad files in random order: an InputError or a scenario, nothing else.
  const std::vector<std::string> pieces{"[geometry]\n",
                                        "half_width_mm = ",
                                        "160\n",
                                        "-1e400\n",
                                        "\"",
                                        "[[force]]\n",
                                        "= 3\n",
                                        "\xff\xfe",
                                        "[",
                                        "]\n",
                                        "{ }",
                                        "title = ",
                                        "'''",
                                        "extends = \".\"\n",
                                        "\r\n",
                                        "#",
                                        "9999999999999999999\n"};
  Random random(72);
  TemporaryFolder folder;
  for (int i = 0; i < 300; ++i) {
    std::string text;
    for (int k = 0; k < 8; ++k) text += pieces[random.bits() % pieces.size()];
    CAPTURE(text);
    try {
      read_scenario(folder.write("noise.toml", text));
    } catch (const InputError& error) {
      CHECK_THAT(error.what(), Contains(folder.write("noise.toml", "").parent_path().string()));
    }
  }
}

TEST_CASE("All mistakes of a scenario and its settings are found in one reading, by line", "[unit][io]") {
  const TemporaryFolder folder;
  folder.write("base.toml", "[time]\nduration_s = -1\n[tissue]\nribs = 3\n");
  const auto path = folder.write("bad.toml",
                                 "extends = \"base.toml\"\n[time]\ndt_ms = true\n[paralysis]\nside = \"up\"\n"
                                 "[geometry]\nwidth = 3\n[[force]]\nregion = 7\ndirection = [0, 0]\n");
  std::vector<std::string> texts;
  try {
    read_scenario(path, {"time.dt_ms=x", "nothing", "time.frame_every_ms=5"});
  } catch (const InputErrors& errors) {
    for (const Mistake& mistake : errors.mistakes()) texts.push_back(text_of(mistake));
    CHECK_THAT(errors.what(), Contains("base.toml:2: ") && Contains("(and 8 more: `trunk check` lists all)"));
    CHECK(std::string(errors.what()).find('\n') == std::string::npos);
  }
  const std::string expected[] = {"base.toml:2: time.duration_s",
                                  "base.toml:4: tissue.ribs",
                                  "bad.toml:3: time.dt_ms is true",
                                  "bad.toml:5: paralysis.side",
                                  "bad.toml:7: unknown key 'geometry.width'",
                                  "bad.toml:9: unknown or wrong key 'region'",
                                  "bad.toml:10: force.direction",
                                  "--set nothing: no '=' found; expected key=value",
                                  "--set time.dt_ms=x: "};
  REQUIRE(texts.size() == std::size(expected));
  for (std::size_t i = 0; i < texts.size(); ++i) CHECK_THAT(texts[i], Contains(expected[i]));
}

TEST_CASE("All loads that cannot be applied are reported together", "[unit][io]") {
  const std::string load = "[[force]]\nregion = \"liver\"\ndirection = [0, 0, 1]\nevents_N = [[0, 1]]\n";
  CHECK_THAT(message_about(load + load),
             Contains("bad.toml:1: there is no region or particle 'liver'") && Contains("(and 1 more"));
}
