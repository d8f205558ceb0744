#pragma once

#include <string>
#include <string_view>

namespace trunk {

/// Returns the bytes of a text file as UTF-8 without a byte order mark. UTF-16 is recognised by its mark, or
/// by its zero bytes: in plain words and numbers, every second byte of UTF-16 is zero. Bytes that are not
/// valid UTF-8 are read as Windows-1252, which includes ISO 8859-1. This is our choice, because spreadsheets
/// and loggers of western Europe write it.
std::string utf8_of(std::string bytes);

/// Returns whether utf8_of reads these bytes as Windows-1252, because nothing shows their encoding.
bool encoding_is_a_guess(std::string_view bytes);

}  // namespace trunk
