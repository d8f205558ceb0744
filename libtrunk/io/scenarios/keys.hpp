#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "anatomy/scenario.hpp"

namespace trunk {

/// One key of a scenario file. The table of keys is the only place that knows their names, units and limits:
/// reading, writing, `--set`, help and messages all go through it.
struct ScenarioKey {
  struct Number {
    std::string_view unit;  // as in the key's name
    double to_si;           // SI value = file value * to_si
    double low, high;       // allowed, in the file's unit
    double& (*field)(Scenario&);
    bool& (*automatic)(Scenario&) = nullptr;  // may be "auto" instead of a number
  };
  struct Integer {
    int low, high;
    int& (*field)(Scenario&);
  };
  struct Choice {
    std::vector<std::string_view> names;
    void (*set)(Scenario&, int);
    int (*get)(const Scenario&);
  };
  struct Switch {
    bool& (*field)(Scenario&);
  };
  struct Text {
    std::string& (*field)(Scenario&);
  };
  struct File {  // relative to the file that names it, or to the working folder; kept absolute
    std::string& (*field)(Scenario&);
  };

  std::string_view path;  // table.key
  std::string_view meaning;
  std::variant<Number, Integer, Choice, Switch, Text, File> kind;
};

std::span<const ScenarioKey> scenario_keys();

/// What a key's value should look like, in words: "a number of mm, 50 to 400".
std::string expectation(const ScenarioKey& key);

/// The unit of a number key as UDUNITS spell it, "N m-1" for N_per_m; "1" for pure numbers and unknown keys.
std::string unit_of_key(std::string_view path);

/// The known path nearest to an unknown one: the same name with another unit, else the fewest edits; empty
/// where nothing is near.
std::string nearest_key(std::string_view unknown);

/// A text in quotes as TOML takes it.
std::string toml_text(std::string_view text);

/// A value in the file's unit, or the name of a choice, as TOML text.
std::string toml_value(const ScenarioKey& key, const Scenario& scenario);

}  // namespace trunk
