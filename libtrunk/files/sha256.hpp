#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

namespace trunk {

/// SHA-256 of a text, 64 lower-case hexadecimal digits.
std::string sha256_of_text(std::string_view text);

/// SHA-256 of the bytes of a file, or of the first `most` of them. Throws InputError when it cannot be read.
std::string sha256_of_file(const std::filesystem::path& path,
                           std::uintmax_t most = std::numeric_limits<std::uintmax_t>::max());

}  // namespace trunk
