#pragma once

#include "validation/validation_run.hpp"

namespace trunk {

/// What a valid model must keep. A number that is not known (NaN) keeps no bound.
struct Bound {
  std::string name;     // for machines
  std::string meaning;  // for people
  std::string unit;
  double low, high;  // infinite where there is no limit
  std::function<double(const ValidationRun&)> value;
  bool open = false;  // the limits themselves are outside

  bool holds(double value) const;
};

/// Table 1: `healthy` against the experiment and against the published model; `craighero`, the paper's own
/// subject, against the experiment. Paralysis: about half the volume, the paralysed dome rises, the healthy
/// one descends, left mirrors right. And the abdomen keeps its volume.
std::vector<Bound> bounds();

/// A bound with what was found.
struct Judged {
  Bound bound;
  double value;
  bool pass;
};
std::vector<Judged> judged(const ValidationRun& findings);

/// "-1 to 1", "at most -1", "above 0", "below 1".
std::string limits_text(const Bound& bound);

/// One line that says how many bounds do not hold and which, with their values; empty where all hold.
std::string failures_text(std::span<const Judged> results);

}  // namespace trunk
