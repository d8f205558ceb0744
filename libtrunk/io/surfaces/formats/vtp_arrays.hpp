#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "pml/xml_document.hpp"

/// Private to the surfaces layer: the arrays of a VTK XML file, however they are coded.
namespace trunk {

class VtpArrays {
 public:
  /// `appended` is what follows the underscore of AppendedData. Throws InputError for a byte order, header
  /// type or compressor that is not read.
  VtpArrays(const pml::XmlDocument& xml, std::string_view appended, bool appended_raw);

  /// The numbers of a DataArray, `most` at most. Throws InputError.
  std::vector<double> numbers(pugi::xml_node array, std::size_t most) const;

 private:
  /// Bytes as they are, or in base64.
  struct Coded {
    std::string_view text;
    bool raw = false;
    std::string first(std::size_t count) const;  ///< fewer where there are no more
  };

  std::string bytes(pugi::xml_node array, const Coded& coded, std::size_t most_bytes) const;
  std::string plain_bytes(pugi::xml_node array, const Coded& coded, std::size_t most_bytes) const;
  std::string inflated_bytes(pugi::xml_node array, const Coded& coded, std::size_t most_bytes) const;
  std::string inflated_block(pugi::xml_node array, std::string_view packed, std::size_t size) const;
  double header(pugi::xml_node array, std::string_view decoded, std::size_t index) const;

  const pml::XmlDocument& xml_;
  std::string_view appended_;
  bool appended_raw_, big_endian_, compressed_;
  std::size_t header_bytes_;
};

}  // namespace trunk
