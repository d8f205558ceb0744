#include "subject/structure_json.hpp"

#include <algorithm>

namespace trunk {

Json shares_json(const Structure& s, const std::string& measure) {
  const auto at = std::find(s.measures.begin(), s.measures.end(), measure);
  if (at == s.measures.end() || s.choices.empty()) return nullptr;
  const double* row = s.shares.data() + static_cast<std::size_t>(at - s.measures.begin()) * s.choices.size();
  if (!std::isfinite(*row)) return nullptr;
  Json shares = Json::object();
  for (std::size_t i = 0; i < s.choices.size(); ++i) shares[s.choices[i].name] = row[i];
  return shares;
}

void add_choices(const Structure& s, Json& json) {
  if (s.empty()) return;
  Json& choices = json["structural_choices"] = Json::array();
  for (const Structure::Choice& c : s.choices)
    choices.push_back({{"name", c.name},
                       {"keys", c.keys},
                       {"unit", c.unit},
                       {"low", json_number(c.low)},
                       {"value", json_number(c.value)},
                       {"high", json_number(c.high)},
                       {"source", c.source}});
  json["structural_notes"] = s.left_out;
}

Structure structure_from(const Json& json) {
  Structure s;
  if (!json.contains("structural_choices")) return s;
  for (const Json& c : json["structural_choices"])
    s.choices.push_back({c.at("name").get<std::string>(), c.at("keys").get<std::string>(),
                         c.at("unit").get<std::string>(), c.at("source").get<std::string>(),
                         c.at("low").get<double>(), c.at("value").get<double>(), c.at("high").get<double>()});
  s.left_out = json.at("structural_notes").get<std::vector<std::string>>();
  for (const auto& [name, number] : json.items()) {
    if (!number.is_object() || !number.contains("structural_shares")) continue;
    s.measures.push_back(name);
    const Json& shares = number["structural_shares"];
    for (const Structure::Choice& c : s.choices)
      s.shares.push_back(shares.is_null() ? std::nan("") : shares.at(c.name).get<double>());
  }
  return s;
}

}  // namespace trunk
