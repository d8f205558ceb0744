#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "files/sha256.hpp"
#include "support/catch.hpp"
#include "support/trunks.hpp"

/// Holds the simulator against trajectories that the independent oracle wrote (reference/golden).
using namespace trunk;
using namespace trunk::test;
using Json = nlohmann::json;

namespace {

const std::filesystem::path folder = std::filesystem::path(TRUNK_SOURCE_DIR) / "reference/golden";
const std::string regenerate = "if that was meant, run scripts/regenerate_golden";

std::vector<std::filesystem::path> golden_files() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

Json read(const std::filesystem::path& path) {
  std::ifstream file(path);
  return Json::parse(file);
}

/// The first line of `now` that is not in the same place in `before`; empty where the texts are equal.
std::string first_difference(const std::string& before, const std::string& now) {
  if (before == now) return {};
  std::istringstream old_lines(before), new_lines(now);
  std::string was, is;
  do {
    was = is = "(no line)";
    std::getline(old_lines, was);
    std::getline(new_lines, is);
  } while (was == is && old_lines && new_lines);
  return "'" + was + "' then, '" + is + "' now";
}

/// Fails if the two programs had different input.
void require_same_scenario(const Json& golden, const Scenario& scenario) {
  const std::string then = golden.at("scenario_toml"), now = to_toml(scenario);
  INFO("The scenario is not the one of the golden data: " << first_difference(then, now) << "; "
                                                          << regenerate);
  REQUIRE(then == now);
  REQUIRE(golden.at("scenario_sha256") == sha256_of_text(now));
}

void check_delta_v(const Json& golden, const BreathRun& run) {
  const std::vector<double> expected_ml = golden.at("delta_v").at("ml");
  const std::size_t every = golden.at("delta_v").at("every_steps");
  REQUIRE(expected_ml.size() == (run.delta_v.size() - 1) / every + 1);
  REQUIRE(*std::max_element(expected_ml.begin(), expected_ml.end()) > 100.0);
  double apart_ml = 0.0;
  for (std::size_t i = 0; i < expected_ml.size(); ++i)
    apart_ml = std::max(apart_ml, std::abs(1e6 * run.delta_v[i * every] - expected_ml[i]));
  INFO("dV differs from the oracle's by up to " << apart_ml << " ml; " << regenerate);
  CHECK(apart_ml <= golden.at("tolerance").at("delta_v_ml").get<double>());
}

void check_positions(const Json& golden, const Json& at_moment, const BreathRun& run) {
  const auto step = at_moment.at("step").get<std::size_t>();
  REQUIRE(step < run.frames.size());
  const double tolerance_m = golden.at("tolerance").at("position_m");
  for (const auto& [name, particle] : golden.at("particles").items()) {
    const std::vector<double> expected = at_moment.at("m").at(name);
    const Vec3d found = run.frames[step].position.at(particle.get<std::size_t>());
    const double apart_m = norm(found - Vec3d(expected.at(0), expected.at(1), expected.at(2)));
    INFO(name << " at " << at_moment.at("moment") << " is " << apart_m << " m from where the oracle puts it"
              << (step == 0 ? " (the mesh is another)" : "") << "; " << regenerate);
    CHECK(apart_m <= tolerance_m);
  }
}

}  // namespace

TEST_CASE("Breaths are where the independent oracle puts them", "[regression][golden][slow]") {
  const auto files = golden_files();
  REQUIRE(files.size() >= 3);
  for (const auto& path : files) {
    CAPTURE(path.filename().string());
    const Json golden = read(path);
    Scenario scenario = shipped(golden.at("scenario"));
    scenario.time.start = Start::rest;  // as the oracle simulated it
    require_same_scenario(golden, scenario);
    const BreathRun run = run_breath(make_trunk(scenario), scenario, 1);
    REQUIRE(run.ending.completed());
    check_delta_v(golden, run);
    REQUIRE(golden.at("particles").size() >= 5);
    for (const char* moment : {"start", "end_inspiration", "end"}) {
      const Json& all = golden.at("positions");
      const auto found =
          std::find_if(all.begin(), all.end(), [&](const Json& p) { return p.at("moment") == moment; });
      REQUIRE(found != all.end());
      check_positions(golden, *found, run);
    }
  }
}

TEST_CASE("Golden data name their source and stay small", "[unit][golden]") {
  for (const auto& path : golden_files()) {
    CAPTURE(path.filename().string());
    CHECK(std::filesystem::file_size(path) < 20'000);
    const Json golden = read(path);
    CHECK(golden.at("schema") == "trunk.golden/1");
    CHECK(golden.at("scenario") == path.stem().string());
    for (const char* key :
         {"generator", "numpy", "python", "mesh_and_scenario_from", "program_commit", "date", "command"})
      CHECK_FALSE(golden.at("provenance").at(key).get<std::string>().empty());
    CHECK(golden.at("provenance").at("generator_version") >= 1);
    CHECK_FALSE(golden.at("tolerance").at("reason").get<std::string>().empty());
    CHECK(golden.at("tolerance").at("position_m") <= 1e-9);
  }
}
