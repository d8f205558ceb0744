#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "surface/measured_surface.hpp"

namespace trunk {

/// How the axes of a file lie in the trunk, whose own are x right, y forward, z up (RAS).
class Axes {
 public:
  /// RAS: as the trunk's.
  Axes() = default;

  /// Three letters, one of R/L, A/P and S/I each: the side of the subject to which x, y and z of the file
  /// grow, in any order ("LPS": x to the left, y backward, z up). Or three coordinates of the file that are
  /// the trunk's right, forward and up: "x,-z,y". Case does not matter. Throws InputError.
  explicit Axes(std::string_view text);

  Vec3d operator()(const Vec3d& of_file) const;
  /// True where right-handed coordinates become left-handed: the surface is mirrored.
  bool mirrors() const;
  /// As letters: "LPS".
  std::string letters() const;

 private:
  std::array<std::size_t, 3> source_{0, 1, 2};  // the file's axis, for each of the trunk's
  std::array<double, 3> sign_{1.0, 1.0, 1.0};
};

/// Axes guessed from the shape of an open dome, and how.
struct GuessedAxes {
  Axes axes;
  std::string reasons;       // for a note
  bool front_known = false;  // else front and back, and with them left and right, were taken as they come
};

/// What the shape of a diaphragm tells, in axes of the file: up is where its dome points, lateral where it is
/// wider, and its border is higher in front than at the back; left and right, which a symmetric surface
/// cannot tell, follow from that and from right-handed axes. Expects an oriented surface that faces away from
/// its middle. Nothing for a surface that is no open dome.
std::optional<GuessedAxes> guess_axes(const MeasuredSurface& dome);

}  // namespace trunk
