#pragma once

#include <string>
#include <string_view>

#include "pml/loads.hpp"

namespace trunk::pml {

/// Reads an LML text in UTF-8. `file` is named in messages. Loads inside comments are not read; declarations
/// of namespaces and schemas are not kept. Throws InputError with a line for malformed XML, another
/// namespace, unknown elements, attributes, types and units, a load without appliedTo, valueEvent or
/// direction, non-finite numbers, dates that do not increase, ranges that are reversed or list more than ten
/// million atoms, texts longer than 100 MB.
Loads read_lml(std::string_view text, const std::string& file);

}  // namespace trunk::pml
