#pragma once

#include <string>

namespace trunk {

/// A file to be: its name within a folder, which may have folders of its own, and all its bytes.
struct NamedText {
  std::string name, text;
};

}  // namespace trunk
