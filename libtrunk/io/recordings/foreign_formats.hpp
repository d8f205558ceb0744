#pragma once

#include <filesystem>
#include <string_view>

namespace trunk {

/// Throws InputError if a file that begins with these bytes has a format that is known and not read: a
/// spreadsheet, an archive, a document, or the own format of a program that records. The error names the
/// format and the way out. The name of the file counts only if the bytes are binary.
void require_no_foreign_format(const std::filesystem::path& path, std::string_view start);

}  // namespace trunk
