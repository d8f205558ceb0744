#pragma once

#include <string>
#include <vector>

#include "surface/orientation.hpp"

namespace trunk {

/// What was found in a surface and done about it.
struct RepairReport {
  std::size_t points_read = 0, triangles_read = 0;
  std::size_t merged_points = 0;    // as near as the tolerance to another
  std::size_t isolated_points = 0;  // of no triangle
  std::size_t degenerate = 0;       // triangles dropped: two corners in one point
  std::size_t duplicates = 0;       // triangles dropped: the same corners as another
  std::size_t slivers = 0;  // triangles flatter than the tolerance; kept, dropping them opens the surface
  std::size_t turned = 0;   // triangles turned over so that neighbours agree
  std::size_t specks = 0;   // pieces dropped that are tiny beside the rest
  std::size_t sheet_triangles = 0;  // of the other side and rim of a two-sided sheet, dropped
  double sheet_share = 0.0;         // of the area, with another sheet close by
  double sheet_thickness = 0.0;     // median, in the unit of the points
  std::size_t pieces = 0;
  std::size_t borders = 0;          // loops of edges of one triangle: 0 for a closed surface
  std::size_t branching_edges = 0;  // of three or more triangles
  bool oriented = true;             // false: one-sided somewhere, as a Moebius strip is

  bool closed() const { return borders == 0 && branching_edges == 0; }
  bool two_sided() const { return sheet_triangles > 0; }
};

/// Merges points nearer than 1e-5 of the largest extent, drops what is degenerate or there twice, what is in
/// no triangle and specks of less than 0.5 % of the area (unless more than 5 % would go), makes neighbours
/// agree in orientation, takes the mid-surface of a two-sided sheet. In any unit and axes; at the end the
/// surface faces away from its middle, see face_outward. (all tolerances: our choice)
RepairReport repair(MeasuredSurface& surface);

/// The largest extent along an axis of the points in triangles.
double largest_extent(const MeasuredSurface& surface);

/// The smallest over the largest standard deviation of the points along the axes of their spread: 0 where
/// all lie in a plane.
double flatness(const MeasuredSurface& surface);

}  // namespace trunk
