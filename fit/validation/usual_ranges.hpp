#pragma once

#include <span>

#include "validation/validation_run.hpp"

namespace trunk {

/// A number that only a breath with a lung has, and its range in quiet breathing of healthy adults.
struct UsualRange {
  std::string_view measure;  // in `simulate --json`
  std::string_view title;    // at the head of a printed table
  std::string_view unit;
  double low, high;
  std::string_view source;
  double ValidatedBreath::*value;
};
std::span<const UsualRange> usual_ranges();

}  // namespace trunk
