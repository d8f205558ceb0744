#include "recordings/open_recording.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <string>
#include <string_view>

#include "files/read_file.hpp"
#include "recordings/edf/edf_recording.hpp"
#include "recordings/matlab/matlab_recording.hpp"
#include "recordings/text_recording.hpp"

namespace trunk {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t largest_text = 200'000'000;

struct ForeignFormat {
  std::string_view start, what, remedy;
};

constexpr std::array foreign_formats{
    ForeignFormat{"PK\x03\x04"sv, "a spreadsheet (.xlsx, .ods) or another zip archive",
                  "save the sheet as CSV"},
    ForeignFormat{"\xD0\xCF\x11\xE0"sv, "an old spreadsheet (.xls)", "save the sheet as CSV"},
    ForeignFormat{"\x1F\x8B"sv, "a file compressed by gzip", "unpack it with gunzip"},
    ForeignFormat{"\x89HDF"sv, "a binary file (HDF5, like results of trunk)", "give the recording"},
    ForeignFormat{"%PDF"sv, "a PDF", "export the numbers"}};

// Returns the first bytes of a file; "" for a pipe, which can be read only once.
std::string start_of(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return {};
  std::string start(512, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  return start;
}

}  // namespace

std::unique_ptr<Recording> open_recording(const std::filesystem::path& path) {
  const std::string start = start_of(path);
  if (is_matlab(start)) return open_matlab(path);
  if (is_edf(start)) return open_edf(path);
  for (const ForeignFormat& format : foreign_formats)
    if (start.starts_with(format.start))
      throw InputError({path.string()}, fmt::format("this is {}", format.what), "text, MATLAB, EDF or BDF",
                       std::string(format.remedy));
  return recording_of_text(path.string(), read_text_file(path, largest_text));
}

}  // namespace trunk
