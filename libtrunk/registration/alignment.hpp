#pragma once

#include "registration/similarity.hpp"
#include "surface/measured_surface.hpp"

namespace trunk {

/// A part of a trunk and the measured surface it is to lie on.
struct SurfacePair {
  std::span<const Vec3d> particles;     // m, of the trunk
  std::span<const Triangle> triangles;  // of the part
  const MeasuredSurface* target;
};

struct NamedPoint {
  Vec3d of_trunk, measured;  // m
};

struct Alignment {
  Similarity similarity;  // takes the trunk to the measured surfaces
  double rms = 0.0;       // m, over the pairs that were kept
  int iterations = 0;
};

/// Turns, scales and shifts a trunk onto measured surfaces: closest points in both directions, the farthest
/// fifth of each left out for what only one of them has (trimmed iterated closest points; Chetverikov 2002,
/// both directions so that the scale is not drawn to 0). It starts from the trunk upright as the axes say,
/// and turned by 25 degrees each way about each axis and their combinations, and keeps the best (our choice:
/// reaches turns of 30 degrees and more). The same on every call.
Alignment align(std::span<const SurfacePair> pairs, std::span<const NamedPoint> landmarks);

}  // namespace trunk
