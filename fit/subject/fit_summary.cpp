#include "subject/fit_summary.hpp"

#include <algorithm>

#include "math/units.hpp"
#include "subject/record.hpp"
#include "subject/structure_json.hpp"

namespace trunk {
namespace {

double number_from(const Json& json, const char* key) {
  const Json& value = json.at(key);
  return value.is_null() ? std::nan("") : value.get<double>();
}

Json to_json(const Predicted& p, const Structure& structure) {
  Json json{{"value", json_number(p.value)},
            {"unit", p.unit},
            {"median", json_number(p.median)},
            {"lower95", json_number(p.lower95)},
            {"upper95", json_number(p.upper95)}};
  if (structure.empty()) return json;
  json["structural_lower95"] = json_number(p.structural_lower95);
  json["structural_upper95"] = json_number(p.structural_upper95);
  json["structural_shares"] = shares_json(structure, p.name);
  return json;
}

Predicted predicted_from(const std::string& name, const Json& json) {
  Predicted p{name,
              json.at("unit").get<std::string>(),
              number_from(json, "value"),
              number_from(json, "median"),
              number_from(json, "lower95"),
              number_from(json, "upper95")};
  if (!json.contains("structural_lower95")) return p;
  p.structural_lower95 = number_from(json, "structural_lower95");
  p.structural_upper95 = number_from(json, "structural_upper95");
  return p;
}

Json to_json(const PredictionSummary& p) {
  Json json{{"scenario", p.scenario}};
  for (const Predicted& number : p.numbers) json[number.name] = to_json(number, p.structure);
  json["draws"] = p.draws;
  json["failed"] = p.failed;
  add_choices(p.structure, json);
  return json;
}

PredictionSummary prediction_from(const std::string& name, const Json& json) {
  PredictionSummary p{name,
                      json.at("scenario").get<std::string>(),
                      {},
                      json.at("draws").get<std::size_t>(),
                      json.at("failed").get<int>()};
  for (const auto& [key, value] : json.items())
    if (value.is_object()) p.numbers.push_back(predicted_from(key, value));
  p.structure = structure_from(json);
  return p;
}

Estimate estimate_from(const std::string& name, const Json& json) {
  Estimate e;
  e.name = name;
  e.unit = json.at("unit").get<std::string>();
  e.value = number_from(json, "value");
  e.stderr_ = number_from(json, "stderr");
  e.lower95 = number_from(json, "lower95");
  e.upper95 = number_from(json, "upper95");
  e.naive95 = {number_from(json, "naive_lower95"), number_from(json, "naive_upper95")};
  e.identifiable = json.at("identifiable").get<bool>();
  e.at_bound = json.at("at_bound").get<bool>();
  return e;
}

Grade grade_from(const std::string& name) {
  for (const Grade grade : {Grade::determined, Grade::assumption, Grade::not_determined})
    if (name == name_of(grade)) return grade;
  return Grade::not_converged;
}

std::string text_from(const Json& json, const char* key) {
  const Json& value = json.at(key);
  return value.is_null() ? "" : value.get<std::string>();
}

FitResult result_from(const std::string& name, const Json& json) {
  return {name,
          json.at("unit").get<std::string>(),
          number_from(json, "value"),
          number_from(json, "lower95"),
          number_from(json, "upper95"),
          grade_from(json.at("grade").get<std::string>()),
          text_from(json, "assumption"),
          text_from(json, "reason"),
          text_from(json, "meaning")};
}

}  // namespace

const Predicted& PredictionSummary::operator[](std::string_view number) const {
  return *std::find_if(numbers.begin(), numbers.end(), [&](const Predicted& p) { return p.name == number; });
}

PredictionSummary summary_of(const Prediction& p) {
  return {short_name(p.scenario), p.scenario, p.numbers, p.delta_v_draws_m3.size(), p.failed, p.structure};
}

FitSummary summary_of(const SubjectFit& fit, const FitOutcome& outcome) {
  const Estimation& e = outcome.estimation;
  FitSummary s;
  s.grade = outcome.results.grade;
  s.status = status_of(s.grade);
  for (const Gate& gate : outcome.results.gates) s.gates.push_back(gate.name);
  s.results = outcome.results.results;
  s.headline = outcome.results.headline;
  if (e.uncertainty) {
    s.parameters = e.uncertainty->parameters;
    if (!e.uncertainty->ratio.name.empty()) s.ratio = e.uncertainty->ratio;
  }
  s.nrmse_percent = 100.0 * e.quality.nrmse;
  s.baseline_nrmse_percent = 100.0 * e.quality.baseline_nrmse;
  s.tidal_volume_measured_ml = ml_per_m3 * e.quality.tidal_volume_m3;
  if (const auto& breath = fit.measurement().breath) {
    s.breaths_used = breath->breaths_used;
    s.breaths_rejected = breath->breaths_rejected;
  }
  if (!outcome.breaths.empty()) s.median_latency_ms = 1e3 * median_latency_s(outcome.breaths);
  for (const Prediction& p : outcome.predictions) s.predictions.push_back(summary_of(p));
  s.verdict = outcome.results.verdict;
  s.simulated = e.simulated;
  return s;
}

Json to_json(const Estimate& e) {
  return {{"value", json_number(e.value)},
          {"unit", e.unit},
          {"stderr", json_number(e.stderr_)},
          {"lower95", json_number(e.lower95)},
          {"upper95", json_number(e.upper95)},
          {"naive_lower95", json_number(e.naive95.lower)},
          {"naive_upper95", json_number(e.naive95.upper)},
          {"identifiable", e.identifiable},
          {"at_bound", e.at_bound}};
}

Json to_json(const FitResult& r) {
  const auto text = [](const std::string& words) { return words.empty() ? Json(nullptr) : Json(words); };
  Json json = {{"value", json_number(r.value)},     {"unit", r.unit},
               {"lower95", json_number(r.lower95)}, {"upper95", json_number(r.upper95)},
               {"grade", name_of(r.grade)},         {"assumption", text(r.assumption)},
               {"reason", text(r.reason)},          {"meaning", r.meaning}};
  if (r.shares.empty()) return json;
  json["shares"] = Json::object();
  for (const Share& s : r.shares) json["shares"][s.source] = s.part;
  return json;
}

Json to_json(const FitSummary& s) {
  Json json{{"status", s.status}, {"grade", name_of(s.grade)}, {"headline", s.headline}, {"gates", s.gates}};
  json["results"] = Json::object();
  for (const FitResult& r : s.results) json["results"][r.name] = to_json(r);
  json["parameters"] = Json::object();
  for (const Estimate& p : s.parameters) json["parameters"][p.name] = to_json(p);
  if (s.ratio) json["ratio"] = to_json(*s.ratio);
  json["nrmse_percent"] = json_number(s.nrmse_percent);
  json["baseline_nrmse_percent"] = json_number(s.baseline_nrmse_percent);
  json["tidal_volume_measured_ml"] = json_number(s.tidal_volume_measured_ml);
  json["breaths_used"] = s.breaths_used;
  json["breaths_rejected"] = s.breaths_rejected;
  if (s.median_latency_ms) json["median_latency_ms"] = *s.median_latency_ms;
  for (const PredictionSummary& p : s.predictions) json["predictions"][p.name] = to_json(p);
  json["verdict"] = s.verdict;
  json["simulated"] = s.simulated;
  return json;
}

FitSummary summary_from_json(const Json& json) {
  FitSummary s;
  s.status = json.at("status").get<std::string>();
  s.grade = grade_from(json.at("grade").get<std::string>());
  s.headline = json.at("headline").get<std::vector<std::string>>();
  s.gates = json.at("gates").get<std::vector<std::string>>();
  for (const auto& [name, result] : json.at("results").items())
    s.results.push_back(result_from(name, result));
  for (const auto& [name, estimate] : json.at("parameters").items())
    s.parameters.push_back(estimate_from(name, estimate));
  if (json.contains("ratio")) s.ratio = estimate_from("ratio", json["ratio"]);
  s.nrmse_percent = number_from(json, "nrmse_percent");
  s.baseline_nrmse_percent = number_from(json, "baseline_nrmse_percent");
  s.tidal_volume_measured_ml = number_from(json, "tidal_volume_measured_ml");
  s.breaths_used = json.at("breaths_used").get<int>();
  s.breaths_rejected = json.at("breaths_rejected").get<int>();
  if (json.contains("median_latency_ms")) s.median_latency_ms = number_from(json, "median_latency_ms");
  if (json.contains("predictions"))
    for (const auto& [name, p] : json["predictions"].items())
      s.predictions.push_back(prediction_from(name, p));
  s.verdict = json.at("verdict").get<std::string>();
  s.simulated = json.at("simulated").get<std::size_t>();
  return s;
}

}  // namespace trunk
