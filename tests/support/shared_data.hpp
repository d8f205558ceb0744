#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "support/catch.hpp"

namespace trunk::test {

/// A surface file of the shared data; empty with a warning when it is not there.
inline std::string shared_surface(const std::string& name) {
  const auto path = std::filesystem::path(TRUNK_SHARED_DATA) / "surfaces" / name;
  std::ifstream file(path, std::ios::binary);
  if (!file) WARN("skipped: no " << path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace trunk::test
