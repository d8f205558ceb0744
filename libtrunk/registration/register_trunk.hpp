#pragma once

#include <map>

#include "registration/alignment.hpp"
#include "registration/elastic_matching.hpp"
#include "registration/mesh_quality.hpp"
#include "surface/distances.hpp"

namespace trunk {

/// What is known of a subject at the end of expiration; each is optional, one surface at least is not. x
/// right, y forward, z up, m.
struct SubjectMeasurements {
  std::optional<MeasuredSurface> diaphragm, skin, ribs;
  std::vector<MeasuredSurface> lungs;       // closed: one, or the right and the left
  std::map<std::string, Vec3d> landmarks;   // of TrunkMesh, of one to three particles
  std::optional<double> lung_volume;        // m3
  std::optional<double> apposition_length;  // m
  LowerBorder lower_border = LowerBorder::automatic;
};

/// How well a region lies on its target. None where the matching draws the other way only, or has nothing.
struct RegionFit {
  std::string target, region;
  std::optional<Distances> to_target;      // of the region's surface, where the target has data
  std::optional<Distances> to_target_all;  // of all of it, also what lies beyond the border of an open target
  std::optional<Distances> from_target;    // of the part of the target that is closest to the region
  double with_data = 0.0;                  // part of the region's area that has data, 0 to 1
};

/// Lung and abdomen, m3.
struct Volumes {
  double lung = 0.0, abdomen = 0.0;
};

struct Registration {
  TrunkMesh mesh;  // in the axes and the origin of the measured surfaces
  Alignment alignment;
  double insertion_covered =
      0.0;  // part of the way around on which the costal insertion was found; 0: not looked for
  Volumes aligned, matched, final;  // before the matching, after it, and with the volume wanted
  double lungs_given = 0.0;         // m3, enclosed by the lungs that were given; 0 without
  double apposition_length = 0.0;   // m
  std::optional<double> apposition_wanted;
  bool closed_diaphragm =
      false;  // the surface given as one encloses a volume: it is no sheet, perhaps no diaphragm
  int iterations = 0;
  double moved = 0.0;  // m, the farthest in the last iteration
  bool held_back = false;
  MeshQuality quality;
  std::vector<RegionFit> fits;            // of each target as a whole (region "all") first
  std::vector<std::string> extrapolated;  // regions of which less than half has data
  std::size_t particles_without_data = 0;
};

/// Registers a trunk to a subject: `align`, then `match`, then the lung's height by its volume. The result
/// has the connectivity and the names of the trunk it came from. Throws InputError without a surface, on
/// landmarks it does not know, and where the lung volume leaves no room over the domes.
Registration register_trunk(const TrunkMesh& trunk, const SubjectMeasurements& targets,
                            const std::function<void(int iteration, int of)>& progress);

}  // namespace trunk
