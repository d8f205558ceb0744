#pragma once

#include <string>

namespace trunk {

/// Returns the bytes of a text file as UTF-8 without a byte order mark. UTF-16 is recognised by its mark, or
/// by its zero bytes: in plain words and numbers, every second byte of UTF-16 is zero. Bytes that are not
/// valid UTF-8 are read as Windows-1252, which includes ISO 8859-1. This is our choice, because spreadsheets
/// and loggers of western Europe write it.
std::string utf8_of(std::string bytes);

}  // namespace trunk
