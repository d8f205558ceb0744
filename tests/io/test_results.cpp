#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <thread>

#include "errors/input_error.hpp"
#include "results/describe.hpp"
#include "results/fit_file.hpp"
#include "results/run_file.hpp"
#include "results/sha256.hpp"
#include "results/summary.hpp"
#include "results/sweep_file.hpp"
#include "results/target_file.hpp"

using namespace trunk;
namespace fs = std::filesystem;
using Catch::Matchers::Contains;

namespace {

/// A folder of its own for each test, removed at the end.
struct Folder {
  fs::path path;
  Folder() {
    std::string name = (fs::temp_directory_path() / "trunk-results-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()));
    path = name;
  }
  ~Folder() { fs::remove_all(path); }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), fs::directory_iterator()));
  }
};

struct Environment {
  explicit Environment(const char* value) { setenv("SOURCE_DATE_EPOCH", value, 1); }
  ~Environment() { unsetenv("SOURCE_DATE_EPOCH"); }
};

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void put(const fs::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

/// The message of the error that `action` throws, "" when there is none.
template <typename Exception, typename Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const Exception& error) {
    const std::string text = error.what();
    CHECK(text.find('\n') == std::string::npos);
    return text;
  }
  return "";
}

Provenance sample_provenance() {
  return {"0.1.0",
          "abc123",
          true,
          "g++ 12",
          "Release",
          "trunk simulate",
          7,
          {{"a.toml", "00ff"}},
          {{"NLopt", "2.7.1"}}};
}

RunRecord sample_run() {
  RunRecord run;
  run.title = "healthy";
  run.status = "done";
  run.message = "70 frames";
  run.scenario_toml = "[model]\nname = \"sain ΔV\"\n";
  run.parameters = {{"k_muscle", "N m-1", 30.7}, {"k_elasticity", "N m-1", 4000}};
  run.measures = {{"delta_v", "ml", 466.125}, {"delta_l", "mm", 9.13}, {"wall_s", "s", 0.25}};
  Trajectory& trajectory = run.trajectory;
  trajectory.particles = 3;
  for (int frame = 0; frame < 70; ++frame) {
    trajectory.step.push_back(5 * frame);
    trajectory.time_s.push_back(0.01 * frame);
    for (int i = 0; i < 9; ++i) trajectory.position_m.push_back(std::sin(0.1 * frame + i));
  }
  trajectory.velocity_m_s = trajectory.position_m;
  trajectory.mass_kg = {0.2, 0.2, 0.2};
  trajectory.region = {0, 1, 1};
  trajectory.region_names = {"lung", "central tendon"};
  trajectory.triangles = {{0, 1, 2}};
  trajectory.triangle_component = {0};
  trajectory.component_names = {"skin"};
  trajectory.fibres = {{0, 1}, {1, 2}};
  trajectory.muscle_lines = {{0, 1, 2}, {2, 1, 0}};
  Series volume{"dV_model", "ml", "volume change", {}};
  for (int step = 0; step <= 350; ++step) {
    run.curve_time_s.push_back(0.002 * step);
    volume.values.push_back(466 * std::sin(0.002 * step));
  }
  run.curves = {volume};
  run.provenance = sample_provenance();
  return run;
}

FitRecord sample_fit() {
  const double none = std::numeric_limits<double>::quiet_NaN();
  FitRecord fit;
  fit.title = "S01";
  fit.status = "converged";
  fit.scenario_toml = "x = 1\n";
  fit.verdict = "k_muscle/k_elasticity determined to 0.4 %";
  fit.stop_reason = "XTOL_REACHED";
  fit.algorithm = "BOBYQA";
  fit.parameters = {{"k_elasticity", "N m-1", 3000, 100, 1e5, 4000, 20, 3960, 4040, false, true},
                    {"k_muscle", "N m-1", 20, 1, 500, 500, 2, 496, none, true, true},
                    {"shape", "", 1, 0, 2, 1, none, none, none, false, false}};
  fit.covariance_names = {"k_elasticity", "k_muscle"};
  fit.covariance = {1e-4, 2e-5, 2e-5, 3e-4};
  fit.measured_time_s = fit.result_time_s = {0, 1, 2};
  fit.measured_m3 = {0, 4e-4, 0};
  fit.sigma_m3 = {1e-6, 1e-6, 1e-6};
  fit.evaluation_names = {"k_elasticity", "k_muscle"};
  fit.evaluation_x = {3000, 20, 4000, 30};
  fit.evaluation_objective = {12.5, none};
  fit.evaluation_status = {0, 2};
  fit.evaluation_wall_s = {0.1, 0.2};
  fit.dV_fit_m3 = {0, 4.1e-4, 1e-6};
  fit.residual_m3 = {0, 1e-5, 1e-6};
  fit.statistics = {{"nrmse", "percent", 1.5}};
  fit.best_run = sample_run();
  fit.provenance = sample_provenance();
  return fit;
}

