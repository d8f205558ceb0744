#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "support/catch.hpp"

namespace trunk::test {

/// Returns the path of a file of the shared data. The test that asks for it is tagged [shared]: CTest shows
/// those tests as skipped if the shared data are absent, and runs them otherwise.
inline std::filesystem::path shared_file(const std::string& name) {
  const auto path = std::filesystem::path(TRUNK_SHARED_DATA) / name;
  INFO("the shared data lack " << path);
  REQUIRE(std::filesystem::is_regular_file(path));
  return path;
}

/// Returns the bytes of a surface file of the shared data.
inline std::string shared_surface(const std::string& name) {
  std::ifstream file(shared_file("surfaces/" + name), std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace trunk::test
