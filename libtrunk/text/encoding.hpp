#pragma once

#include <string>

namespace trunk {

/// Bytes of a text file => UTF-8 without byte order mark. UTF-16 is known by its mark, or by the zero bytes
/// that every other byte of plain words and numbers then is; what is not valid UTF-8 is taken as
/// Windows-1252, which holds ISO 8859-1 (our choice: what spreadsheets and loggers of western Europe write).
std::string utf8_of(std::string bytes);

}  // namespace trunk
