#include "surfaces/formats/vtp_arrays.hpp"

#include <fmt/format.h>
#include <lz4.h>
#include <lzma.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "errors/input_error.hpp"
#include "surfaces/formats/numbers.hpp"
#include "surfaces/formats/raw_surface.hpp"
#include "surfaces/formats/words.hpp"
#include "text/message_text.hpp"

namespace trunk {
namespace {

constexpr std::string_view base64_digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Returns up to `most` bytes of base64, which may consist of several padded parts.
std::string from_base64(std::string_view text, std::size_t most) {
  static const std::array<int, 256> value_of = [] {
    std::array<int, 256> values;
    values.fill(-1);
    for (std::size_t i = 0; i < 64; ++i)
      values[static_cast<unsigned char>(base64_digits[i])] = static_cast<int>(i);
    return values;
  }();
  std::string bytes;
  unsigned group = 0;
  int digits = 0, padding = 0;
  for (const char c : text) {
    if (bytes.size() >= most) break;
    const int value = value_of[static_cast<unsigned char>(c)];
    if (value < 0 && c != '=') {
      if (c == ' ' || c == '\t' || c == '\r' || c == '\n') continue;
      break;  // the end of the data
    }
    group = group << 6 | static_cast<unsigned>(std::max(value, 0));
    padding += c == '=';
    if (++digits < 4) continue;
    for (int i = 0; i < 3 - padding; ++i) bytes.push_back(static_cast<char>(group >> (16 - 8 * i) & 0xFF));
    group = 0;
    digits = padding = 0;
  }
  return bytes;
}

/// Returns the data of an array without its elements of information.
std::string text_beside_elements(pugi::xml_node array) {
  std::string text;
  for (const pugi::xml_node child : array.children())
    if (child.type() != pugi::node_element) text += child.value();
  return text;
}

}  // namespace

std::string VtpArrays::Coded::first(std::size_t count) const {
  return raw ? std::string(text.substr(0, count)) : from_base64(text, count);
}

VtpArrays::VtpArrays(const pml::XmlDocument& xml, std::string_view appended, bool appended_raw)
    : xml_(xml), appended_(appended), appended_raw_(appended_raw) {
  const std::string_view order = xml.root().attribute("byte_order").as_string("LittleEndian"),
                         header = xml.root().attribute("header_type").as_string("UInt32"),
                         compressor = xml.root().attribute("compressor").as_string();
  if (order != "LittleEndian" && order != "BigEndian")
    xml.fail(xml.root(), fmt::format("byte_order is {}", excerpt(order)), "LittleEndian or BigEndian",
             "correct it");
  if (header != "UInt32" && header != "UInt64")
    xml.fail(xml.root(), fmt::format("header_type is {}", excerpt(header)), "UInt32 or UInt64", "correct it");
  if (compressor == "vtkZLibDataCompressor")
    packing_ = Packing::zlib;
  else if (compressor == "vtkLZ4DataCompressor")
    packing_ = Packing::lz4;
  else if (compressor == "vtkLZMADataCompressor")
    packing_ = Packing::lzma;
  else if (!compressor.empty())
    xml.fail(xml.root(), fmt::format("compressor {} found", excerpt(compressor)),
             "vtkZLibDataCompressor, vtkLZ4DataCompressor, vtkLZMADataCompressor or none",
             "save the surface with one of these");
  big_endian_ = order == "BigEndian";
  header_bytes_ = header == "UInt32" ? 4 : 8;
}

double VtpArrays::header(pugi::xml_node array, std::string_view decoded, std::size_t index) const {
  if (decoded.size() < (index + 1) * header_bytes_)
    xml_.fail(array, "the data of this array end within their header", "",
              "check that the export was finished");
  return number_at(decoded.data() + index * header_bytes_, {NumberType::Kind::natural, header_bytes_},
                   big_endian_);
}

/// Reads [bytes][data].
std::string VtpArrays::plain_bytes(pugi::xml_node array, const Coded& coded, std::size_t most_bytes) const {
  const double size = header(array, coded.first(header_bytes_), 0);
  if (size > static_cast<double>(most_bytes))
    xml_.fail(array, fmt::format("an array of {} bytes found", size), fmt::format("{} at most", most_bytes),
              "thin the surface");
  const std::string all = coded.first(header_bytes_ + static_cast<std::size_t>(size));
  std::string data = all.substr(std::min(header_bytes_, all.size()));
  if (static_cast<double>(data.size()) != size)
    xml_.fail(array, fmt::format("{} bytes found in this array, but its header names {}", data.size(), size),
              "", "check that the export was finished");
  return data;
}

/// Reads [number of blocks][bytes per block][bytes of the last block, 0: a full one][compressed bytes of each
/// block][blocks].
std::string VtpArrays::unpacked_bytes(pugi::xml_node array, const Coded& coded,
                                      std::size_t most_bytes) const {
  constexpr double most_blocks = 1e6;
  const double count = header(array, coded.first(header_bytes_), 0);
  if (count > most_blocks)
    xml_.fail(array, "an array of more than a million blocks found", "", "save it with larger blocks");
  const auto blocks = static_cast<std::size_t>(count);
  const std::string head = coded.first((3 + blocks) * header_bytes_);
  const double whole = header(array, head, 1), last = blocks > 0 ? header(array, head, 2) : 0.0;
  double packed = 0.0;
  for (std::size_t i = 0; i < blocks; ++i) packed += header(array, head, 3 + i);
  if (packed > static_cast<double>(largest_surface_file))
    xml_.fail(array, "the header of this array names more bytes than there are", "",
              "check that the export was finished");
  const std::string all = coded.first(head.size() + static_cast<std::size_t>(packed));
  if (all.size() < head.size() + static_cast<std::size_t>(packed))
    xml_.fail(array, "the compressed data of this array are cut short", "",
              "check that the export was finished");
  std::string data;
  std::size_t at = head.size();
  for (std::size_t i = 0; i < blocks; ++i) {
    const double size = i + 1 == blocks && last > 0.0 ? last : whole;
    if (size + static_cast<double>(data.size()) > static_cast<double>(most_bytes))
      xml_.fail(array, fmt::format("an array of more than {} bytes found", most_bytes), "",
                "thin the surface");
    const auto bytes = static_cast<std::size_t>(header(array, head, 3 + i));
    data += unpacked_block(array, std::string_view(all).substr(at, bytes), static_cast<std::size_t>(size));
    at += bytes;
  }
  return data;
}

std::string VtpArrays::unpacked_block(pugi::xml_node array, std::string_view packed, std::size_t size) const {
  std::string block(size, '\0');
  auto* const to = reinterpret_cast<std::uint8_t*>(block.data());
  const auto* const from = reinterpret_cast<const std::uint8_t*>(packed.data());
  bool whole = false;
  if (packing_ == Packing::zlib) {
    uLongf length = size;
    whole = uncompress(to, &length, from, packed.size()) == Z_OK && length == size;
  } else if (packing_ == Packing::lz4) {
    whole = LZ4_decompress_safe(packed.data(), block.data(), static_cast<int>(packed.size()),
                                static_cast<int>(size)) == static_cast<int>(size);
  } else {
    std::uint64_t most_memory = 100'000'000;
    std::size_t read = 0, written = 0;
    whole = lzma_stream_buffer_decode(&most_memory, 0, nullptr, from, &read, packed.size(), to, &written,
                                      size) == LZMA_OK &&
            written == size;
  }
  if (!whole)
    xml_.fail(array, "the compressed data of this array are damaged", "", "export the surface again");
  return block;
}

std::string VtpArrays::bytes(pugi::xml_node array, const Coded& coded, std::size_t most_bytes) const {
  return packing_ == Packing::none ? plain_bytes(array, coded, most_bytes)
                                   : unpacked_bytes(array, coded, most_bytes);
}

std::vector<double> VtpArrays::numbers(pugi::xml_node array, std::size_t most) const {
  const std::string_view format = array.attribute("format").as_string("ascii");
  std::vector<double> values;
  if (format == "ascii") {
    const std::string text = text_beside_elements(array);
    Words words(text, "");
    while (!words.at_end()) {
      if (values.size() >= most)
        xml_.fail(array, fmt::format("more than {} numbers found", most), "", "thin the surface");
      try {
        values.push_back(words.number("a number"));
      } catch (const InputError& error) {
        Mistake mistake = error.mistake();
        mistake.at = xml_.place(array);
        throw InputError(std::move(mistake));
      }
    }
    return values;
  }
  const std::string_view named = array.attribute("type").as_string();
  const auto type =
      named == "String" ? std::optional(NumberType{NumberType::Kind::natural, 1}) : number_type(named);
  if (!type)
    xml_.fail(array, fmt::format("an array of type {} found", excerpt(named)),
              "a type of VTK, such as Float32", "correct it");
  std::string data;
  if (format == "binary") {
    const std::string text = text_beside_elements(array);
    data = bytes(array, {text, false}, most * type->bytes);
  } else if (format == "appended") {
    const double offset = static_cast<double>(xml_.index(array, "offset"));
    if (offset >= static_cast<double>(appended_.size()))
      xml_.fail(array, fmt::format("offset {} found in appended data of {} bytes", offset, appended_.size()),
                "", "check that the export was finished");
    data =
        bytes(array, {appended_.substr(static_cast<std::size_t>(offset)), appended_raw_}, most * type->bytes);
  } else {
    xml_.fail(array, fmt::format("format {} found", excerpt(format)), "ascii, binary or appended",
              "export the surface again");
  }
  for (std::size_t at = 0; at + type->bytes <= data.size(); at += type->bytes)
    values.push_back(number_at(data.data() + at, *type, big_endian_));
  return values;
}

std::string VtpArrays::text(pugi::xml_node array) const {
  constexpr std::size_t longest = 10'000;
  std::string text;
  for (const double code : numbers(array, longest)) {
    if (!(code > 0.0 && code < 256.0)) break;
    text += static_cast<char>(static_cast<unsigned char>(code));
  }
  return text;
}

}  // namespace trunk
