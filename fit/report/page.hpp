#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shape/compare_shape.hpp"

namespace trunk {

/// Returns a self-contained HTML page of one or two results files. It loads no other file, and texts from the
/// files appear only as text. The same files give the same bytes. A measured surface belongs to the first
/// file, which must then be the only one, and a run or a fit. Throws InputError if a file cannot be read, or
/// if one of two files is a sweep.
std::string report_page(const std::vector<std::filesystem::path>& files,
                        const std::optional<ComparedSurface>& compared = {});

}  // namespace trunk
