#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pml/xml_document.hpp"

/// Private to the surfaces layer: the arrays of a VTK XML file, in any coding.
namespace trunk {

class VtpArrays {
 public:
  /// `appended` is the text after the underscore of AppendedData. Throws InputError if the byte order, the
  /// type of headers or the compressor is not supported.
  VtpArrays(const pml::XmlDocument& xml, std::string_view appended, bool appended_raw);

  /// Returns the numbers of a DataArray; throws InputError if they are damaged or more than `most`.
  std::vector<double> numbers(pugi::xml_node array, std::size_t most) const;
  /// Returns the text of an array of type String up to its first NUL; throws InputError as `numbers` does.
  std::string text(pugi::xml_node array) const;

 private:
  /// Raw bytes, or bytes in base64.
  struct Coded {
    std::string_view text;
    bool raw = false;
    std::string first(std::size_t count) const;  ///< fewer if the text ends before
  };

  std::string bytes(pugi::xml_node array, const Coded& coded, std::size_t most_bytes) const;
  std::string plain_bytes(pugi::xml_node array, const Coded& coded, std::size_t most_bytes) const;
  std::string unpacked_bytes(pugi::xml_node array, const Coded& coded, std::size_t most_bytes) const;
  std::string unpacked_block(pugi::xml_node array, std::string_view packed, std::size_t size) const;
  double header(pugi::xml_node array, std::string_view decoded, std::size_t index) const;

  const pml::XmlDocument& xml_;
  std::string_view appended_;
  bool appended_raw_, big_endian_;
  enum class Packing { none, zlib, lz4, lzma } packing_ = Packing::none;
  std::size_t header_bytes_;
};

}  // namespace trunk
