#include <cmath>
#include <set>

#include "errors/input_error.hpp"
#include "support/catch.hpp"
#include "support/temporary_folder.hpp"
#include "validation/bounds.hpp"
#include "validation/usual_ranges.hpp"

using namespace trunk;

namespace {

const std::filesystem::path source_folder = TRUNK_SOURCE_DIR;
const std::filesystem::path shipped_table = source_folder / "reference/table1.csv";

Table1 read(const std::string& text) {
  const test::TemporaryFolder folder;
  return read_table1(folder.write("t.csv", text));
}

const std::string header = "source,eev_ml,eiv_ml,dv_ml,dv_percent,dl_mm,dl_percent,dh_mm,dr_mm\n";
const std::string experiment = "experiment,4760,5226,466,9.78,9.13,6.13,2.00,0.00\n";
const std::string published = "published_model,4759,5197,438,9.20,9.73,5.98,13.30,8.80\n";

ValidatedBreath breath(double dv_ml, double right_mm, double left_mm) {
  ValidatedBreath b;
  b.status = "completed";
  b.row = {4760.0, 4760.0 + dv_ml, dv_ml, dv_ml / 47.6, 9.0, 6.0, 2.1, 0.1};
  b.right_dome_mm = right_mm;
  b.left_dome_mm = left_mm;
  b.volume_error = 1e-15;
  return b;
}

/// A model that keeps every bound, by numbers made up for the purpose.
ValidationRun good() {
  ValidationRun f;
  f.paper = read_table1(shipped_table);
  f.published_healthy = breath(440.0, 9.0, 9.0);
  f.healthy = breath(466.0, 10.0, 10.0);
  f.healthy.lung = true;
  f.healthy.gastric_swing_cmH2O = 3.5;
  f.healthy.pleural_swing_cmH2O = -3.2;
  f.healthy.transdiaphragmatic_swing_cmH2O = 6.6;
  f.healthy.recoil_time_s = 0.35;
  f.craighero = breath(466.0, 10.0, 10.0);
  f.hemiparalysis_right = breath(230.0, -2.0, 14.0);
  f.hemiparalysis_left = breath(230.0, 14.0, -2.0);
  f.exercise_healthy = breath(1200.0, 27.0, 27.0);
  f.exercise_hemiparalysis_right = breath(600.0, -3.0, 38.0);
  return f;
}

std::set<std::string> failing(const ValidationRun& f) {
  std::set<std::string> names;
  for (const Judged& r : judged(f))
    if (!r.pass) names.insert(r.bound.name);
  return names;
}

}  // namespace

TEST_CASE("Table 1 is read as the paper prints it", "[unit][validation]") {
  const Table1 table = read_table1(shipped_table);
  CHECK(table.experiment.eev_ml == 4760);
  CHECK(table.experiment.dl_percent == 6.13);
  CHECK(table.experiment.dr_mm == 0);
  CHECK(table.published_model.dh_mm == 13.3);
  CHECK(table.published_model.dr_mm == 8.8);
  const Table1 swapped = read(
      "# by hand\ndv_ml;source;eev_ml;eiv_ml;dv_percent;dl_mm;dl_percent;dh_mm;dr_mm\n"
      "438;published_model;4759;5197;9,2;9,73;5,98;13,3;8,8\n"
      "466;experiment;4760;5226;9,78;9,13;6,13;2;0\n");
  CHECK(swapped.experiment.dl_mm == 9.13);
  CHECK(swapped.published_model.dv_ml == 438);
}

