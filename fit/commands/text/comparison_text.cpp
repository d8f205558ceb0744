#include "commands/text/comparison_text.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>

namespace trunk {

Json comparison_json(const Comparison& comparison) {
  Json json{{"same", comparison.same()},
            {"compared", comparison.compared},
            {"farthest_m", comparison.farthest_m},
            {"differences", Json::array()}};
  for (const Difference& d : comparison.differences) {
    Json one{{"group", d.group}, {"name", d.name}};
    if (d.note.empty()) {
      one["unit"] = d.unit;
      one["first"] = json_number(d.first);
      one["second"] = json_number(d.second);
      if (d.time_s) one["time_s"] = *d.time_s;
    } else {
      one["note"] = d.note;
    }
    json["differences"].push_back(std::move(one));
  }
  return json;
}

std::string comparison_table(const Comparison& comparison) {
  std::string text;
  for (const Difference& d : comparison.differences) {
    const std::string name = d.group + " " + d.name;
    if (!d.note.empty()) {
      text += fmt::format("  {:<44} {}\n", name, d.note);
      continue;
    }
    text += fmt::format("  {:<44} {:>14} {:>14} {:>+12.3g} {}{}\n", name, shown(d.first, "{:.8g}"),
                        shown(d.second, "{:.8g}"), d.second - d.first, d.unit == "1" ? "" : d.unit,
                        d.time_s ? fmt::format(" at {:.4g} s", *d.time_s) : "");
  }
  return text;
}

void add_tolerance_options(CLI::App& command, Tolerance& tolerance) {
  // CLI11's own range lets NaN through.
  const auto not_negative = [](const std::string& text) {
    double value = -1.0;
    return CLI::detail::lexical_cast(text, value) && value >= 0.0 && std::isfinite(value)
               ? ""
               : "'" + text + "' found; expected a number, 0 or more";
  };
  command
      .add_option("--tolerance", tolerance.relative,
                  "Takes two numbers as equal if they differ by at most this part of the larger one. [1e-6]")
      ->type_name("PART")
      ->check(not_negative);
  command
      .add_option("--absolute", tolerance.absolute,
                  "Also takes them as equal if they differ by at most this, in their own unit. [1e-9]")
      ->type_name("NUMBER")
      ->check(not_negative);
}

}  // namespace trunk
