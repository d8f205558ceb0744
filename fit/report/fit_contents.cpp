#include "math/units.hpp"
#include "report/contents.hpp"

namespace trunk {
namespace {

using Json = Packed::Json;

std::vector<double> in_ml(std::vector<double> volumes_m3) {
  for (double& v : volumes_m3) v *= ml_per_m3;
  return volumes_m3;
}

Json graded_contents(const std::vector<FitRecord::Result>& results) {
  Json list = Json::array();
  for (const FitRecord::Result& r : results)
    list.push_back({{"name", r.name},
                    {"unit", r.unit},
                    {"value", number_or_null(r.value)},
                    {"lower95", number_or_null(r.lower95)},
                    {"upper95", number_or_null(r.upper95)},
                    {"grade", r.grade},
                    {"assumption", r.assumption},
                    {"reason", r.reason},
                    {"meaning", r.rests_on.empty() ? r.meaning : r.meaning + "; it rests on " + r.rests_on},
                    {"headline", r.headline}});
  return list;
}

Json gate_contents(const FitRecord& fit) {
  Json gates = Json::array();
  for (const FitRecord::Gate& gate : fit.gates)
    gates.push_back({{"name", gate.name}, {"sentence", gate.sentence}});
  return gates;
}

Json measured_contents(const FitRecord& fit, Packed& packed) {
  const std::size_t size = fit.measured_time_s.size();
  if (size == 0) return nullptr;
  return {{"time", packed.add(fit.measured_time_s)},
          {"measured", packed_if_any(in_ml(fit.measured_m3), size, "problem/measured", packed)},
          {"sigma", packed_if_any(in_ml(fit.sigma_m3), size, "problem/sigma", packed)}};
}

Json channel_contents(const FitRecord& fit, Packed& packed) {
  Json channels = Json::array();
  const std::size_t size = fit.measured_time_s.size();
  for (const FitRecord::Channel& c : fit.channels)
    channels.push_back({{"name", c.name},
                        {"unit", c.unit},
                        {"meaning", c.meaning},
                        {"measured", packed_if_any(c.measured, size, c.name.c_str(), packed)},
                        {"sigma", packed_if_any(c.sigma, size, c.name.c_str(), packed)},
                        {"model", packed_if_any(c.model, size, c.name.c_str(), packed)}});
  return channels;
}

Json result_contents(const FitRecord& fit, Packed& packed) {
  const std::size_t size = fit.result_time_s.size();
  const auto curve = [&](const std::vector<double>& m3, const char* name) {
    return packed_if_any(in_ml(m3), size, name, packed);
  };
  return {{"verdict", fit.verdict},
          {"grade", fit.grade},
          {"input", fit.input},
          {"gates", gate_contents(fit)},
          {"identifiable", fit.identifiable},
          {"stop_reason", fit.stop_reason},
          {"algorithm", fit.algorithm},
          {"cross_check",
           {{"first", fit.cross_check.first},
            {"second", fit.cross_check.second},
            {"agree", fit.cross_check.agree}}},
          {"notes", fit.notes},
          {"statistics", json_table(fit.statistics)},
          {"time", packed.add(fit.result_time_s)},
          {"dV_fit", curve(fit.dV_fit_m3, "result/dV_fit")},
          {"residual", curve(fit.residual_m3, "result/residual")},
          {"dV_baseline", curve(fit.dV_baseline_m3, "result/dV_baseline")}};
}

Json parameter_contents(const FitRecord& fit) {
  Json list = Json::array();
  for (const FitRecord::Parameter& p : fit.parameters) {
    list.push_back({{"name", p.name},
                    {"unit", p.unit},
                    {"best", number_or_null(p.best)},
                    {"stderr", number_or_null(p.stderr_)},
                    {"lower95", number_or_null(p.lower95)},
                    {"upper95", number_or_null(p.upper95)},
                    {"at_bound", p.at_bound},
                    {"free", p.free},
                    {"beside", p.beside}});
  }
  return list;
}

Json surface_contents(const FitRecord::Surface& s, Packed& packed) {
  if (s.deviance.empty()) return nullptr;
  const auto axis = [&](int i) -> Json {
    return {{"name", s.name[i]},
            {"unit", s.unit[i]},
            {"values", json_list(s.axis[i])},
            {"region95", json_list({s.lower95[i], s.upper95[i]})}};
  };
  return {{"first", axis(0)},
          {"second", axis(1)},
          {"deviance", packed.add(s.deviance)},
          {"threshold95", number_or_null(s.threshold95)},
          {"closed", s.closed}};
}

Json profile_contents(const FitRecord& fit) {
  Json profiles = Json::array();
  for (const FitRecord::Profile& p : fit.profiles)
    profiles.push_back({{"name", p.name},
                        {"unit", p.unit},
                        {"value", json_list(p.value)},
                        {"deviance", json_list(p.deviance)},
                        {"at_bound", p.at_bound},
                        {"interval95", json_list({p.lower95, p.upper95})},
                        {"threshold95", p.threshold95}});
  return profiles;
}

Json breath_contents(const FitRecord& fit) {
  if (fit.breath_status.empty()) return nullptr;
  Json breaths{{"status", fit.breath_status}, {"columns", Json::array()}};
  for (const NamedColumn& c : fit.breaths) {
    std::vector<double> values = c.values;
    values.resize(fit.breath_status.size(), 0.0);
    breaths["columns"].push_back({{"name", c.name}, {"unit", c.unit}, {"values", json_list(values)}});
  }
  return breaths;
}

Json structure_contents(const Structure& s) {
  if (s.empty()) return nullptr;
  Json choices = Json::array();
  for (const Structure::Choice& c : s.choices)
    choices.push_back({{"name", c.name},
                       {"unit", c.unit},
                       {"source", c.source},
                       {"low", number_or_null(c.low)},
                       {"value", number_or_null(c.value)},
                       {"high", number_or_null(c.high)}});
  return {{"choices", choices},
          {"measures", s.measures},
          {"shares", json_list(s.shares)},
          {"left_out", s.left_out}};
}

Json prediction_contents(const FitRecord& fit) {
  Json predictions = Json::array();
  for (const FitRecord::Prediction& p : fit.predictions)
    predictions.push_back({{"name", p.name},
                           {"scenario", p.scenario},
                           {"numbers", json_table(p.numbers)},
                           {"structure", structure_contents(p.structure)}});
  return predictions;
}

}  // namespace

Json fit_contents(const FitRecord& fit, Packed& packed) {
  return {{"measured", measured_contents(fit, packed)},
          {"channels", channel_contents(fit, packed)},
          {"result", result_contents(fit, packed)},
          {"results", graded_contents(fit.results)},
          {"straight", graded_contents(fit.straight)},
          {"straight_nrmse_percent", number_or_null(fit.straight_nrmse_percent)},
          {"parameters", parameter_contents(fit)},
          {"surface", surface_contents(fit.surface, packed)},
          {"profiles", profile_contents(fit)},
          {"objective", packed.add(fit.evaluation_objective)},
          {"breaths", breath_contents(fit)},
          {"predictions", prediction_contents(fit)}};
}

}  // namespace trunk
