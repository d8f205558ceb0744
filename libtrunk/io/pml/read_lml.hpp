#pragma once

#include <string>
#include <string_view>

#include "pml/loads.hpp"

namespace trunk::pml {

/// Returns the loads of an LML text in UTF-8. Messages name `file`. Loads inside comments are not read, and
/// declarations of namespaces and schemas are not kept. Throws InputError with a line for malformed XML,
/// another namespace, unknown elements, attributes, types and units, a load without appliedTo, valueEvent or
/// direction, numbers that are not finite, dates that do not increase, reversed ranges, loads that list more
/// than ten million atoms, and texts longer than 100 MB.
Loads read_lml(std::string_view text, const std::string& file);

}  // namespace trunk::pml
