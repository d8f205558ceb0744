#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace trunk {

/// Returns the content of a text file as UTF-8 without a byte order mark; utf8_of lists the encodings. Pipes
/// are read too. Throws InputError if the file is missing, a folder, unreadable, empty or longer than
/// `max_bytes`. Throws InputError with the line of the first NUL byte if the file is binary.
std::string read_text_file(const std::filesystem::path& path, std::size_t max_bytes);

struct TextOfFile {
  std::string text;
  bool encoding_is_a_guess = false;  ///< letters beyond ASCII may be others
};

/// Does the same for a text in the encoding of this name (see decoded); in that which utf8_of finds if the
/// name is empty. Throws InputError also if there is no such encoding, with the line if a byte is not of it,
/// and if the text is longer than `max_bytes` in UTF-8.
TextOfFile read_text_file_in(const std::string& encoding, const std::filesystem::path& path,
                             std::size_t max_bytes);

/// Returns the unchanged bytes of a file; throws InputError if it is missing, a folder, unreadable, empty or
/// longer than `max_bytes`.
std::string read_file(const std::filesystem::path& path, std::size_t max_bytes);

}  // namespace trunk
