#pragma once

#include <map>
#include <string>
#include <vector>

#include "errors/input_error.hpp"
#include "math/vec3.hpp"
#include "mesh/surface.hpp"

namespace trunk {

/// Particles by the name of their region.
using Regions = std::map<std::string, std::vector<int>>;

/// The particles of a trunk and their anatomy, from the template or from a file.
///
/// Each particle is in one of the `regions`: pelvis, abdominal_wall, costal_insertion, zone_of_apposition,
/// muscular_dome, central_tendon, lung_wall, lung_top. `landmarks` may overlap: fixed (particles that do not
/// move), spine, apposition_middle, apposition_top, dome_top_right and dome_top_left (for measures),
/// tendon_border, dome_saddle, and the right and left halves of the rib cage and of the zone of apposition.
struct TrunkMesh {
  std::vector<Vec3d> rest;        // [particles] m
  std::vector<Triangle> abdomen;  // closed, outward: diaphragm, abdominal wall, pelvic floor
  std::vector<Triangle> lung;     // closed, outward: dome and lung wall; the dome's triangles are in both
  Regions regions, landmarks;
  /// The muscle lines, in their order around the trunk. Each runs from the costal insertion up the zone of
  /// apposition to the border of the central tendon, and all have the same number of particles.
  std::vector<std::vector<int>> muscle_lines;
  double fineness = 1.0;  // particles along a length, relative to the 113-particle template

  /// Values of single particles from a file, which come before the scenario's tissue; NaN or no entry: not
  /// given.
  struct Given {
    std::vector<double> mass;       // [particles] kg
    std::vector<double> stiffness;  // [particles] healthy, times k_elasticity
    std::vector<double> damping;    // [particles] times the damping coefficient
    double fibre_strength = 0.0;    // of every healthy fibre, times k_muscle; 0: not given
  } given;

  /// Returns the number of triangles; those of the dome are in both surfaces and count once.
  std::size_t distinct_triangles() const;

  /// Returns the particles of a region or landmark; none if there is no such name.
  const std::vector<int>& named(const std::string& name) const;

  /// Returns the x halfway between the rightmost and the leftmost particle of the costal insertion, m.
  double midline() const;

  /// Returns the row of the muscle lines at the top of the zone of apposition.
  std::size_t apposition_top_row() const;
};

/// Returns the particles that a text selects, as in LML's `appliedTo`: a region or landmark, numbers and
/// ranges as in "0-3,7", or "*" for all. Throws InputError at the given place, with all known names, if a
/// name or number is unknown.
std::vector<int> selected_particles(const TrunkMesh& mesh, const std::string& text, const Place& at);

/// Throws InputError unless the mesh has the anatomy that measures, fibres and ribs need: all regions and
/// landmarks, muscle lines of one length that pass the top of the zone of apposition in one row, axes that
/// are right, forward and up, and only indices of particles.
void require_anatomy(const TrunkMesh& mesh);

}  // namespace trunk