SweepRecord sample_sweep() {
  SweepRecord sweep;
  sweep.title = "grid";
  sweep.sweep_toml = "n = 2\n";
  sweep.columns = {{"k_muscle", "N m-1", {20, 30}}, {"delta_v", "ml", {400, std::nan("")}}};
  sweep.scenario = {"healthy", "healthy"};
  sweep.status = {"done", "diverged"};
  sweep.error = {"", "step 12: no volume root"};
  sweep.run_file = {"run.h5", ""};
  sweep.curve_time_s = {0, 1, 2};
  sweep.fill_curves_ml = [](std::size_t first, std::span<double> dV_ml) {
    const std::vector<double> all = {0, 400, 0, 0, 1, 2};
    std::copy_n(all.begin() + 3 * static_cast<std::ptrdiff_t>(first), dV_ml.size(), dV_ml.begin());
  };
  sweep.provenance = sample_provenance();
  return sweep;
}

}  // namespace

TEST_CASE("a run reads back as it was written", "[results]") {
  const Folder folder;
  const fs::path path = folder.path / "run.h5";
  const RunRecord run = sample_run();
  unsetenv("SOURCE_DATE_EPOCH");  // under it wall_s would be left out
  write_run(path, run);
  CHECK(is_complete(path));
  CHECK(folder.files() == 1);

  const RunSummary back = read_run_summary(path);
  CHECK(back.title == run.title);
  CHECK(back.status == run.status);
  CHECK(back.message == run.message);
  CHECK(back.curve_time_s == run.curve_time_s);
  CHECK(back.curve_dV_ml == run.curves[0].values);
  REQUIRE(back.measures.size() == run.measures.size());
  for (std::size_t i = 0; i < back.measures.size(); ++i) {
    CHECK(back.measures[i].name == run.measures[i].name);  // in the order written
    CHECK(back.measures[i].unit == run.measures[i].unit);
    CHECK(back.measures[i].value == run.measures[i].value);
  }
  const auto parameters = read_parameters(path);
  REQUIRE(parameters.size() == 2);
  CHECK(parameters[0].name == "k_muscle");
  CHECK(parameters[1].value == 4000);
}

TEST_CASE("a fit gives its best parameters; its description shows their uncertainty", "[results]") {
  const Folder folder;
  const fs::path path = folder.path / "fit.h5";
  write_fit(path, sample_fit());
  const auto parameters = read_parameters(path);
  REQUIRE(parameters.size() == 3);
  CHECK(parameters[0].name == "k_elasticity");
  CHECK(parameters[0].value == 4000);
  CHECK(parameters[2].unit == "1");
  const std::string text = describe_file(path);
  CHECK_THAT(text, Contains("0.4 %") && Contains("AT ITS BOUND") && Contains("fixed") && Contains("± 20"));
  CHECK_THAT(text, Contains("best_run/particles/trajectory/position/value") && Contains("[70, 3, 3]"));
  CHECK_THAT(describe_file_json(path), Contains("\"stderr\": 20.0") && Contains("\"kind\": \"fit\""));
  CHECK_THAT(error_of<InputError>([&] { read_run_summary(path); }), Contains("is a fit, expected a run"));
}

TEST_CASE("a sweep counts its runs and outlives its run files", "[results]") {
  const Folder folder;
  const fs::path path = folder.path / "sweep.h5";
  write_sweep(path, sample_sweep());  // run.h5 is not there
  CHECK_THAT(describe_file(path), Contains("diverged") && Contains("table/k_muscle") && Contains("[2, 3]"));
  CHECK_THAT(error_of<InputError>([&] { read_parameters(path); }), Contains("is a sweep"));
}

