#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "recordings/matlab/mat_variables.hpp"

namespace trunk {

/// The variables of a MAT-file that LabChart (ADInstruments) exports: one vector `data` holds all channels of
/// all blocks one after the other, and datastart, dataend, samplerate and unittextmap, [channels][blocks],
/// say where each is and what it is.
class LabChartVariables {
 public:
  struct Channel {
    std::string name, unit;
    double rate_hz = 0;
    std::size_t first = 0, count = 0;  ///< in `data`
  };

  /// Returns nothing if the content is not of this kind or does not fit together.
  static std::optional<LabChartVariables> in(const MatContent& content);

  const MatVariable& data() const { return *data_; }
  std::size_t blocks() const { return starts_->columns; }
  /// Returns the length of a block, from 0, in s: that of its longest channel.
  double length_s(std::size_t block) const;
  /// Returns the channels of a block that have samples.
  std::vector<Channel> channels(std::size_t block) const;

 private:
  const MatVariable *data_ = nullptr, *starts_ = nullptr, *ends_ = nullptr, *rates_ = nullptr;
  const MatVariable *titles_ = nullptr, *units_ = nullptr, *unit_map_ = nullptr;  // may be missing
};

}  // namespace trunk
