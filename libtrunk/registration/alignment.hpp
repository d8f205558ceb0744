#pragma once

#include "registration/similarity.hpp"
#include "surface/measured_surface.hpp"

namespace trunk {

/// A part of a trunk, and the measured surface on which it should lie.
struct SurfacePair {
  std::span<const Vec3d> particles;     // m, of the trunk
  std::span<const Triangle> triangles;  // of the part
  const MeasuredSurface* target;
};

/// A landmark in both.
struct NamedPoint {
  Vec3d of_trunk, measured;  // m
};

/// The result of `align`.
struct Alignment {
  Similarity similarity;  // takes the trunk to the measured surfaces
  double rms = 0.0;       // m, over the pairs that count
  int iterations = 0;
};

/// Returns the similarity that turns, scales and shifts a trunk onto measured surfaces; it is the same on
/// every call. The method is trimmed iterated closest points (Chetverikov 2002): the farthest fifth of the
/// pairs is left out, for what only one of the surfaces has. Closest points count in both directions, so that
/// the scale does not shrink to 0. The search starts from the trunk upright, as the axes say, and from turns
/// by 25 degrees each way about each axis and their combinations. The best result counts (our choice: this
/// reaches turns of 30 degrees and more).
Alignment align(std::span<const SurfacePair> pairs, std::span<const NamedPoint> landmarks);

/// Returns the same for surfaces whose axes are known and whose shape hardly shows a tilt, such as a pair of
/// lungs. The search starts from the trunk upright, and each turn costs as if a tenth of its squared movement
/// were added to the squared distances (our choice). What lies beyond the border of an open surface does not
/// count.
Alignment align_upright(std::span<const SurfacePair> pairs, std::span<const NamedPoint> landmarks);

}  // namespace trunk
