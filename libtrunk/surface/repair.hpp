#pragma once

#include <string>
#include <vector>

#include "surface/orientation.hpp"

namespace trunk {

/// What repair() found in a surface and changed.
struct RepairReport {
  std::size_t points_read = 0, triangles_read = 0;
  std::size_t merged_points = 0;    // points within the tolerance of another one
  std::size_t isolated_points = 0;  // points without triangles
  std::size_t degenerate = 0;       // triangles dropped: two corners in one point
  std::size_t duplicates = 0;       // triangles dropped: the same corners as another
  std::size_t slivers = 0;          // triangles flatter than the tolerance; kept, else the surface had holes
  std::size_t turned = 0;           // triangles turned over so that neighbours agree
  std::size_t specks = 0;           // pieces dropped since they are tiny beside the rest
  std::size_t islands = 0;          // small pieces dropped since they are far from the rest
  double island_distance = 0.0;     // of the nearest of these, in the unit of the points
  std::size_t sheet_triangles = 0;  // triangles dropped from the other side and the rim of a two-sided sheet
  double sheet_share = 0.0;         // share of the area that has another sheet close by
  double sheet_thickness = 0.0;     // median, in the unit of the points
  std::size_t pieces = 0;
  std::size_t borders = 0;          // loops of edges that belong to one triangle; 0: closed
  std::size_t branching_edges = 0;  // edges of three or more triangles
  bool oriented = true;             // false: somewhere one-sided, like a Moebius strip

  bool closed() const { return borders == 0 && branching_edges == 0; }
  bool two_sided() const { return sheet_triangles > 0; }
};

/// Repairs a surface, in any unit and axes, and returns what it did (all tolerances are our choice):
///  - merges points that are nearer than 1e-5 of the largest extent,
///  - drops degenerate and duplicate triangles, points without triangles, and specks of less than 0.5 % of
///    the area (unless more than 5 % of the area would go),
///  - drops islands: pieces of less than 10 % of the area that are farther from the largest piece than a
///  fifth
///    of its extent,
///  - turns triangles so that neighbours agree, and the surface so that it faces as face_outward says,
///  - takes the middle of a two-sided sheet.
RepairReport repair(MeasuredSurface& surface);

/// Returns the largest extent of the triangles along an axis.
double largest_extent(const MeasuredSurface& surface);

/// Returns the smallest standard deviation of the points along their principal axes, divided by the largest;
/// 0 if all lie in a plane.
double flatness(const MeasuredSurface& surface);

}  // namespace trunk
