#pragma once

// Catch2 of version 2 or 3, whichever tests/CMakeLists.txt found. The tests use the names below for both.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif

#include <string>

using Catch::Matchers::EndsWith, Catch::Matchers::StartsWith;

#if __has_include(<catch2/catch_all.hpp>)
using Catch::Approx;

/// Returns a matcher for texts that have `part` in them; version 3 gives this name to a matcher for ranges.
inline auto Contains(const std::string& part) {
  return Catch::Matchers::ContainsSubstring(part);
}
#else
using Catch::Matchers::Contains;
#endif
