#pragma once

#include <string>

/// Private to the surfaces layer: files that are packed, and files that are no surfaces that we read.
namespace trunk {

/// Returns the content of a file that gzip packed; throws InputError if it is damaged or longer than the
/// largest surface.
std::string gunzipped(const std::string& bytes, const std::string& file);

/// Throws InputError if the file has a format that is known but not read. The error names the format and the
/// way out.
void refuse_other_formats(const std::string& bytes, const std::string& file);

}  // namespace trunk
