#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

namespace trunk {

/// Returns the SHA-256 of a text as 64 lower-case hexadecimal digits.
std::string sha256_of_text(std::string_view text);

/// Returns the SHA-256 of the first `most` bytes of a file; throws InputError if the file cannot be read.
std::string sha256_of_file(const std::filesystem::path& path,
                           std::uintmax_t most = std::numeric_limits<std::uintmax_t>::max());

}  // namespace trunk
