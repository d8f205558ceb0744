#pragma once

#include <string>

namespace trunk {

/// A file to write: its path within a folder, and its content.
struct NamedText {
  std::string name, text;
};

}  // namespace trunk
