#pragma once

#include "results/records.hpp"
#include "subject/json.hpp"

namespace trunk {

/// Returns the share of each choice in the structural interval of a number, by the name of the choice; null
/// if no choice changes the number.
Json shares_json(const Structure& structure, const std::string& measure);

/// Adds the choices with their ranges, as structural_choices, and what was left out, as structural_notes;
/// nothing if there is no structure. => json
void add_choices(const Structure& structure, Json& json);

/// Returns the choices in what add_choices made, with shares of the numbers in `json` that have some. Throws
/// nlohmann::json::exception if a key is absent or has another type.
Structure structure_from(const Json& json);

}  // namespace trunk
