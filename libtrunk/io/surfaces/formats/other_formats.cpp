#include "surfaces/formats/other_formats.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <memory>
#include <string_view>

#include "errors/input_error.hpp"
#include "surfaces/formats/raw_surface.hpp"

namespace trunk {
namespace {

using namespace std::string_view_literals;

constexpr const char* from_labels =
    "make a surface of its labels and save that as STL or OBJ (3D Slicer: Segmentations, Export to files; "
    "ITK-SNAP: Export as Surface Mesh)";
constexpr const char* from_contours =
    "load it in 3D Slicer (SlicerRT), and export the segment as STL or OBJ (Segmentations, Export to files)";
constexpr const char* save_mesh = "open it in MeshLab or Blender and save it as STL, OBJ or PLY";
constexpr const char* from_cad = "save it as STL in the program that made it (FreeCAD reads it, too)";

/// A format by the bytes at a place of the file.
struct Signature {
  std::size_t at;
  std::string_view bytes;
  const char* format;
  const char* way_out;
};

constexpr Signature signatures[] = {
    {0, "NRRD0"sv, "an image or a label map (NRRD)", from_labels},
    {344, "n+1\0"sv, "an image or a label map (NIfTI)", from_labels},
    {344, "ni1\0"sv, "an image or a label map (NIfTI)", from_labels},
    {0, "\x5C\x01\0\0"sv, "an image or a label map (NIfTI or Analyze)", from_labels},
    {0, "\0\0\x01\x5C"sv, "an image or a label map (NIfTI or Analyze)", from_labels},
    {0, "\x1C\x02\0\0n+2\0"sv, "an image or a label map (NIfTI)", from_labels},
    {0, "ObjectType = Image"sv, "an image or a label map (MetaImage)", from_labels},
    {0, "NDims = "sv, "an image or a label map (MetaImage)", from_labels},
    {128, "DICM"sv, "a DICOM file: an image, contours (RTSTRUCT) or a segmentation", from_contours},
    {0, "glTF"sv, "a scene (GLB)", save_mesh},
    {0, "Kaydara FBX"sv, "a scene (FBX)", save_mesh},
    {0, "BLENDER"sv, "a scene of Blender", "open it in Blender and export STL, OBJ or PLY"},
    {0, "#VRML"sv, "a scene (VRML)", save_mesh},
    {0, "#X3D"sv, "a scene (X3D)", save_mesh},
    {0, "#Inventor"sv, "a scene (Open Inventor)", save_mesh},
    {0, "# AmiraMesh"sv, "a file of Amira", "save the surface as STL or OBJ in Amira"},
    {0, "# HyperSurface"sv, "a surface of Amira", "save the surface as STL or OBJ in Amira"},
    {0, "ISO-10303-21"sv, "a CAD model (STEP)", from_cad},
    {0, "OFF"sv, "a mesh (OFF)", save_mesh},
    {0, "COFF"sv, "a mesh (OFF)", save_mesh},
    {0, "$MeshFormat"sv, "a mesh of Gmsh", "export it as STL in Gmsh"},
    {0, "\xFF\xFF\xFE"sv, "a surface of FreeSurfer", "convert it (mris_convert SURFACE surface.stl)"},
    {0, "\x89HDF\r\n"sv, "an HDF5 file", "save the surface alone as STL, OBJ, PLY or VTP"},
    {0, "MATLAB 5.0 MAT-file"sv, "a MAT file", "write the triangulation with stlwrite in MATLAB"},
    {0, "\x93NUMPY"sv, "an array of NumPy",
     "save the mesh as STL or PLY (for example with trimesh or PyVista)"},
    {0, "Rar!"sv, "an archive", "unpack it"},
    {0, "7z\xBC\xAF"sv, "an archive", "unpack it"},
    {0, "BZh"sv, "a file packed with bzip2", "unpack it"},
    {0,
     "\xFD"
     "7zXZ"sv,
     "a file packed with xz", "unpack it"},
    {0, "\x28\xB5\x2F\xFD"sv, "a file packed with zstd", "unpack it"},
    {0, "%PDF"sv, "a PDF", "give the surface itself"},
    {0, "\x89PNG"sv, "a picture", "give the surface itself"},
    {0, "\xFF\xD8\xFF"sv, "a picture", "give the surface itself"}};

/// The same by a word near the beginning of a text.
struct Word {
  const char* word;
  const char* format;
  const char* way_out;
};

constexpr Word words_of_xml[] = {
    {"<COLLADA", "a scene (COLLADA)", save_mesh},
    {"<X3D", "a scene (X3D)", save_mesh},
    {"<GIFTI", "a surface of GIFTI", "convert it to STL (for example with nibabel)"},
    {"<AMF", "a mesh (AMF)", save_mesh},
    {"<amf", "a mesh (AMF)", save_mesh}};
constexpr Word words_of_zip[] = {{"3D/3dmodel.model", "a model for printing (3MF)", save_mesh},
                                 {"", "a ZIP archive", "unpack it and give the surface"}};

[[noreturn]] void refuse(const std::string& file, const char* format, const char* way_out) {
  throw InputError({file}, fmt::format("{} found", format),
                   "a surface of triangles in STL, OBJ, PLY, VTK, VTP, VTU or PML", way_out);
}

template <std::size_t count>
void refuse_words(std::string_view head, const Word (&words)[count], const std::string& file) {
  for (const auto& [word, format, way_out] : words)
    if (head.find(word) != std::string_view::npos) refuse(file, format, way_out);
}

}  // namespace

std::string gunzipped(const std::string& bytes, const std::string& file) {
  constexpr int with_gzip_header = 16 + MAX_WBITS;
  z_stream stream{};
  if (inflateInit2(&stream, with_gzip_header) != Z_OK) throw InputError({file}, "zlib cannot start");
  const std::unique_ptr<z_stream, int (*)(z_stream*)> end_of(&stream, inflateEnd);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));  // zlib does not write there
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string content;
  for (int outcome = Z_OK; outcome != Z_STREAM_END;) {
    const std::size_t before = content.size();
    if (before > largest_surface_file)
      throw InputError({file}, "a packed file that holds too much",
                       fmt::format("at most {} MB", largest_surface_file / 1'000'000), "thin the surface");
    content.resize(before + std::max<std::size_t>(before, 1'000'000));
    stream.next_out = reinterpret_cast<Bytef*>(content.data() + before);
    stream.avail_out = static_cast<uInt>(content.size() - before);
    outcome = inflate(&stream, Z_NO_FLUSH);
    content.resize(content.size() - stream.avail_out);
    if (outcome != Z_OK && outcome != Z_STREAM_END)
      throw InputError({file}, "the packed data (gzip) are damaged or cut short", "",
                       "export or copy it again");
  }
  return content;
}

void refuse_other_formats(const std::string& bytes, const std::string& file) {
  const std::string_view all = bytes;
  for (const Signature& s : signatures)
    if (all.size() > s.at && all.substr(s.at).starts_with(s.bytes)) refuse(file, s.format, s.way_out);
  const std::string_view head = all.substr(0, 4000);
  if (all.starts_with("PK\x03\x04")) refuse_words(head, words_of_zip, file);
  const std::size_t first = head.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return;
  if (head[first] == '<') refuse_words(head, words_of_xml, file);
  if (head[first] == '{') {
    if (head.find("\"asset\"") != std::string_view::npos) refuse(file, "a scene (glTF)", save_mesh);
    refuse(file, "a JSON file", "save the surface as STL, OBJ or PLY");
  }
}

}  // namespace trunk
