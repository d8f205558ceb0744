#include "cohort/row.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

#include "cohort/stored_fit.hpp"
#include "errors/input_error.hpp"
#include "support/catch.hpp"

using namespace trunk;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

Estimate estimate(const std::string& name, double value, double lower95, double upper95) {
  Estimate e;
  e.name = name;
  e.unit = "N/m";
  e.value = value;
  e.stderr_ = 0.1 * value;
  e.lower95 = lower95;
  e.upper95 = upper95;
  e.identifiable = true;
  e.naive95 = {lower95 + 1.0, upper95 - 1.0};
  return e;
}

FitSummary summary() {
  FitSummary s;
  s.status = "converged";
  s.grade = Grade::not_determined;
  s.gates = {"wander", "subject_size"};
  s.results = {
      {"recoil_time_s", "s", 0.5, 0.25, std::numeric_limits<double>::infinity(), Grade::assumption, "energy"},
      {"k_muscle", "N/m", unknown, unknown, unknown, Grade::not_determined, "", "it wanders"},
      {"delta_h_mm", "mm", 4.0, 3.0, 5.0, Grade::determined}};
  s.headline = {"k_muscle", "recoil_time_s"};
  s.parameters = {estimate("k_elasticity", 16000.0, 100.0, 1e6),
                  estimate("k_muscle", 1.0 / 3.0, 0.25, unknown)};
  s.parameters[0].at_bound = true;
  s.ratio = estimate("k_muscle / k_elasticity", 2e-5, 1e-5, 3e-5);
  s.nrmse_percent = 1.5;
  s.baseline_nrmse_percent = unknown;
  s.tidal_volume_measured_ml = 1e6 * 0.00051;  // no short decimal
  s.breaths_used = 5;
  s.breaths_rejected = 1;
  s.median_latency_ms = 12.5;
  s.predictions = {{"paralysed",
                    "scenarios/paralysed.toml",
                    {{"delta_v_ml", "ml", 250.0, 251.0, 240.0, 260.0},
                     {"excursion_right_mm", "mm", 4.0, 4.0, 3.0, 5.0},
                     {"ratio_percent", "percent", 50.0, 50.5, 48.0, 52.0}},
                    64,
                    3}};
  s.verdict = "Both are determined.";
  s.simulated = 120;
  return s;
}

}  // namespace

TEST_CASE("The row of a subject holds its estimates, numbers and predictions", "[unit]") {
  const std::string csv = cohort_csv({cohort_row("A", summary()), failed_row("B", "b.csv:3: no \"number\"")});
  CHECK(csv ==
        "subject,status,grade,gates,"
        "k_muscle,k_muscle_lower95,k_muscle_upper95,k_muscle_grade,"
        "recoil_time_s,recoil_time_s_lower95,recoil_time_s_upper95,recoil_time_s_grade,"
        "k_elasticity,k_elasticity_lower95,k_elasticity_upper95,k_elasticity_at_bound,"
        "ratio,ratio_lower95,ratio_upper95,ratio_at_bound,"
        "nrmse_percent,baseline_nrmse_percent,tidal_volume_measured_ml,breaths_used,breaths_rejected,"
        "paralysed_delta_v_ml,paralysed_delta_v_ml_lower95,paralysed_delta_v_ml_upper95,"
        "paralysed_excursion_right_mm,paralysed_excursion_right_mm_lower95,paralysed_excursion_right_mm_"
        "upper95,"
        "paralysed_percent,paralysed_percent_lower95,paralysed_percent_upper95,"
        "paralysed_failed_draws,verdict,error\n"
        "A,converged,not_determined,\"wander subject_size\",,,,not_determined,0.5,0.25,,assumption,"
        "16000,,,1,2e-05,1e-05,3e-05,0,"
        "1.5,,510.00000000000006,5,1,250,240,260,4,3,5,50,48,52,3,\"Both are determined.\",\n"
        "B,failed,," +
            std::string(31, ',') + ",,\"b.csv:3: no \"\"number\"\"\"\n");
}

