#pragma once

#include <functional>
#include <optional>
#include <string>

namespace trunk {

/// Runs `work` in a child process, without its stderr, and returns its result: bytes, at most `most_bytes`.
/// Nothing where it crashed, threw, or took more than 15 s of processor time or 4 GB of memory (which is
/// not bounded in a build with AddressSanitizer).
std::optional<std::string> run_apart(const std::function<std::string()>& work, std::size_t most_bytes);

}  // namespace trunk
