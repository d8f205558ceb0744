#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace trunk {

/// The content of a text file as UTF-8 without byte order mark, see utf8_of for the encodings.
/// Works on pipes too. Throws InputError when the file is missing, a directory, unreadable, empty, longer
/// than `max_bytes`, or binary (holds NUL bytes: then with the line of the first one).
std::string read_text_file(const std::filesystem::path& path, std::size_t max_bytes);

/// The bytes of a file as they are. Throws InputError when the file is missing, a directory, unreadable,
/// empty or longer than `max_bytes`.
std::string read_file(const std::filesystem::path& path, std::size_t max_bytes);

}  // namespace trunk
