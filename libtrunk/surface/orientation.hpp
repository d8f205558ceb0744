#pragma once

#include <span>
#include <vector>

#include "surface/measured_surface.hpp"

namespace trunk {

/// Returns the number of the connected part of each triangle, from 0. Triangles that share a point are
/// connected.
std::vector<int> connected_parts(std::span<const Triangle> triangles, std::size_t points);

/// Patches of a surface. Within a patch, a path through edges of exactly two triangles joins any two
/// triangles.
struct Patches {
  std::vector<int> number;  // [triangles] number of the patch, from 0
  std::size_t turned = 0;   // the fewest triangles to turn so that neighbours agree
  bool possible = true;     // false: one-sided, like a Moebius strip
};

/// Turns triangles until neighbours within a patch face the same side, whichever that is. Returns the
/// patches.
Patches orient_patches(std::vector<Triangle>& triangles);

/// Turns each patch so that a closed one encloses a positive volume and an open one faces away from its
/// middle. A patch that is too flat for this faces upward (+z).
void face_outward(MeasuredSurface& surface);

}  // namespace trunk
