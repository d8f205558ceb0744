#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "surface/measured_surface.hpp"

namespace trunk {

/// How the axes of a file lie in the trunk. The trunk's own axes are x right, y forward, z up (RAS).
class Axes {
 public:
  /// The axes of the trunk (RAS).
  Axes() = default;

  /// Reads three letters, one of R/L, A/P and S/I each, in any order. They say to which side of the subject
  /// x, y and z of the file grow ("LPS": x to the left, y backward, z up). Or reads the three coordinates of
  /// the file that are the trunk's right, forward and up ("x,-z,y"). Case does not matter. Throws InputError
  /// for any other text.
  explicit Axes(std::string_view text);

  /// Returns a point of the file in the axes of the trunk.
  Vec3d operator()(const Vec3d& of_file) const;
  /// Returns true if the axes are left-handed, so that they mirror the surface.
  bool mirrors() const;
  /// Returns the axes as letters ("LPS").
  std::string letters() const;

 private:
  std::array<std::size_t, 3> source_{0, 1, 2};  // the file's axis, for each of the trunk's
  std::array<double, 3> sign_{1.0, 1.0, 1.0};
};

/// Axes guessed from the shape of an open dome, and the reasons.
struct GuessedAxes {
  Axes axes;
  std::string reasons;       // for a note
  bool front_known = false;  // false: front and back, and so left and right, are arbitrary
};

/// Where half a dome was cut from the other half.
struct DomeCut {
  double x = 0.0;              // m, of the plane of the cut
  double measured_side = 0.0;  // +1: the half at greater x, the right one, is there; -1: the other one
};

/// Returns the cut if an open dome in the trunk's axes is one half of a diaphragm: it is hardly wider than
/// deep, and a fifth of its border lies at one side, from low to near the top and over half of the depth (our
/// choice).
std::optional<DomeCut> cut_of_half_dome(const MeasuredSurface& dome);

/// Returns the axes that the shape of a diaphragm shows; nothing for a surface that is not an open dome, or
/// only a part of one. The dome points up, it is widest from side to side, and its border is higher in front
/// than at the back. A symmetric surface does not show left and right: both follow from front and up and from
/// right-handed axes. The surface has to be oriented and to face away from its middle.
std::optional<GuessedAxes> guess_axes(const MeasuredSurface& dome);

}  // namespace trunk
