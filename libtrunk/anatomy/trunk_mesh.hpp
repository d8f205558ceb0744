#pragma once

#include <map>
#include <string>
#include <vector>

#include "errors/input_error.hpp"
#include "math/vec3.hpp"
#include "mesh/surface.hpp"

namespace trunk {

/// Particles by name.
using Regions = std::map<std::string, std::vector<int>>;

/// Where a trunk's particles lie and what they are, whatever they came from: the template, or a file.
///
/// `regions` divide the particles: pelvis, abdominal_wall, costal_insertion, zone_of_apposition,
/// muscular_dome, central_tendon, lung_wall, lung_top. `landmarks` overlap: fixed (what does not move),
/// spine, apposition_middle, apposition_top and dome_top_right, dome_top_left (what is measured),
/// tendon_border, dome_saddle, and the right and left halves of the rib cage and of the zone of apposition.
struct TrunkMesh {
  std::vector<Vec3d> rest;        // [particles] m
  std::vector<Triangle> abdomen;  // closed, outward: diaphragm, abdominal wall, pelvic floor
  std::vector<Triangle> lung;     // closed, outward: dome and lung wall; the dome's triangles are in both
  Regions regions, landmarks;
  /// Around the trunk, each from the costal insertion up the zone of apposition to the border of the central
  /// tendon. All have as many particles.
  std::vector<std::vector<int>> muscle_lines;
  double fineness = 1.0;  // particles along a length, over those of the 113-particle template

  /// What a file says of single particles, over the scenario's tissue; NaN or an absent entry: nothing.
  struct Given {
    std::vector<double> mass;       // [particles] kg
    std::vector<double> stiffness;  // [particles] of the healthy tissue, times k_elasticity
    std::vector<double> damping;    // [particles] times the damping coefficient
    double fibre_strength = 0.0;    // of every healthy fibre, times k_muscle; 0: nothing
  } given;

  /// Triangles counted once, though the dome's belong to both surfaces.
  std::size_t distinct_triangles() const;

  /// The particles of a region or landmark; none where there is no such name.
  const std::vector<int>& named(const std::string& name) const;

  /// Halfway between the rightmost and the leftmost particle of the costal insertion, m.
  double midline() const;

  /// Row of the muscle lines that lies at the top of the zone of apposition.
  std::size_t apposition_top_row() const;
};

/// Particles named as in LML's `appliedTo`: a region or landmark, numbers and ranges as in "0-3,7", or "*"
/// for all. Throws InputError, beginning with `origin`, naming what is known.
std::vector<int> selected_particles(const TrunkMesh& mesh, const std::string& text, const Place& at);

/// Throws InputError unless the anatomy is there that measures, fibres and ribs need: muscle lines of one
/// length that pass the top of the zone of apposition in one row, dome tops on both sides, every index a
/// particle.
void require_anatomy(const TrunkMesh& mesh);

}  // namespace trunk