TEST_CASE("A table that is not Table 1 is refused where it goes wrong", "[unit][validation]") {
  CHECK_NOTHROW(read(header + experiment + published));
  CHECK_THROWS_WITH(read("source,eev_ml\nexperiment,1\n"),
                    Contains("t.csv:1:") && Contains("no column 'eiv_ml'"));
  CHECK_THROWS_WITH(read("weight," + header + "70," + experiment),
                    Contains("unknown column") && Contains("weight"));
  CHECK_THROWS_WITH(read("dv_ml," + header + "466," + experiment), Contains("dv_ml") && Contains("twice"));
  CHECK_THROWS_WITH(read(header + experiment), Contains("no row with source 'published_model'"));
  CHECK_THROWS_WITH(read(header + experiment + published + experiment),
                    Contains("t.csv:4:") && Contains("twice"));
  CHECK_THROWS_WITH(read(header + experiment + "ours,1,2,1,1,1,1,1,1\n"),
                    Contains("t.csv:3:") && Contains("ours"));
  CHECK_THROWS_WITH(read(header + "experiment,4760,5226,many,9.78,9.13,6.13,2,0\n"),
                    Contains("dv_ml") && Contains("many"));
  CHECK_THROWS_WITH(read(header + "experiment,4760,5226,466,9.78,9.13\n"), Contains("t.csv:2:"));
  CHECK_THROWS_WITH(read(header + "experiment,4760,5226,644,9.78,9.13,6.13,2,0\n"),
                    Contains("644") && Contains("expected eiv_ml - eev_ml, which is 466"));
  CHECK_THROWS_WITH(read(header + "experiment,0,466,466,9.78,9.13,6.13,2,0\n"), Contains("above 0"));
}

TEST_CASE("Errors are relative, but differences where the experiment is 0", "[unit][validation]") {
  const Table1 table = read_table1(shipped_table);
  for (const Table1Column& column : table1_columns()) {
    const Table1Error error = error_of(column, table.published_model, table.experiment);
    CHECK(error.relative == (column.csv != "dr_mm"));
    if (column.csv == "eev_ml")
      CHECK(error.value == Approx(-0.02).margin(0.005));  // the paper's own "% error"
    if (column.csv == "eiv_ml") CHECK(error.value == Approx(-0.55).margin(0.005));
    if (column.csv == "dl_mm") CHECK(error.value == Approx(6.57).margin(0.005));
    if (column.csv == "dr_mm") CHECK(error.value == Approx(8.80));
    CHECK(error_of(column, table.experiment, table.experiment).value == 0.0);
  }
}

TEST_CASE("A row takes the measures by name, and a missing one is NaN", "[unit][validation]") {
  std::vector<NamedValue> measures;
  for (const Table1Column& column : table1_columns())
    measures.push_back(
        {std::string(column.measure), std::string(column.unit), 1.0 + static_cast<double>(measures.size())});
  const Table1Row row = row_of(measures);
  double expected = 1.0;
  for (const Table1Column& column : table1_columns()) CHECK(row.*column.value == expected++);
  measures.pop_back();
  CHECK(std::isnan(row_of(measures).dr_mm));
}

