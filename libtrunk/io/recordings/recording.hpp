#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "errors/input_error.hpp"

namespace trunk {

/// What a file says of one recorded quantity.
struct Channel {
  std::string name;    ///< as in the file; its number, from 1, where the file names none
  std::string unit;    ///< where the file gives it apart from the name; else empty
  double rate_hz = 0;  ///< samples a second; 0: the file does not say
};

/// Samples of chosen channels, as they are in the file.
struct Samples {
  struct Flaw {
    std::size_t sample;
    Mistake mistake;  ///< why it has no number
  };
  std::vector<std::vector<double>> values;  ///< [chosen][samples]; NaN where there is no number
  std::vector<std::uint32_t> lines;         ///< [samples] from 1; empty where the file has no lines
  std::vector<Flaw> flaws;                  ///< why there is no number, by sample; may be incomplete
};

/// A file that holds channels: the one form in which traces of all formats are read. Nothing in it is
/// trusted: values may be NaN, names may be any bytes.
class Recording {
 public:
  static constexpr std::size_t max_samples = 10'000'000;  ///< a channel

  virtual ~Recording() = default;

  /// The samples of some channels, all of one length. Throws InputError.
  virtual Samples read(std::span<const std::size_t> chosen) = 0;

  std::string source;             ///< file name, for messages
  std::string word = "column";    ///< what the format calls a channel
  std::size_t header_line = 0;    ///< where the channels are named; 0: the format has no lines
  std::string first_cell;         ///< of a table without header; empty: the channels are named
  std::vector<Channel> channels;  ///< at least one
};

}  // namespace trunk