TEST_CASE("what is optional may be absent, tables may be empty, texts long", "[results]") {
  const Folder folder;
  write_run(folder.path / "run.h5", RunRecord());
  CHECK_FALSE(describe_file(folder.path / "run.h5").empty());
  write_fit(folder.path / "fit.h5", FitRecord());
  CHECK(read_parameters(folder.path / "fit.h5").empty());
  write_sweep(folder.path / "sweep.h5", SweepRecord());
  CHECK_FALSE(describe_file_json(folder.path / "sweep.h5").empty());

  SweepRecord no_curves = sample_sweep();
  no_curves.curve_time_s.clear();
  write_sweep(folder.path / "no_curves.h5", no_curves);
  CHECK_THAT(describe_file(folder.path / "no_curves.h5"), Contains("[2, 0]"));

  RunRecord run;
  run.scenario_toml = std::string(200000, '#');
  run.provenance.argv = std::string(200000, 'a');
  write_run(folder.path / "long.h5", run);
  CHECK_FALSE(describe_file(folder.path / "long.h5").empty());
}

TEST_CASE("equal runs are equal files under SOURCE_DATE_EPOCH", "[results]") {
  const Folder folder;
  const auto write_both = [&](const std::string& name, const std::string& argv) {
    RunRecord run = sample_run();
    FitRecord fit = sample_fit();
    run.provenance.argv = fit.provenance.argv = argv;
    run.measures[2].value = fit.evaluation_wall_s[0] = static_cast<double>(argv.size());
    write_run(folder.path / (name + ".run"), run);
    write_fit(folder.path / (name + ".fit"), fit);
  };
  const auto same = [&](const char* kind) {
    return bytes_of(folder.path / (std::string("a") + kind)) ==
           bytes_of(folder.path / (std::string("b") + kind));
  };
  {
    const Environment epoch("1700000000");
    write_both("a", "trunk");
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    write_both("b", "trunk -o elsewhere");
    CHECK(same(".run"));
    CHECK(same(".fit"));
    CHECK_THAT(describe_file(folder.path / "a.run"), Contains("2023-11-14T22:13:20Z") && !Contains("wall_s"));
  }
  write_both("b", "trunk");
  CHECK_FALSE(same(".run"));
  const Environment wrong("soon");
  CHECK_THAT(error_of<std::runtime_error>([&] { write_both("c", ""); }),
             Contains("SOURCE_DATE_EPOCH is 'soon'"));
}

TEST_CASE("a failed write leaves the old file and nothing else", "[results]") {
  const Folder folder;
  const fs::path path = folder.path / "run.h5";
  write_run(path, sample_run());
  const std::string before = bytes_of(path);

  SECTION("values that do not fit their axes") {
    RunRecord run = sample_run();
    run.trajectory.position_m.pop_back();
    CHECK_THAT(error_of<std::runtime_error>([&] { write_run(path, run); }),
               Contains("run.h5") && Contains("629 values") && Contains("630"));
  }
  SECTION("a name used twice") {
    RunRecord run = sample_run();
    run.measures.push_back(run.measures.front());
    CHECK_THAT(error_of<std::runtime_error>([&] { write_run(path, run); }), Contains("delta_v"));
  }
  SECTION("a name that is a path") {
    RunRecord run = sample_run();
    run.parameters.front().name = "a/b";
    CHECK_THAT(error_of<std::runtime_error>([&] { write_run(path, run); }), Contains("'a/b'"));
  }
  SECTION("no room: a limit on the size of files stands in for a full disk") {
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      std::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{4096, 4096};
      setrlimit(RLIMIT_FSIZE, &limit);
      try {
        write_run(path, sample_run());
      } catch (const std::runtime_error& error) {
        _exit(std::string(error.what()).find("cannot be written: File too large") == std::string::npos ? 2
                                                                                                       : 42);
      }
      _exit(1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 42);
  }
  CHECK(bytes_of(path) == before);
  CHECK(folder.files() == 1);
}

