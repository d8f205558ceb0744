#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace trunk {

/// SHA-256 of a text, 64 lower-case hexadecimal digits.
std::string sha256_of_text(std::string_view text);

/// SHA-256 of the bytes of a file. Throws InputError when it cannot be read.
std::string sha256_of_file(const std::filesystem::path& path);

}  // namespace trunk
