#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace trunk {

/// Returns the content of a text file as UTF-8 without a byte order mark; utf8_of lists the encodings. Pipes
/// are read too. Throws InputError if the file is missing, a folder, unreadable, empty or longer than
/// `max_bytes`. Throws InputError with the line of the first NUL byte if the file is binary.
std::string read_text_file(const std::filesystem::path& path, std::size_t max_bytes);

/// Returns the unchanged bytes of a file; throws InputError if it is missing, a folder, unreadable, empty or
/// longer than `max_bytes`.
std::string read_file(const std::filesystem::path& path, std::size_t max_bytes);

}  // namespace trunk
