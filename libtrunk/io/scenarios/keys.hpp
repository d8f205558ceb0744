#pragma once

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "anatomy/scenario.hpp"

namespace trunk {

/// One key of a scenario file. The table of keys is the only place that holds their names, units and limits.
/// Reading, writing, `--set`, help and messages all use it.
struct ScenarioKey {
  struct Number {
    std::string_view unit;  // as in the key's name
    double to_si;           // SI value = file value * to_si
    double low, high;       // allowed, in the file's unit
    double& (*field)(Scenario&);
    bool& (*automatic)(Scenario&) = nullptr;  // set if the key may be "auto"
  };
  struct Course {  // a number that stays, or a list of [time in s, number] pairs; 0 before the first
    std::string_view unit;
    double to_si;
    double low, high;
    PiecewiseLinear& (*field)(Scenario&);
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
  struct File {  // relative to the file that names it, or to the working folder; stored as an absolute path
    std::string& (*field)(Scenario&);
  };

  std::string_view path;  // table.key
  std::string_view meaning;
  std::variant<Number, Course, Integer, Choice, Switch, Text, File> kind;
  bool (*left_out)(const Scenario&) = nullptr;  // true: the writer leaves out the key; no function: never
  void (*when_read)(Scenario&) = nullptr;       // called after a value was read
};

std::span<const ScenarioKey> scenario_keys();

/// Returns the expected value of a key in words: "a number of mm, 50 to 400".
std::string expectation(const ScenarioKey& key);

/// Returns the unit of a key as UDUNITS spells it: "N m-1" for N_per_m, "1" for pure numbers and unknown
/// keys.
std::string unit_of_key(std::string_view path);

/// Returns the known path that is most similar to an unknown one: the same name with another unit, or else
/// the path with the smallest edit distance. Returns "" if no path is similar.
std::string nearest_key(std::string_view unknown);

/// Returns a course as a TOML list of [time in s, value] pairs, the values over `to_si`.
std::string toml_events(const PiecewiseLinear& course, double to_si);

/// Returns a text as a quoted TOML string.
std::string toml_text(std::string_view text);

/// Returns the value of a key as TOML, in the unit of the key; a choice as its name.
std::string toml_value(const ScenarioKey& key, const Scenario& scenario);

}  // namespace trunk
