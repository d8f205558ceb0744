#pragma once

#include <map>

#include "registration/alignment.hpp"
#include "registration/elastic_matching.hpp"
#include "registration/lungs.hpp"
#include "registration/mesh_quality.hpp"
#include "surface/distances.hpp"

namespace trunk {

/// The measurements of a subject at the end of expiration: one surface or more, and what else is known. x
/// right, y forward, z up, m.
struct SubjectMeasurements {
  std::optional<MeasuredSurface> diaphragm, skin, ribs;
  std::vector<MeasuredSurface> lungs;       // closed: one surface, or the right and the left lung
  std::optional<LungSide> lung_side;        // of one lung alone; none: its shape says it
  std::map<std::string, Vec3d> landmarks;   // by the name in TrunkMesh; of one to three particles
  std::optional<double> lung_volume;        // m3
  std::optional<double> apposition_length;  // m
  LowerBorder lower_border = LowerBorder::automatic;
};

/// How well a region lies on its target surface. Distances are empty if the matching has no pairs in that
/// direction.
struct RegionFit {
  std::string target, region;
  std::optional<Distances> to_target;      // from the region's surface, where the target has data
  std::optional<Distances> to_target_all;  // from all of it, also beyond the border of an open target
  std::optional<Distances> from_target;    // from the part of the target that is closest to the region
  double with_data = 0.0;                  // share of the region's area that has data, 0 to 1
};

/// The volumes of lung and abdomen, m3.
struct Volumes {
  double lung = 0.0, abdomen = 0.0;
};

/// The result of `register_trunk`.
struct Registration {
  TrunkMesh mesh;  // in the axes and the origin of the measured surfaces
  Alignment alignment;
  double insertion_covered = 0.0;       // share of the way around with a costal insertion; 0: not searched
  Volumes aligned, matched, final;      // before the matching, after it, and with the wanted lung volume
  double lungs_given = 0.0;             // m3, enclosed by the measured lungs; 0: none
  LungSide lung_side = LungSide::both;  // which lungs are measured
  double lung_stretch = 1.0;            // of the matched lung to the wanted volume
  double apposition_length = 0.0;       // m
  std::optional<double> apposition_wanted;
  bool closed_diaphragm = false;  // the measured diaphragm encloses a volume, so it may be another organ
  bool round_diaphragm = false;   // as deep as it is wide, which no diaphragm is
  bool cut_short = false;         // the diaphragm shows less than a third of the zone of apposition
  int iterations = 0;
  double moved = 0.0;      // m, the largest movement in the last iteration
  bool held_back = false;  // the last iteration was shortened, so that no triangle folds
  MeshQuality quality;
  std::vector<RegionFit> fits;            // for each target first as a whole (region "all")
  std::vector<std::string> extrapolated;  // regions with data for less than half of them
  std::size_t particles_without_data = 0;
  std::vector<std::string> notes;  // how the surfaces were taken, one sentence each
};

/// Registers a trunk to a subject: `align`, then `match`, then the height of the lung from its volume. The
/// result has the connectivity and the names of the trunk. It calls `progress(iteration, of)` before each
/// iteration of the matching. Throws InputError if there is no surface, if a landmark is unknown, if the
/// surface needs another unit or other axes, or if the lung volume leaves no room over the domes.
Registration register_trunk(const TrunkMesh& trunk, const SubjectMeasurements& targets,
                            const std::function<void(int iteration, int of)>& progress);

}  // namespace trunk