TEST_CASE("A good model keeps every bound, each worsened number fails its own", "[unit][validation]") {
  REQUIRE(failing(good()).empty());
  struct Case {
    std::set<std::string> fails;
    void (*worsen)(ValidationRun&);
  };
  const Case cases[] = {
      {{"healthy.eev_error"}, [](ValidationRun& f) { f.healthy.row.eev_ml = 4765; }},
      {{"healthy.eev_error"}, [](ValidationRun& f) { f.healthy.row.eev_ml = 4755; }},
      {{"healthy.dv_error"}, [](ValidationRun& f) { f.healthy.row.dv_ml = 471; }},
      {{"healthy.dv_error"}, [](ValidationRun& f) { f.healthy.row.dv_ml = 461; }},
      {{"healthy.dv_error", "healthy.dv_nearness"}, [](ValidationRun& f) { f.healthy.row.dv_ml = 495; }},
      {{"healthy.dl_difference"}, [](ValidationRun& f) { f.healthy.row.dl_mm = 8.82; }},
      {{"healthy.dl_difference"}, [](ValidationRun& f) { f.healthy.row.dl_mm = 9.44; }},
      {{"healthy.dl_difference", "healthy.dl_nearness"},
       [](ValidationRun& f) { f.healthy.row.dl_mm = 8.52; }},
      {{"healthy.dh_difference"}, [](ValidationRun& f) { f.healthy.row.dh_mm = 1.24; }},
      {{"healthy.dh_difference"}, [](ValidationRun& f) { f.healthy.row.dh_mm = 2.76; }},
      {{"healthy.dh_difference", "healthy.dh_nearness"},
       [](ValidationRun& f) { f.healthy.row.dh_mm = -9.4; }},
      {{"healthy.dr_difference"}, [](ValidationRun& f) { f.healthy.row.dr_mm = 0.51; }},
      {{"healthy.dr_difference"}, [](ValidationRun& f) { f.healthy.row.dr_mm = -0.51; }},
      {{"healthy.dr_difference", "healthy.dr_nearness"},
       [](ValidationRun& f) { f.healthy.row.dr_mm = -8.9; }},
      {{"healthy.gastric_swing_cmH2O"}, [](ValidationRun& f) { f.healthy.gastric_swing_cmH2O = 9.65; }},
      {{"healthy.pleural_swing_cmH2O"}, [](ValidationRun& f) { f.healthy.pleural_swing_cmH2O = 3.2; }},
      {{"healthy.transdiaphragmatic_swing_cmH2O"},
       [](ValidationRun& f) { f.healthy.transdiaphragmatic_swing_cmH2O = 5.9; }},
      {{"healthy.recoil_time_s"}, [](ValidationRun& f) { f.healthy.recoil_time_s = 0.41; }},
      {{"craighero.eev_error"}, [](ValidationRun& f) { f.craighero.row.eev_ml = 4765; }},
      {{"craighero.dv_error"}, [](ValidationRun& f) { f.craighero.row.dv_ml = 461; }},
      {{"craighero.dl_difference"}, [](ValidationRun& f) { f.craighero.row.dl_mm = 10.64; }},
      {{"craighero.dh_difference"}, [](ValidationRun& f) { f.craighero.row.dh_mm = 1.24; }},
      {{"craighero.dr_difference"}, [](ValidationRun& f) { f.craighero.row.dr_mm = -0.76; }},
      {{"hemiparalysis_right.dv", "hemiparalysis.mirror"},
       [](ValidationRun& f) { f.hemiparalysis_right.row.dv_ml = 186; }},
      {{"hemiparalysis_left.dv", "hemiparalysis.mirror"},
       [](ValidationRun& f) { f.hemiparalysis_left.row.dv_ml = 280; }},
      {{"exercise_hemiparalysis_right.dv"},
       [](ValidationRun& f) { f.exercise_hemiparalysis_right.row.dv_ml = 479; }},
      {{"exercise_hemiparalysis_right.dv"}, [](ValidationRun& f) { f.exercise_healthy.row.dv_ml = 999; }},
      {{"hemiparalysis_right.paralysed_dome", "hemiparalysis_left.paralysed_dome"},
       [](ValidationRun& f) {
         f.hemiparalysis_right.right_dome_mm = f.hemiparalysis_left.left_dome_mm = -0.99;
       }},
      {{"exercise_hemiparalysis_right.paralysed_dome"},
       [](ValidationRun& f) { f.exercise_hemiparalysis_right.right_dome_mm = 3.0; }},
      {{"exercise_hemiparalysis_right.healthy_dome"},
       [](ValidationRun& f) { f.exercise_hemiparalysis_right.left_dome_mm = 0.0; }},
      {{"hemiparalysis_left.healthy_dome", "hemiparalysis.mirror"},
       [](ValidationRun& f) { f.hemiparalysis_left.right_dome_mm = -14.0; }},
      {{"hemiparalysis.mirror"}, [](ValidationRun& f) { f.hemiparalysis_left.right_dome_mm = 14.3; }},
      {{"hemiparalysis.mirror"}, [](ValidationRun& f) { f.hemiparalysis_left.left_dome_mm = -2.3; }},
      {{"hemiparalysis.mirror"}, [](ValidationRun& f) { f.hemiparalysis_left.row.dl_mm = 9.2; }},
      {{"all.volume_error"}, [](ValidationRun& f) { f.published_healthy.volume_error = 1.1e-10; }}};
  for (const Case& c : cases) {
    ValidationRun f = good();
    c.worsen(f);
    CAPTURE(&c - cases);
    CHECK(failing(f) == c.fails);
  }
}

