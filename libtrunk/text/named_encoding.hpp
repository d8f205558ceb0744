#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace trunk {

/// A text as UTF-8 without a byte order mark, or why there is none.
struct Decoded {
  std::string text;
  bool known_name = true;               ///< false: no such encoding
  bool too_long = false;                ///< the text has more bytes than allowed
  std::optional<std::size_t> bad_byte;  ///< the first byte that is not of the encoding
};

/// Decodes a text in the encoding of this name, such as "Shift_JIS", "GB18030" or "windows-1251", by iconv.
/// `iconv -l` lists the names. The text has at most `most_bytes` bytes.
Decoded decoded(std::string_view bytes, const std::string& encoding, std::size_t most_bytes);

}  // namespace trunk
