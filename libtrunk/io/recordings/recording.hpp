#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "errors/input_error.hpp"

namespace trunk {

/// The description of one recorded quantity in a file.
struct Channel {
  std::string name;         ///< as in the file; a number from 1 if the file has no names
  std::string unit;         ///< if the file gives it separately from the name; else empty
  double rate_hz = 0;       ///< samples per second; 0: the file does not say it
  std::size_t samples = 0;  ///< how many there are; 0: as many as of all other channels
  bool is_clock = false;    ///< its cells are clock times, given in s since the first one
};

/// Samples of chosen channels, in the units of the file.
struct Samples {
  struct Flaw {
    std::size_t sample;
    Mistake mistake;  ///< why the sample has no number
  };
  std::vector<std::vector<double>> values;  ///< [chosen][samples]; NaN if there is no number
  std::vector<std::uint32_t> lines;         ///< [samples] from 1; empty if the file has no lines
  std::vector<Flaw> flaws;                  ///< in the order of samples; may be incomplete
};

/// A file with channels: the common form of recordings in all formats. Nothing in it is checked: values may
/// be NaN, and names may be any bytes.
class Recording {
 public:
  static constexpr std::size_t max_samples = 10'000'000;  ///< of one channel

  virtual ~Recording() = default;

  /// Returns the samples of some channels, which all have the same number; throws InputError if they cannot
  /// be read.
  virtual Samples read(std::span<const std::size_t> chosen) = 0;

  std::string source;           ///< file name, for messages
  std::string word = "column";  ///< the name that the format has for a channel
  std::size_t header_line = 0;  ///< the line that names the channels; 0: the format has no lines
  std::string first_cell;  ///< the first number of a table without header; empty: the channels have names
  std::vector<Channel> channels;   ///< at least one
  std::vector<std::string> notes;  ///< messages for the user; complete once samples were read
  std::string if_missing;  ///< what the user may try if a channel is not found; empty: nothing special
};

}  // namespace trunk