TEST_CASE("Perfect agreement passes; limits that are reached pass unless they are open",
          "[unit][validation]") {
  ValidationRun f = good();
  f.healthy.row = f.paper.experiment;
  CHECK(failing(f).empty());
  f.healthy.row.dr_mm = 0.5;
  CHECK(failing(f).empty());
  f.paper.published_model.dr_mm = 0.5;  // no nearer than the published model
  CHECK(failing(f) == std::set<std::string>{"healthy.dr_nearness"});
}

TEST_CASE("An unknown number keeps no bound", "[unit][validation]") {
  ValidationRun f = good();
  for (const ValidatedScenario& scenario : validated_scenarios()) {
    ValidatedBreath& b = f.*scenario.breath;
    for (const Table1Column& column : table1_columns()) b.row.*column.value = std::nan("");
    b.right_dome_mm = b.left_dome_mm = b.volume_error = std::nan("");
    for (const UsualRange& range : usual_ranges()) b.*range.value = std::nan("");
  }
  CHECK(failing(f).size() == bounds(f).size());
  ValidationRun one = good();
  one.exercise_healthy.volume_error = std::nan("");
  CHECK(failing(one) == std::set<std::string>{"all.volume_error"});
}

TEST_CASE("A healthy trunk without a lung has no pressures to judge", "[unit][validation]") {
  ValidationRun f = good();
  f.healthy.pleural_swing_cmH2O = 3.2;
  CHECK(failing(f) == std::set<std::string>{"healthy.pleural_swing_cmH2O"});
  f.healthy.lung = false;
  CHECK(failing(f).empty());
  CHECK(bounds(f).size() == bounds(good()).size() - usual_ranges().size());
}

TEST_CASE("Failures give one line with values and bounds, and success gives none", "[unit][validation]") {
  ValidationRun f = good();
  CHECK(failures_text(judged(f)).empty());
  f.healthy.row.dh_mm = 5.0;
  f.exercise_hemiparalysis_right.right_dome_mm = 3.0;
  const std::string text = failures_text(judged(f));
  CHECK_THAT(text, Contains("2 of " + std::to_string(bounds(f).size()) + " bounds do not hold: "));
  CHECK_THAT(text, Contains("healthy.dh_difference 3 (bound -0.75 to 0.75 mm)"));
  CHECK_THAT(text, Contains("exercise_hemiparalysis_right.paralysed_dome 3 (bound at most -1 mm)"));
  CHECK(text.find('\n') == std::string::npos);
  std::set<std::string> names;
  for (const Bound& bound : bounds(f)) CHECK(names.insert(bound.name).second);
}

TEST_CASE("The shipped scenarios keep every bound", "[regression][validation][slow]") {
  std::vector<std::string> ran;
  const ValidationRun f = run_validation(shipped_table, source_folder / "scenarios",
                                         [&](std::string_view name) { ran.emplace_back(name); });
  CHECK(ran.size() == validated_scenarios().size());
  for (const ValidatedScenario& scenario : validated_scenarios()) {
    CAPTURE(scenario.name);
    CHECK((f.*scenario.breath).status == "completed");
  }
  const std::string failures = failures_text(judged(f));
  CHECK(failures == "");
}