TEST_CASE("A number that one subject lacks is a gap in the table", "[unit]") {
  FitSummary one = summary(), other = summary();
  one.headline.erase(one.headline.begin());
  one.parameters.erase(one.parameters.begin());
  one.predictions.clear();
  other.ratio.reset();
  const std::string csv = cohort_csv({cohort_row("A", one), cohort_row("B", other)});
  CHECK(csv.find("gates,recoil_time_s,") != std::string::npos);  // in the order of their first appearance
  CHECK(csv.find("breaths_rejected,k_muscle,") != std::string::npos);
  const auto commas = [](const std::string& text) { return std::count(text.begin(), text.end(), ','); };
  std::istringstream lines(csv);
  std::string header, a, b;
  std::getline(lines, header);
  std::getline(lines, a);
  std::getline(lines, b);
  CHECK(commas(a) == commas(header));
  CHECK(commas(b) == commas(header));
}

TEST_CASE("A stored fit gives back the row and the JSON of the fit bit for bit", "[unit]") {
  StoredFit fit{summary(), {"breath 3 is odd"}, "f1d0"};
  PredictionSummary& p = fit.summary.predictions.front();
  for (Predicted& n : p.numbers) n.structural_upper95 = (n.structural_lower95 = 0.75 * n.value) + 1.0 / 3.0;
  p.structure = {{{"wall", "parameters.abdomen_stiffness_factor", "1", "ours", 0.5, 0.8, 1.28},
                  {"mesh", "geometry.resolution", "1", "the next", 1, 1, 2}},
                 {"delta_v_ml", "excursion_right_mm", "ratio_percent"},
                 {unknown, unknown, 1.0 / 3.0, 2.0 / 3.0, 0.0, 1.0},
                 {"dome_height is left out, because the trunk comes from a file"}};
  const StoredFit back = stored_fit(text_of(fit, {{"schema", "trunk.fit/2"}, {"wall_s", 2.5}}), "A.json");
  CHECK(back.notes == fit.notes);
  CHECK(back.fingerprint == fit.fingerprint);
  CHECK(cohort_csv({cohort_row("A", back.summary)}) == cohort_csv({cohort_row("A", fit.summary)}));
  CHECK(to_json(back.summary) == to_json(fit.summary));
  CHECK(cohort_csv({cohort_row("A", back.summary)}).find("paralysed_percent_structural_upper95") !=
        std::string::npos);
}

TEST_CASE("A stored fit that lacks optional parts gives back that it lacks them", "[unit]") {
  FitSummary s = summary();
  s.ratio.reset();
  s.median_latency_ms.reset();
  s.predictions.clear();
  s.parameters.clear();
  s.results.clear();
  s.headline.clear();
  const StoredFit back = stored_fit(text_of({s, {}, ""}, Json::object()), "A.json");
  CHECK_FALSE(back.summary.ratio);
  CHECK_FALSE(back.summary.median_latency_ms);
  CHECK(back.summary.predictions.empty());
  CHECK(to_json(back.summary) == to_json(s));
}

TEST_CASE("What is no stored fit is refused with the name of its file", "[unit]") {
  Json other_type = Json::parse(text_of({summary(), {}, ""}, Json::object()));
  other_type["headline"] = "yes";
  Json lacking = Json::parse(text_of({summary(), {}, ""}, Json::object()));
  lacking.erase("verdict");
  for (const std::string& text : {std::string("{"), std::string(), std::string("[1, 2]"), std::string("{}"),
                                  other_type.dump(), lacking.dump()}) {
    INFO(text);
    try {
      stored_fit(text, "d/A.json");
      FAIL("no error");
    } catch (const InputError& error) {
      CHECK(error.mistake().at == Place{"d/A.json"});
      CHECK_FALSE(error.mistake().remedy.empty());
    }
  }
}
