#pragma once

#include <string>
#include <vector>

#include "anatomy/trunk_options.hpp"
#include "math/vec3.hpp"
#include "mesh/surface.hpp"

namespace trunk {

/// A level of the trunk: particles around an ellipse, or one particle on the axis.
/// Angles run from 0 at the subject's right (+x), counter-clockwise seen from above.
struct Level {
  std::string region;
  std::vector<int> particles;
  std::vector<double> angles;  // rad, one a particle; empty for a single particle
};

/// The levels of the 113-particle template from the pelvis up, by name.
struct TemplateMesh {
  std::vector<Vec3d> rest;  // [particles] m
  Level pelvic_floor, pelvis, abdominal_wall_low, abdominal_wall_high, costal_insertion, apposition_middle,
      apposition_top, tendon_border, dome_top, dome_saddle, lung_base, lung_upper, lung_top;
  std::vector<Triangle> abdomen;  // closed, outward: diaphragm, abdominal wall, pelvic floor
  std::vector<Triangle> lung;     // closed, outward: dome and lung wall

  /// The dome's triangles belong to both surfaces.
  std::size_t distinct_triangles() const;

  std::vector<const Level*> levels() const {
    return {&pelvic_floor,
            &pelvis,
            &abdominal_wall_low,
            &abdominal_wall_high,
            &costal_insertion,
            &apposition_middle,
            &apposition_top,
            &tendon_border,
            &dome_top,
            &dome_saddle,
            &lung_base,
            &lung_upper,
            &lung_top};
  }
};

/// Builds the mesh; the height of the lung follows from the end-expiratory volume. Mirror symmetric about
/// x = 0 where both domes are equally high. Throws InputError where the sizes leave no room for the lung.
TemplateMesh make_template_mesh(const TrunkGeometry& geometry);

}  // namespace trunk
