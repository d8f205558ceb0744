#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace trunk {

enum class Quantity { time, volume, flow, pressure, length, unknown };

struct Unit {
  std::string name;  ///< as in this program: "L_s", "0.1 L_min"
  Quantity quantity = Quantity::unknown;
  double to_si = 1;  ///< factor to s, m3, m3/s, Pa or m
};

/// Returns the unit of a text that is only a unit, such as "L/s", "[l/min]" or "mL", in any spelling that the
/// vocabulary knows; nothing for any other text. A volume over a time is a flow ("dL/s", "l per hour"). A
/// power of ten before the unit is its factor: "0.1 L/min", "10 mL/s", "1/100 L/s", "1e-3 L", "10^-3 L". One
/// after it ("ml x10"), or with a sign of its own ("x10 ml"), may mean either way and gives nothing.
std::optional<Unit> unit_of(std::string_view text);

/// Returns the unit in lower case with "_" between words, "l_min", as plain_name writes it; without factors.
std::optional<Unit> plain_unit(std::string_view plain);

/// Returns the name of a unit as people write it: "0.1 L/min".
std::string spoken_unit(std::string name);

/// Returns whether a text that is no known unit looks like one, so that it must not be passed over:
/// "gal/min", "ml x10", "%", "psi". Words such as "filtered" or "left" do not.
bool looks_like_unit(std::string_view text);

/// Returns a header in lower case, with "_" for all characters that separate words. Letters are those of
/// ASCII and all bytes of other scripts. Capitals of Latin, Greek and Cyrillic become lower case too.
std::string plain_name(std::string_view header);

}  // namespace trunk
