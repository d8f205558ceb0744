#pragma once

#include <string_view>
#include <vector>

namespace trunk {

/// A page of the documentation, as `trunk help TOPIC` prints it.
struct Topic {
  std::string_view name, summary;
  std::string_view page;  ///< Markdown
};

/// Returns all topics, in the order in which a new user reads them. fit/embed.cmake has their table.
const std::vector<Topic>& topics();

}  // namespace trunk
