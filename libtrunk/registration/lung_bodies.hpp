#pragma once

#include "surface/voxels.hpp"

namespace trunk {

/// The cubes of lungs, and to which of two bodies each belongs.
struct Bodies {
  Voxels solid;
  std::vector<int> body;  // [cells] 0 or 1 of two bodies, by increasing x; all 0 if there is one; -1 empty
  int count = 1;
  std::size_t dropped = 0;  // cells of thin parts between the bodies
};

/// Returns the cubes that lungs fill, and their two bodies if they are apart. Gaps of two cubes, as fissures
/// are, are closed. Two bodies are what is left if everything thinner than a windpipe is taken away, and the
/// smaller has a fifth of the larger one. What is thin and lies half-way between them is dropped.
Bodies bodies_of(const MeasuredSurface& lungs);

}  // namespace trunk
