#include "subject/clinic_json.hpp"

#include <cmath>

#include "math/units.hpp"

namespace trunk {

Json clinic_json(const std::vector<ClinicNumber>& numbers) {
  Json json = Json::object();
  for (const ClinicNumber& n : numbers)
    json[n.name] = {{"value", json_number(n.mean)},
                    {"unit", n.unit},
                    {"lower95", json_number(n.lower95)},
                    {"upper95", json_number(n.upper95)},
                    {"of_mean_breath", json_number(n.of_mean_breath)},
                    {"meaning", n.meaning},
                    {"doubt", n.doubt.empty() ? Json(nullptr) : Json(n.doubt)}};
  return json;
}

Json clinic_json_of(const std::vector<ClinicNumber>& numbers, std::size_t used) {
  Json json = Json::object();
  for (const ClinicNumber& n : numbers) json[n.name] = json_number(n.each[used]);
  return json;
}

Json channels_json(const Segmentation& s) {
  Json json = Json::object();
  for (const TraceChannel& channel : s.channels)
    json[std::string(option_of(channel.kind))] = {{"column", channel.column}, {"unit", channel.unit}};
  if (s.excursion_m) json["excursion"] = {{"value", mm_per_m * *s.excursion_m}, {"unit", "mm"}};
  return json;
}

std::vector<FitResult> clinic_results(const std::vector<ClinicNumber>& numbers) {
  std::vector<FitResult> results;
  for (const ClinicNumber& n : numbers) {
    const std::string reason =
        std::isfinite(n.lower95) ? n.doubt : "one breath does not show the spread from breath to breath";
    results.push_back({n.name, n.unit, n.mean, n.lower95, n.upper95,
                       reason.empty() ? Grade::determined : Grade::not_determined, "", reason, n.meaning});
  }
  return results;
}

}  // namespace trunk