TEST_CASE("a target is tested before any work", "[results]") {
  const Folder folder;
  const fs::path path = folder.path / "run.h5";
  const auto refusal = [](const fs::path& target, bool force) {
    return error_of<InputError>([&] { require_writable_target(target, force); });
  };
  CHECK(refusal(path, false).empty());
  CHECK(folder.files() == 0);
  put(path, "old");
  CHECK_THAT(refusal(path, false), Contains("--force"));
  CHECK(refusal(path, true).empty());
  CHECK(bytes_of(path) == "old");
  CHECK_THAT(refusal(folder.path / "none" / "run.h5", true), Contains("does not exist"));
  CHECK_THAT(refusal(path / "run.h5", true), Contains("is a file"));
  CHECK_THAT(refusal(folder.path, true), Contains("is not a file"));
  CHECK_THAT(refusal("/dev/null", true), Contains("is not a file"));
  CHECK_THAT(refusal("", true), Contains("name of a file"));
  CHECK_THAT(error_of<std::runtime_error>([&] { write_run(folder.path / "none" / "run.h5", sample_run()); }),
             Contains("No such file or directory"));
  CHECK_THAT(error_of<std::runtime_error>([&] { write_run("/dev/null", sample_run()); }),
             Contains("not a file"));
  CHECK_THAT(refusal("/proc/run.h5", true), Contains("/proc/run.h5: cannot create"));  // even for root
  if (geteuid() != 0) {
    fs::permissions(folder.path, fs::perms::owner_read | fs::perms::owner_exec);
    CHECK_THAT(refusal(path, true), Contains("Permission denied"));
    fs::permissions(folder.path, fs::perms::owner_all);
  }
}

TEST_CASE("what is not a finished results file is refused by name", "[results]") {
  const Folder folder;
  const fs::path path = folder.path / "x.h5", good = folder.path / "good.h5";
  write_run(good, sample_run());
  const std::string bytes = bytes_of(good);
  const auto refusal = [&] {
    CHECK_FALSE(is_complete(path));
    return error_of<InputError>([&] { describe_file(path); });
  };
  CHECK_THAT(refusal(), Contains("no such file"));
  put(path, "");
  CHECK_THAT(refusal(), Contains("not an HDF5 file"));
  put(path, "time_s,volume_ml\n0,0\n");
  CHECK_THAT(refusal(), Contains("not an HDF5 file"));
  for (const std::size_t size : {std::size_t{9}, std::size_t{48}, bytes.size() / 2, bytes.size() - 1}) {
    put(path, bytes.substr(0, size));
    CHECK_THAT(refusal(), Contains("truncated or damaged") || Contains("not an HDF5 file"));
  }
  CHECK_THAT(error_of<InputError>([&] { describe_file(folder.path); }), Contains("is not a file"));
}

TEST_CASE("a flipped bit is an error, or does not matter; it never is another number", "[results]") {
  const Folder folder;
  const fs::path path = folder.path / "run.h5";
  write_run(path, sample_run());
  const std::string bytes = bytes_of(path);
  const RunSummary good = read_run_summary(path);
  const std::string description = describe_file(path);
  std::mt19937 random(1);
  int seen = 0;
  constexpr int flips = 400;
  for (int flip = 0; flip < flips; ++flip) {
    std::string damaged = bytes;
    char& byte = damaged[std::uniform_int_distribution<std::size_t>(0, bytes.size() - 1)(random)];
    byte = static_cast<char>(byte ^ (1 << (flip % 8)));
    put(path, damaged);
    try {
      const std::string now = describe_file(path);
      const RunSummary back = read_run_summary(path);
      // Unused space, and the references that name the axes: what is read is right.
      CHECK(now == description);
      CHECK(back.curve_dV_ml == good.curve_dV_ml);
      CHECK(back.measures.front().value == good.measures.front().value);
    } catch (const InputError&) {
      ++seen;
    }
  }
  INFO(seen << " of " << flips << " seen");
  CHECK(seen > flips / 3);
}

TEST_CASE("many threads may write at once", "[results]") {
  const Folder folder;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&, i] { write_run(folder.path / (std::to_string(i) + ".h5"), sample_run()); });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(folder.files() == 4);
  for (int i = 0; i < 4; ++i) CHECK_FALSE(describe_file(folder.path / (std::to_string(i) + ".h5")).empty());
}

TEST_CASE("sha256 agrees with the published vectors", "[results]") {
  CHECK(sha256_of_text("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  const Folder folder;
  put(folder.path / "abc", "abc");
  CHECK(sha256_of_file(folder.path / "abc") == sha256_of_text("abc"));
  CHECK_THAT(error_of<InputError>([&] { sha256_of_file(folder.path / "none"); }), Contains("No such file"));
  CHECK_THAT(error_of<InputError>([&] { sha256_of_file(folder.path); }), Contains("Is a directory"));
}
