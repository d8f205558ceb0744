#pragma once

#include <span>
#include <vector>

#include "mesh/surface.hpp"
#include "model/model.hpp"

namespace trunk {

/// The spacing of the regular mesh of which k_elasticity is the stiffness of a particle, m (our choice: about
/// that of the 113-particle template), and the area of a particle in it, m2.
inline constexpr double sheet_spacing = 0.080,
                        sheet_area = 0.8660254037844386 * sheet_spacing * sheet_spacing;

/// Returns the bending stiffness D of the sheet that k_elasticity makes, N m. A ring whose second moment is
/// the same in all directions lies h^2/4 times the curvature off its particle, so that 1/2 D curvature^2 area
/// is 1/2 k (h^2/4)^2 curvature^2.
constexpr double bending_stiffness(double elasticity) noexcept {
  return elasticity * sheet_spacing * sheet_spacing * sheet_spacing * sheet_spacing / (16.0 * sheet_area);
}

/// Makes a shape memory that of a sheet (README.md of this folder): gives each ring its weights, and
/// multiplies each stiffness weight by (A/A_ref)(h_ref/h)^4. triangles: of the surface; rest: [particles] m.
/// => memory. Returns the factors, [particles], 1 off the surface.
std::vector<double> lay_sheet(std::span<const Triangle> triangles, std::span<const Vec3d> rest,
                              ShapeMemory& memory);

/// Stiffens the rings on the border of a clamped area, which see the bending of one side only. The neighbours
/// on the free side are imposed 1/2 d^2 along the normal of that side, with d their distance from the border.
/// The ring takes the stiffness that gives the particle's share of the free area the energy of this bending.
/// Rings with two free sides, or with a clamped line that ends in them, stay. rest: [particles] m; clamped:
/// [particles] true if nothing moves the particle along the normal; border: [particles] whose rings may be
/// stiffened; factor: [particles] as from lay_sheet. => memory
void stiffen_borders(std::span<const Vec3d> rest, const std::vector<bool>& clamped,
                     const std::vector<bool>& border, std::span<const double> factor, ShapeMemory& memory);

}  // namespace trunk
