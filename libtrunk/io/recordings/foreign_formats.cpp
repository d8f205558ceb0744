#include "recordings/foreign_formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "errors/input_error.hpp"

namespace trunk {
namespace {

using namespace std::string_view_literals;

struct ForeignFormat {
  std::string_view sign;  // what the file begins with, or its extension
  std::string_view what, remedy;
};

constexpr auto as_csv = "save the sheet as CSV"sv, numbers = "export the numbers as CSV"sv,
               as_text = "export the signals as text (CSV)"sv;

constexpr std::array formats{
    ForeignFormat{"PK\x03\x04"sv, "a spreadsheet (.xlsx, .ods) or another zip archive", as_csv},
    ForeignFormat{"\xD0\xCF\x11\xE0"sv, "an old spreadsheet (.xls)", as_csv},
    ForeignFormat{"<?xml"sv, "XML, perhaps a spreadsheet", as_csv},
    ForeignFormat{"<html"sv, "a web page, perhaps a spreadsheet that was named .xls", as_csv},
    ForeignFormat{"<HTML"sv, "a web page, perhaps a spreadsheet that was named .xls", as_csv},
    ForeignFormat{"<!DOCTYPE"sv, "a web page, perhaps a spreadsheet that was named .xls", as_csv},
    ForeignFormat{"<!doctype"sv, "a web page, perhaps a spreadsheet that was named .xls", as_csv},
    ForeignFormat{"<table"sv, "a web page, perhaps a spreadsheet that was named .xls", as_csv},
    ForeignFormat{"{\\rtf"sv, "a text document (RTF)", numbers},
    ForeignFormat{"%PDF"sv, "a PDF", "export the numbers"},
    ForeignFormat{"{\""sv, "JSON", numbers},
    ForeignFormat{"{\n"sv, "JSON", numbers},
    ForeignFormat{"{\r"sv, "JSON", numbers},
    ForeignFormat{"[{"sv, "JSON", numbers},
    ForeignFormat{"[["sv, "JSON", numbers},
    ForeignFormat{"\x1F\x8B"sv, "a file compressed by gzip", "unpack it with gunzip"},
    ForeignFormat{"BZh"sv, "a file compressed by bzip2", "unpack it with bunzip2"},
    ForeignFormat{"\xFD"
                  "7zXZ"sv,
                  "a file compressed by xz", "unpack it with unxz"},
    ForeignFormat{"\x28\xB5\x2F\xFD"sv, "a file compressed by zstd", "unpack it with unzstd"},
    ForeignFormat{"7z\xBC\xAF"sv, "an archive (.7z)", "unpack it"},
    ForeignFormat{"Rar!"sv, "an archive (.rar)", "unpack it"},
    ForeignFormat{"\x89HDF"sv, "a binary file (HDF5, like results of trunk)", "give the recording"},
    ForeignFormat{"CDF\x01"sv, "a netCDF file", numbers},
    ForeignFormat{"CDF\x02"sv, "a netCDF file", numbers},
    ForeignFormat{"\x93NUMPY"sv, "a NumPy array (.npy)", "save it with numpy.savetxt"},
    ForeignFormat{"PAR1"sv, "a Parquet table", "save it as CSV, as with pandas' to_csv"},
    ForeignFormat{"ARROW1"sv, "a Feather or Arrow table", "save it as CSV, as with pandas' to_csv"},
    ForeignFormat{"SQLite format 3"sv, "a database (SQLite)", numbers},
    ForeignFormat{"RDX"sv, "data of R", "save them with write.csv"},
    ForeignFormat{"$FL2"sv, "data of SPSS (.sav)", "save them as CSV"},
    ForeignFormat{"CFWB"sv, "a binary file of LabChart", "export it from LabChart as text"},
    ForeignFormat{"ABF2"sv, "a binary file of pCLAMP (.abf)", as_text},
    ForeignFormat{"TDSm"sv, "a binary file of LabVIEW (.tdms)", as_text},
    ForeignFormat{"GDF "sv, "a GDF file", "convert it to EDF or BDF"},
    ForeignFormat{"XDF:"sv, "an XDF file of LabStreamingLayer", as_text},
    ForeignFormat{"RIFF"sv, "a sound file (.wav)", as_text},
    ForeignFormat{"Brain Vision Data Exchange Header"sv, "the header of a BrainVision recording",
                  "export the recording as EDF or text"},
};

// Formats without a sign at the beginning.
constexpr std::array extensions{
    ForeignFormat{".acq"sv, "a binary file of AcqKnowledge",
                  "save it from AcqKnowledge as text or as MATLAB"},
    ForeignFormat{".adicht"sv, "a binary file of LabChart", "export it from LabChart as text"},
    ForeignFormat{".adibin"sv, "a binary file of LabChart", "export it from LabChart as text"},
    ForeignFormat{".smr"sv, "a binary file of Spike2", "export it from Spike2 as text or as MATLAB"},
    ForeignFormat{".smrx"sv, "a binary file of Spike2", "export it from Spike2 as text or as MATLAB"},
    ForeignFormat{".abf"sv, "a binary file of pCLAMP", as_text},
    ForeignFormat{".c3d"sv, "a file of motion capture (C3D)", as_text},
    ForeignFormat{".dcm"sv, "a DICOM file", as_text},
    ForeignFormat{".dat"sv, "a binary file", as_text},
    ForeignFormat{".bin"sv, "a binary file", as_text},
};

[[noreturn]] void refuse(const std::filesystem::path& path, const ForeignFormat& format) {
  throw InputError({path.string()}, fmt::format("this is {}", format.what), "text, MATLAB, EDF or BDF",
                   std::string(format.remedy));
}

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 0x20);
  return extension;
}

// UTF-16 has a mark, or zeros at every second place.
bool is_binary(std::string_view start) {
  if (start.starts_with("\xFF\xFE"sv) || start.starts_with("\xFE\xFF"sv)) return false;
  return start.find("\0\0"sv) != std::string_view::npos;
}

}  // namespace

void require_no_foreign_format(const std::filesystem::path& path, std::string_view start) {
  if (is_binary(start))
    for (const ForeignFormat& format : extensions)
      if (lower_extension(path) == format.sign) refuse(path, format);
  std::string_view text = start.starts_with("\xEF\xBB\xBF"sv) ? start.substr(3) : start;
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  for (const ForeignFormat& format : formats)
    if (text.starts_with(format.sign)) refuse(path, format);
}

}  // namespace trunk
