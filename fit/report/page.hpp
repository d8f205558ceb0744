#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "shape/compare_shape.hpp"

namespace trunk {

/// One self-contained HTML page of one or two results files: it loads nothing, and shows texts of the files
/// as texts only. The same files give the same bytes. Throws InputError as reading the files does, and where
/// two files cannot stand side by side. A measured surface goes with the first file, a run or fit alone.
std::string report_page(const std::vector<std::filesystem::path>& files,
                        const std::optional<ComparedSurface>& beside = {});

}  // namespace trunk
