#include <limits>

#include "exports/csv_table.hpp"
#include "exports/csv_tables.hpp"
#include "support/catch.hpp"

using namespace trunk;

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

std::vector<std::string> file_names(const std::vector<NamedText>& files) {
  std::vector<std::string> names;
  for (const NamedText& file : files) names.push_back(file.name);
  return names;
}

}  // namespace

TEST_CASE("A unit becomes the ending of a column's name", "[exports]") {
  CHECK(unit_suffix("ml") == "_ml");
  CHECK(unit_suffix("N m-1") == "_N_per_m");
  CHECK(unit_suffix("N s m-1") == "_N_s_per_m");
  CHECK(unit_suffix("1").empty());
  CHECK(unit_suffix("").empty());
}

TEST_CASE("A cell keeps all digits of a number and quotes a text that needs it", "[exports]") {
  for (const double value : {0.1, 1.0 / 3.0, -1e-300, 4000.0}) CHECK(std::stod(csv_cell(value)) == value);
  CHECK(csv_cell(no_value).empty());
  CHECK(csv_cell(std::string("plain text")) == "plain text");
  CHECK(csv_cell(std::string("a, \"b\"")) == "\"a, \"\"b\"\"\"");
  CHECK(csv_cell(std::string("two\nlines")) == "\"two\nlines\"");
}

TEST_CASE("A table leaves out a column of another length", "[exports]") {
  CsvTable table;
  table.add("time", "s", std::vector<double>{0.0, 0.5});
  table.add("short", "ml", std::vector<double>{1.0});
  table.add("empty", "ml", std::vector<double>{});
  table.add("dV", "ml", std::vector<double>{no_value, 2.0});
  table.add("note", "", std::vector<std::string>{"a,b", "c"});
  CHECK(table.csv() == "time_s,dV_ml,note\n0,,\"a,b\"\n0.5,2,c\n");
}

TEST_CASE("A run gives the tables of its trajectory only if it has one", "[exports]") {
  RunRecord run;
  run.curve_time_s = {0.0, 0.1};
  run.curves = {{"dV_model", "ml", "", {0.0, 3.0}}};
  run.measures = {{"delta_v_ml", "ml", 466.0}};
  const auto files = csv_tables(run);
  CHECK(file_names(files) == std::vector<std::string>{"curves.csv", "measures.csv", "parameters.csv"});
  CHECK(files[0].text == "time_s,dV_model_ml\n0,0\n0.1,3\n");
  CHECK(files[1].text == "name,value,unit\ndelta_v_ml,466,ml\n");

  Trajectory& t = run.trajectory;
  t.particles = 2;
  t.time_s = {0.0, 0.1};
  t.position_m = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  t.region = {1, 7};  // the second has no name
  t.region_names = {"pelvis", "tendon"};
  const auto more = csv_tables(run);
  REQUIRE(more.size() == 8);
  CHECK(more[4].name == "positions.csv");
  CHECK(more[4].text == "time_s,particle,x_m,y_m,z_m\n0,0,0,1,2\n0,1,3,4,5\n0.1,0,6,7,8\n0.1,1,9,10,11\n");
  CHECK(more[5].name == "particles.csv");
  CHECK(more[5].text == "particle,region\n0,tendon\n1,7\n");
}

TEST_CASE("The breath of a fit has its channels beside the volume", "[exports]") {
  FitRecord fit;
  fit.measured_time_s = fit.result_time_s = {0.0, 1.0};
  fit.measured_m3 = {0.0, 1e-4};
  fit.channels = {{"gastric_pressure", "cmH2O", "gastric pressure", {0.0, 4.0}, {1.0, 2.0}, {0.5, 3.0}},
                  {"emg", "1", "EMG of the diaphragm", {5.0, 6.0}, {1.0, 1.0}, {}}};
  const auto files = csv_tables(fit);
  const auto breath =
      std::find_if(files.begin(), files.end(), [](const NamedText& f) { return f.name == "breath.csv"; });
  REQUIRE(breath != files.end());
  CHECK(breath->text ==
        "time_s,measured_ml,gastric_pressure_measured_cmH2O,gastric_pressure_sigma_cmH2O,"
        "gastric_pressure_fit_cmH2O,emg_measured,emg_sigma\n"
        "0,0,0,1,0.5,5,1\n1,100,4,2,3,6,1\n");
}

TEST_CASE("A fit's likelihood surface is one row for each point, the second axis fastest", "[exports]") {
  FitRecord fit;
  fit.surface.name[0] = "k_elasticity";
  fit.surface.unit[0] = "N m-1";
  fit.surface.name[1] = "k_muscle/k_elasticity";
  fit.surface.unit[1] = "1";
  fit.surface.axis[0] = {3000.0, 4000.0};
  fit.surface.axis[1] = {0.1, 0.2};
  fit.surface.deviance = {1.0, 2.0, 3.0, no_value};
  const auto files = csv_tables(fit);
  const auto names = file_names(files);
  REQUIRE(names.size() == 8);
  CHECK(names.back() == "surface.csv");
  CHECK(files.back().text ==
        "k_elasticity_N_per_m,k_muscle/k_elasticity,deviance\n"
        "3000,0.1,1\n3000,0.2,2\n4000,0.1,3\n4000,0.2,\n");
}
