#include "results/read/look.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>

namespace trunk {
namespace {

struct Look {
  std::string_view begin, extension;  // one of them is empty, and the other decides
  std::string_view meaning;
};

constexpr std::array looks = {
    Look{"SQLite format 3", "",
         "the ledger of an unfinished fit; repeat the command of the fit to resume it"},
    Look{"", ".part", "an unfinished file of an interrupted program; it can be deleted"},
    Look{"", ".toml", "TOML, perhaps a scenario or a sweep; `trunk check` reads it"},
    Look{"", ".csv", "a table; `trunk breaths` shows a trace"},
    Look{"<!DOCTYPE html", "", "a web page, perhaps a report"},
    Look{"<!doctype html", "", "a web page, perhaps a report"},
    Look{"<", "", "XML; `trunk simulate` reads PML and LML, ParaView reads VTK files"},
    Look{"MATLAB 5.0", "", "a MATLAB file; `trunk breaths` shows a trace"},
    Look{"CDF", "", "a classic netCDF file of another program"},
    Look{"\x1f\x8b", "", "a compressed file (gzip)"},
    Look{"PK\x03\x04", "", "a ZIP archive"},
    Look{"\x89PNG", "", "a picture (PNG)"},
    Look{"{", "", "JSON"},
};

bool is_text(std::string_view bytes) {
  return std::none_of(bytes.begin(), bytes.end(), [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return (code < 32 && c != '\n' && c != '\r' && c != '\t') || code == 127;
  });
}

}  // namespace

std::string look_of(const std::filesystem::path& path) {
  std::array<char, 512> first{};
  std::ifstream file(path, std::ios::binary);
  file.read(first.data(), first.size());
  const std::string_view bytes(first.data(), static_cast<std::size_t>(file.gcount()));
  for (const Look& look : looks)
    if (look.begin.empty() ? path.extension() == look.extension : bytes.starts_with(look.begin))
      return std::string(look.meaning);
  return is_text(bytes) ? "text" : "an unknown format, or a file that is damaged in its first bytes";
}

}  // namespace trunk
