#pragma once

#include <functional>
#include <optional>
#include <string>

namespace trunk {

/// Runs `work` in a child process without stderr, and returns its result of at most `most_bytes` bytes.
/// Returns nothing if the child crashes, throws, or needs more than 15 s of processor time or 4 GB of memory.
/// A build with AddressSanitizer does not limit the memory.
std::optional<std::string> run_apart(const std::function<std::string()>& work, std::size_t most_bytes);

}  // namespace trunk
