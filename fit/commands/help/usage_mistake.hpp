#pragma once

#include "errors/input_error.hpp"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace trunk {

/// Returns what is wrong with a command line that CLI11 refuses. A word that nobody knows goes first, because
/// CLI11 may complain about what the misspelt word leaves missing.
Mistake usage_mistake(const CLI::App& program, const CLI::ParseError& error);

/// Returns "unknown KIND 'WORD'" with the nearest of the names, or with all of them if none is near.
Mistake unknown_word(const std::string& kind, const std::string& word, const std::vector<std::string>& names);

}  // namespace trunk
