#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace trunk {

/// Which samples of a recording a trace has.
struct UsedSamples {
  std::size_t first = 0;            ///< how many at the beginning were left out
  std::vector<std::uint32_t> rows;  ///< which of the recording are left, before that; empty: all
  std::vector<double> all_time_s;   ///< of all of them; empty if `rows` is

  /// Returns `count` of the samples of another channel.
  std::vector<double> of(const std::vector<double>& channel, std::size_t count) const {
    std::vector<double> samples(count);
    for (std::size_t i = 0; i < count; ++i) samples[i] = channel[rows.empty() ? first + i : rows[first + i]];
    return samples;
  }
};

}  // namespace trunk
