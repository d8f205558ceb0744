#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <thread>

#include "errors/input_error.hpp"
#include "files/replace_file.hpp"
#include "files/sha256.hpp"
#include "results/inspect/print_inspection.hpp"
#include "results/read/read_records.hpp"
#include "results/read/results_kind.hpp"
#include "results/read/stored_run.hpp"
#include "results/write/write_fit.hpp"
#include "results/write/write_run.hpp"
#include "results/write/write_sweep.hpp"
#include "support/catch.hpp"
#include "support/result_records.hpp"

using namespace trunk;
using namespace trunk::test;
namespace fs = std::filesystem;

namespace {

std::size_t files_in(const TemporaryFolder& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder / ""), fs::directory_iterator()));
}

struct Environment {
  explicit Environment(const char* value) { setenv("SOURCE_DATE_EPOCH", value, 1); }
  ~Environment() { unsetenv("SOURCE_DATE_EPOCH"); }
};

}  // namespace

TEST_CASE("A run is read back as it was written", "[results]") {
  const TemporaryFolder folder;
  const fs::path path = folder / "run.h5";
  const RunRecord run = sample_run();
  unsetenv("SOURCE_DATE_EPOCH");  // under it wall_s would be left out
  write_run(path, run);
  CHECK(is_complete(path));
  CHECK(files_in(folder) == 1);

  const StoredRun back = read_stored_run(path);
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

TEST_CASE("A fit gives its best parameters, and its inspection shows their uncertainty", "[results]") {
  const TemporaryFolder folder;
  const fs::path path = folder / "fit.h5";
  FitRecord fit = sample_fit();
  fit.gates.clear();  // beside a gate no parameter is a result
  write_fit(path, fit);
  const auto parameters = read_parameters(path);
  REQUIRE(parameters.size() == 3);
  CHECK(parameters[0].name == "k_elasticity");
  CHECK(parameters[0].value == 4000);
  CHECK(parameters[2].unit == "1");
  const std::string text = inspection_text(path);
  CHECK_THAT(text, Contains("0.4 %") && Contains("AT ITS BOUND") && Contains("fixed") && Contains("± 20"));
  CHECK_THAT(text, Contains("best_run/particles/trajectory/position/value") && Contains("[70, 3, 3]"));
  CHECK_THAT(inspection_json(path), Contains("\"stderr\": 20.0") && Contains("\"kind\": \"fit\""));
  CHECK_THAT(error_of<InputError>([&] { read_stored_run(path); }), Contains("is a fit; expected a run"));
}

TEST_CASE("The results of a fit come back with grades, limits, gates and straight lines", "[results]") {
  const TemporaryFolder folder;
  const fs::path path = folder / "fit.h5";
  const FitRecord fit = sample_fit();
  write_fit(path, fit);
  const FitRecord back = read_fit(path);
  CHECK(back.grade == "not_determined");
  CHECK(back.input == "breath ΔV.csv");
  REQUIRE(back.results.size() == 3);
  const FitRecord::Result &recoil = back.results[0], &muscle = back.results[1];
  CHECK(recoil.name == "recoil_time_s");
  CHECK(recoil.value == 0.5);
  CHECK(recoil.lower95 == 0.2);
  CHECK(std::isinf(recoil.upper95));
  CHECK(recoil.assumption == "the airway takes 40 %");
  CHECK(recoil.meaning == "the time in which volume falls");
  CHECK(recoil.headline == 2);
  CHECK(std::isnan(muscle.value));
  CHECK(muscle.unit == "N m-1");
  CHECK(muscle.grade == "not_determined");
  CHECK(muscle.reason == "not driven by a muscle?");
  REQUIRE(back.gates.size() == 2);
  CHECK(back.gates[1].name == "wander");
  CHECK(back.gates[1].sentence == "its level wanders");
  REQUIRE(back.straight.size() == 1);
  CHECK(back.straight[0].upper95 == 490);
  CHECK(back.straight_nrmse_percent == 2.5);
  CHECK(back.profiles[0].threshold95 == 4.5);
  REQUIRE(back.channels.size() == 2);
  for (const FitRecord::Channel& c : fit.channels) {
    const auto read = std::find_if(back.channels.begin(), back.channels.end(),
                                   [&](const FitRecord::Channel& other) { return other.name == c.name; });
    REQUIRE(read != back.channels.end());
    CHECK(read->unit == c.unit);
    CHECK(read->meaning == c.meaning);
    CHECK(read->measured == c.measured);
    CHECK(read->sigma == c.sigma);
    CHECK(read->model == c.model);
  }
  const FitRecord::Draws draws = read_draws(path);
  CHECK(draws.names == fit.draws.names);
  CHECK(draws.values == fit.draws.values);

  const std::string text = inspection_text(path);
  CHECK_THAT(text, !Contains("± 20") && Contains("4000 (of the simulation, not a result: a gate"));
  CHECK_THAT(text, Contains("0.5 [0.2, inf] s, assumption: the airway takes 40 %") &&
                       Contains("withheld, not_determined: gate machine_driven\n") &&
                       Contains("gate wander: its level wanders") && Contains("note: no profiles") &&
                       Contains("straight lines (residual 2.5 %") && Contains("breath ΔV.csv"));
  CHECK_THAT(inspection_json(path), Contains("\"gates\": [\n    \"machine_driven\",\n    \"wander\"") &&
                                        Contains("\"grade\": \"not_determined\"") &&
                                        Contains("\"nrmse_percent\": 2.5"));
}

TEST_CASE("A sweep counts its runs and stays readable without its run files", "[results]") {
  const TemporaryFolder folder;
  const fs::path path = folder / "sweep.h5";
  write_sweep(path, sample_sweep());  // run.h5 is not there
  CHECK_THAT(inspection_text(path), Contains("diverged") && Contains("table/k_muscle") && Contains("[2, 3]"));
  CHECK_THAT(error_of<InputError>([&] { read_parameters(path); }), Contains("is a sweep"));
}

TEST_CASE("Records that are read and written again give the same bytes", "[results]") {
  const TemporaryFolder folder;
  const Environment epoch("1700000000");
  write_run(folder / "a.h5", sample_run());
  write_run(folder / "b.h5", read_run(folder / "a.h5"));
  CHECK(bytes_of(folder / "a.h5") == bytes_of(folder / "b.h5"));
  write_fit(folder / "a.h5", sample_fit());
  write_fit(folder / "b.h5", read_fit(folder / "a.h5"));
  CHECK(bytes_of(folder / "a.h5") == bytes_of(folder / "b.h5"));
  CHECK(read_run(folder / "a.h5").trajectory.position_m == sample_run().trajectory.position_m);
  write_run(folder / "a.h5", RunRecord());
  write_run(folder / "b.h5", read_run(folder / "a.h5"));
  CHECK(bytes_of(folder / "a.h5") == bytes_of(folder / "b.h5"));
  CHECK_THAT(error_of<InputError>([&] { read_fit(folder / "a.h5"); }), Contains("is a run; expected a fit"));
  write_sweep(folder / "a.h5", sample_sweep());
  CHECK_THAT(error_of<InputError>([&] { read_run(folder / "a.h5"); }), Contains("is a sweep"));
}

TEST_CASE("A wrong record is refused", "[results]") {
  const TemporaryFolder folder;
  const fs::path path = folder / "x.h5";
  RunRecord run = sample_run();
  SECTION("a triangle of a particle that does not exist") {
    run.trajectory.triangles = {{0, 1, 3}};
    write_run(path, run);
    CHECK_THAT(error_of<InputError>([&] { read_run(path); }),
               Contains("names a particle that does not exist"));
  }
  SECTION("a fibre from before the first particle") {
    run.trajectory.fibres = {{0, -1}, {1, 2}};
    write_run(path, run);
    CHECK_THAT(error_of<InputError>([&] { read_run(path); }),
               Contains("names a particle that does not exist"));
  }
}

TEST_CASE("Optional parts may be missing, tables may be empty and texts may be long", "[results]") {
  const TemporaryFolder folder;
  write_run(folder / "run.h5", RunRecord());
  CHECK_FALSE(inspection_text(folder / "run.h5").empty());
  write_fit(folder / "fit.h5", FitRecord());
  CHECK(read_parameters(folder / "fit.h5").empty());
  write_sweep(folder / "sweep.h5", SweepRecord());
  CHECK_FALSE(inspection_json(folder / "sweep.h5").empty());

  SweepRecord no_curves = sample_sweep();
  no_curves.curve_time_s.clear();
  write_sweep(folder / "no_curves.h5", no_curves);
  CHECK_THAT(inspection_text(folder / "no_curves.h5"), Contains("[2, 0]"));

  RunRecord run;
  run.scenario_toml = std::string(200000, '#');
  run.provenance.argv = std::string(200000, 'a');
  write_run(folder / "long.h5", run);
  CHECK_FALSE(inspection_text(folder / "long.h5").empty());

  // A night's breaths: 16 bytes for each of so many texts are too many for the header of an object.
  FitRecord night = sample_fit();
  night.breaths = {{"number", "1", std::vector<double>(5000, 1.0)}};
  night.breath_status.assign(5000, "converged");
  write_fit(folder / "night.h5", night);
  CHECK(read_fit(folder / "night.h5").breath_status.size() == 5000);
}

TEST_CASE("Equal runs give equal files under SOURCE_DATE_EPOCH", "[results]") {
  const TemporaryFolder folder;
  const auto write_both = [&](const std::string& name, const std::string& argv) {
    RunRecord run = sample_run();
    FitRecord fit = sample_fit();
    run.provenance.argv = fit.provenance.argv = argv;
    run.measures[2].value = fit.evaluation_wall_s[0] = static_cast<double>(argv.size());
    write_run(folder / (name + ".run"), run);
    write_fit(folder / (name + ".fit"), fit);
  };
  const auto same = [&](const char* kind) {
    return bytes_of(folder / (std::string("a") + kind)) == bytes_of(folder / (std::string("b") + kind));
  };
  {
    const Environment epoch("1700000000");
    write_both("a", "trunk");
    std::this_thread::sleep_for(std::chrono::milliseconds(1100));
    write_both("b", "trunk -o elsewhere");
    CHECK(same(".run"));
    CHECK(same(".fit"));
    CHECK_THAT(inspection_text(folder / "a.run"), Contains("2023-11-14T22:13:20Z") && !Contains("wall_s"));
  }
  write_both("b", "trunk");
  CHECK_FALSE(same(".run"));
  const Environment wrong("soon");
  CHECK_THAT(error_of<std::runtime_error>([&] { write_both("c", ""); }),
             Contains("SOURCE_DATE_EPOCH is 'soon'"));
}

TEST_CASE("A failed write leaves only the old file", "[results]") {
  const TemporaryFolder folder;
  const fs::path path = folder / "run.h5";
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
  SECTION("a limit on the size of files, instead of a full disk") {
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
  CHECK(files_in(folder) == 1);
}

TEST_CASE("An output path is tested before any work", "[results]") {
  const TemporaryFolder folder;
  const fs::path path = folder / "run.h5";
  const auto refusal = [](const fs::path& output, bool force) {
    return error_of<InputError>([&] { require_writable_output(output, force); });
  };
  CHECK(refusal(path, false).empty());
  CHECK(files_in(folder) == 0);
  put(path, "old");
  CHECK_THAT(refusal(path, false), Contains("--force"));
  CHECK(refusal(path, true).empty());
  CHECK(bytes_of(path) == "old");
  CHECK_THAT(refusal(folder / "none" / "run.h5", true), Contains("does not exist"));
  CHECK_THAT(refusal(path / "run.h5", true), Contains("is a file"));
  CHECK_THAT(refusal(path.parent_path(), true), Contains("is not a file"));
  CHECK_THAT(refusal("/dev/null", true), Contains("is not a file"));
  CHECK_THAT(refusal("", true), Contains("name of a file"));
  CHECK_THAT(error_of<std::runtime_error>([&] { write_run(folder / "none" / "run.h5", sample_run()); }),
             Contains("No such file or directory"));
  CHECK_THAT(error_of<std::runtime_error>([&] { write_run("/dev/null", sample_run()); }),
             Contains("not a file"));
  CHECK_THAT(refusal("/proc/run.h5", true), Contains("/proc/run.h5: cannot create"));  // even for root
  if (geteuid() != 0) {
    fs::permissions(path.parent_path(), fs::perms::owner_read | fs::perms::owner_exec);
    CHECK_THAT(refusal(path, true), Contains("Permission denied"));
    fs::permissions(path.parent_path(), fs::perms::owner_all);
  }
}

TEST_CASE("Many threads may write at the same time", "[results]") {
  const TemporaryFolder folder;
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&, i] { write_run(folder / (std::to_string(i) + ".h5"), sample_run()); });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(files_in(folder) == 4);
  for (int i = 0; i < 4; ++i) CHECK_FALSE(inspection_text(folder / (std::to_string(i) + ".h5")).empty());
}

TEST_CASE("SHA-256 agrees with the published vectors", "[results]") {
  CHECK(sha256_of_text("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  const TemporaryFolder folder;
  put(folder / "abc", "abc");
  CHECK(sha256_of_file(folder / "abc") == sha256_of_text("abc"));
  CHECK_THAT(error_of<InputError>([&] { sha256_of_file(folder / "none"); }), Contains("No such file"));
  CHECK_THAT(error_of<InputError>([&] { sha256_of_file(folder / ""); }), Contains("Is a directory"));
}
