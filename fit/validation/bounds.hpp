#pragma once

#include "validation/validation_run.hpp"

namespace trunk {

/// A bound that a valid model keeps. An unknown number (NaN) keeps no bound.
struct Bound {
  std::string name;     // for machines
  std::string meaning;  // for people
  std::string unit;
  double low, high;  // infinite where there is no limit
  std::function<double(const ValidationRun&)> value;
  bool open = false;  // true: the limits themselves do not pass

  bool holds(double value) const;
};

/// Returns all bounds. Table 1: `healthy` is compared with the experiment and with the published model, and
/// `craighero`, the paper's own subject, with the experiment. Paralysis: the volume is about half, the
/// paralysed dome rises, the healthy one descends, and left mirrors right. The abdomen keeps its volume. If
/// `healthy` has a lung, its pressures and its recoil time are usual ones.
std::vector<Bound> bounds(const ValidationRun& findings);

/// A bound, the value found, and whether it passes.
struct Judged {
  Bound bound;
  double value;
  bool pass;
};
/// Returns every bound with its value.
std::vector<Judged> judged(const ValidationRun& findings);

/// Returns the limits in words: "-1 to 1", "at most -1", "above 0" or "below 1".
std::string limits_text(const Bound& bound);

/// Returns one line with the number of bounds that do not hold, their names and values; "" if all hold.
std::string failures_text(std::span<const Judged> results);

}  // namespace trunk
