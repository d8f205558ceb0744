#include "registration/register_trunk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "errors/input_error.hpp"
#include "math/units.hpp"
#include "mesh/volume.hpp"
#include "registration/line_goals.hpp"
#include "registration/region_fits.hpp"
#include "registration/target_surface.hpp"
#include "registration/trunk_parts.hpp"
#include "surface/axes.hpp"

namespace trunk {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// One half of a part: what was measured of it, and which triangles of the trunk it shows.
struct Half {
  MeasuredSurface surface;
  std::vector<Triangle> part;
};

/// A measured surface, the part of the trunk that it shows, and how it attracts that part. If only one half
/// was measured, the surface is that half with its mirror image.
struct Shown {
  MeasuredSurface surface;
  std::vector<Triangle> part;
  Attraction::Direction direction;
  Attraction::Facing facing;
  std::optional<Half> measured;  // none: all of it
};

std::vector<Shown> shown_by(const TrunkMesh& trunk, const SubjectMeasurements& targets,
                            const std::optional<DomeCut>& cut, const std::optional<LungSurface>& lungs) {
  using Direction = Attraction::Direction;
  using Facing = Attraction::Facing;
  std::vector<Shown> shown;
  const auto add = [&](const MeasuredSurface& surface, const char* name, std::vector<Triangle> part,
                       Direction direction, Facing facing) {
    shown.push_back({surface, std::move(part), direction, facing, {}});
    shown.back().surface.name = name;
  };
  // Completes the last one, of which only the half at greater (+1) or smaller x was measured.
  const auto mirror_at = [&](double x, double sign) {
    Shown& half = shown.back();
    half.measured = Half{half.surface, side_of(trunk, half.part, sign)};
    half.surface = with_mirror_image(half.surface, x);
  };
  if (targets.diaphragm)
    add(*targets.diaphragm, "diaphragm", diaphragm_of(trunk), Direction::both, Facing::any);
  if (cut) mirror_at(cut->x, cut->measured_side);
  if (lungs) add(lungs->outer, "lungs", trunk.lung, Direction::both, Facing::alike);
  if (lungs && lungs->side != LungSide::both)
    mirror_at(lungs->middle, lungs->side == LungSide::right ? 1.0 : -1.0);
  if (targets.skin)
    add(*targets.skin, "skin", abdominal_wall_of(trunk), Direction::part_to_target, Facing::alike);
  if (targets.ribs)
    add(*targets.ribs, "ribs", rib_side_of(trunk), Direction::target_to_part, Facing::opposed);
  if (shown.empty())
    throw InputError({}, "there is no surface to register to", "a diaphragm, lungs, skin or ribs");
  return shown;
}

/// Returns an actuator that pulls the particles of a landmark, with equal weights.
LinearActuator landmark_actuator(const TrunkMesh& trunk, const std::string& name, const Vec3d& place) {
  constexpr double as_of_a_surface = 0.02;
  const std::vector<int>& particles = trunk.named(name);
  if (particles.empty() || particles.size() > 3) {
    std::string known;
    for (const auto& [landmark, its] : trunk.landmarks)
      if (!its.empty() && its.size() <= 3) known += (known.empty() ? "" : ", ") + landmark;
    throw InputError({}, fmt::format("landmark '{}' has {} particles", name, particles.size()),
                     fmt::format("one of 1 to 3 particles: lung_top, {}", known));
  }
  LinearActuator actuator{{particles[0], particles[0], particles[0]}, {}, place, as_of_a_surface};
  for (std::size_t k = 0; k < particles.size(); ++k) {
    actuator.particle[k] = particles[k];
    actuator.weight[k] = 1.0 / static_cast<double>(particles.size());
  }
  return actuator;
}

/// Returns the parts and surfaces for the alignment. Diaphragm and lungs show the place of the trunk better
/// than skin and ribs, which are used only if there is nothing else.
std::vector<SurfacePair> aligning_pairs(const TrunkMesh& trunk, const std::vector<Triangle>& outside,
                                        const std::vector<Shown>& shown) {
  std::vector<SurfacePair> pairs;
  for (const Shown& s : shown)
    if (s.surface.name == "diaphragm" || s.surface.name == "lungs")
      pairs.push_back({trunk.rest, s.part, &s.surface});
  if (pairs.empty()) pairs.push_back({trunk.rest, outside, &shown.front().surface});
  return pairs;
}

void require_similar(const Similarity& similarity) {
  constexpr double most_scale = 3.0, most_turn = 60.0 * rad_per_degree;
  if (!(similarity.scale < most_scale && similarity.scale > 1.0 / most_scale))
    throw InputError(
        {}, fmt::format("the surface needs a trunk {:.3g} times the size of this one", similarity.scale),
        fmt::format("{:.2g} to {:.2g} times", 1.0 / most_scale, most_scale),
        "check the unit of the surface, and that the surface is what the option says, or give a --landmark");
  if (!(similarity.angle() < most_turn))
    throw InputError({},
                     fmt::format("the surface needs a trunk turned by {:.0f} degrees",
                                 degrees_per_rad * similarity.angle()),
                     fmt::format("less than {:.0f}", degrees_per_rad * most_turn),
                     "check the axes of the surface, and that the surface is what the option says, or give a "
                     "--landmark such as dome_top_right and lung_top");
}

/// Returns whether a surface is as deep as it is wide.
bool is_round(const MeasuredSurface& surface) {
  constexpr double least_difference = 1.1;
  double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
  for (const Vec3d& p : surface.points) {
    low[0] = std::min(low[0], p.x());
    high[0] = std::max(high[0], p.x());
    low[1] = std::min(low[1], p.y());
    high[1] = std::max(high[1], p.y());
  }
  return high[0] - low[0] < least_difference * (high[1] - low[1]);
}

Volumes volumes_of(const TrunkMesh& mesh) {
  return {enclosed_volume<double>(mesh.lung, mesh.rest), enclosed_volume<double>(mesh.abdomen, mesh.rest)};
}

double highest(const TrunkMesh& mesh, const std::vector<int>& particles) {
  double z = -HUGE_VAL;
  for (int i : particles) z = std::max(z, mesh.rest[index(i)].z());
  return z;
}

double mean_height(const TrunkMesh& mesh, const std::vector<int>& particles) {
  double sum = 0.0;
  for (int i : particles) sum += mesh.rest[index(i)].z();
  return sum / static_cast<double>(particles.size());
}

/// Raises the lung's wall until the lung has its volume, which is linear in the rise. Each particle rises in
/// proportion to its height in `before` above the top of the zone of apposition.
void size_lung(double wanted, const TrunkMesh& before, TrunkMesh& mesh) {
  const double base = mean_height(before, before.named("apposition_top"));
  const auto raised = [&](double share) {
    TrunkMesh result = mesh;
    for (const char* region : {"lung_wall", "lung_top"})
      for (int i : mesh.named(region))
        result.rest[index(i)] += Vec3d{0.0, 0.0, share * (before.rest[index(i)].z() - base)};
    return result;
  };
  const double now = volumes_of(mesh).lung, slope = volumes_of(raised(1.0)).lung - now;
  TrunkMesh sized = raised((wanted - now) / slope);
  const double domes = highest(mesh, mesh.named("central_tendon"));
  if (!(slope > 0.0 && highest(sized, mesh.named("lung_top")) > domes))
    throw InputError({},
                     fmt::format("a lung volume of {:.0f} ml leaves no room over the domes of this diaphragm",
                                 ml_per_m3 * wanted),
                     "more",
                     "check that it is the volume at the end of expiration, and the unit of the surface");
  mesh = std::move(sized);
}

double mean_apposition_length(const TrunkMesh& mesh) {
  double sum = 0.0;
  for (const auto& line : mesh.muscle_lines)
    for (std::size_t row = 0; row < mesh.apposition_top_row(); ++row)
      sum += norm(mesh.rest[index(line[row + 1])] - mesh.rest[index(line[row])]);
  return sum / static_cast<double>(mesh.muscle_lines.size());
}

/// Returns the line of the costal insertion on a measured diaphragm; nothing if its lower border is a cut.
std::optional<InsertionLine> insertion_on(const MeasuredSurface& diaphragm, const TrunkMesh& placed,
                                          LowerBorder border) {
  if (border == LowerBorder::cut) return std::nullopt;
  constexpr std::size_t points = 20000;
  std::vector<Vec3d> all = spread_over(diaphragm.points, diaphragm.triangles, points);
  for (const Triangle& t : diaphragm.triangles)
    for (int i : t) all.push_back(diaphragm.points[index(i)]);
  const auto& ring = placed.named("costal_insertion");
  Vec3d low(HUGE_VAL, HUGE_VAL, HUGE_VAL), high = -1.0 * low;
  for (int i : ring) {
    const Vec3d& p = placed.rest[index(i)];
    low = {std::min(low.x(), p.x()), std::min(low.y(), p.y()), std::min(low.z(), p.z())};
    high = {std::max(high.x(), p.x()), std::max(high.y(), p.y()), std::max(high.z(), p.z())};
  }
  const double zone = mean_apposition_length(placed);
  InsertionLine line(all, 0.5 * (low + high), 0.5 * (high.x() - low.x()), 0.5 * (high.y() - low.y()), zone);
  const double costal = 0.5 * (low.z() + high.z());
  if (border == LowerBorder::automatic && !(line.covered() > 0.5 && line.low_height() < costal + 0.5 * zone))
    return std::nullopt;
  return line;
}

/// The trunk and the subject in the trunk's own directions, at the subject's size.
struct Placed {
  TrunkMesh mesh;
  std::vector<Shown> shown;
  std::vector<LinearActuator> landmarks;
  std::optional<InsertionLine> insertion;
};

Placed place(const TrunkMesh& trunk, const std::vector<Shown>& shown,
             const std::vector<LinearActuator>& landmarks, const Similarity& similarity, LowerBorder border) {
  Placed placed{trunk, shown, landmarks, {}};
  const auto upright = [&](const Vec3d& p) { return turn_back(similarity.rotation, p - similarity.shift); };
  for (Vec3d& p : placed.mesh.rest) p = similarity.scale * p;
  for (Shown& s : placed.shown) {
    for (Vec3d& p : s.surface.points) p = upright(p);
    if (!s.measured) continue;
    for (Vec3d& p : s.measured->surface.points) p = upright(p);
  }
  for (LinearActuator& landmark : placed.landmarks) landmark.target = upright(landmark.target);
  for (const Shown& s : placed.shown)
    if (s.surface.name == "diaphragm") placed.insertion = insertion_on(s.surface, placed.mesh, border);
  return placed;
}

}  // namespace

Registration register_trunk(const TrunkMesh& trunk, const SubjectMeasurements& targets,
                            const std::function<void(int iteration, int of)>& progress) {
  std::optional<LungSurface> lungs;
  if (!targets.lungs.empty()) lungs = outer_lungs(joined(targets.lungs), targets.lung_side);
  std::optional<DomeCut> cut;
  if (targets.diaphragm) cut = cut_of_half_dome(*targets.diaphragm);
  const std::vector<Shown> shown = shown_by(trunk, targets, cut, lungs);
  std::vector<LinearActuator> landmarks;
  std::vector<NamedPoint> points;
  for (const auto& [name, place] : targets.landmarks) {
    landmarks.push_back(landmark_actuator(trunk, name, place));
    points.push_back({place - landmarks.back().reach(trunk.rest), place});
  }
  const std::vector<Triangle> outside = outside_of(trunk);
  const std::vector<SurfacePair> pairs = aligning_pairs(trunk, outside, shown);

  Registration result;
  result.alignment = lungs ? align_upright(pairs, points) : align(pairs, points);
  const Similarity& similarity = result.alignment.similarity;
  require_similar(similarity);
  const Placed placed = place(trunk, shown, landmarks, similarity, targets.lower_border);
  const TrunkMesh aligned_mesh = placed.mesh;
  result.mesh = placed.mesh;
  result.aligned = volumes_of(result.mesh);

  constexpr double guessed_weight = 0.1;
  MatchingGoals goals;
  for (const Shown& s : placed.shown)
    goals.attractions.push_back({&s.surface, s.part, s.direction, s.facing});
  goals.landmarks = placed.landmarks;
  goals.apposition_length = targets.apposition_length;
  if (placed.insertion) {
    goals.insertion = &*placed.insertion;
    result.insertion_covered = placed.insertion->covered();
    fit_insertion(*placed.insertion, result.mesh);
    // A diaphragm does not show where its zone of apposition ends above. Unless the length is given, the
    // template's proportion is a weak goal.
    if (!goals.apposition_length) {
      goals.apposition_length = mean_apposition_length(result.mesh);
      goals.apposition_weight = guessed_weight;
    }
  }
  Matching matching = match(result.mesh, goals, progress);
  result.mesh.rest = std::move(matching.position);
  result.iterations = matching.iterations;
  result.moved = matching.moved;
  result.held_back = matching.held_back;
  result.matched = volumes_of(result.mesh);
  if (targets.lung_volume) size_lung(*targets.lung_volume, aligned_mesh, result.mesh);

  std::vector<Attraction> measured;
  for (const Shown& s : placed.shown)
    measured.push_back(s.measured ? Attraction{&s.measured->surface, s.measured->part, s.direction, s.facing}
                                  : Attraction{&s.surface, s.part, s.direction, s.facing});
  for (const Attraction& a : measured) add_region_fits(result.mesh, a, result.fits);
  result.extrapolated = regions_without_data(result.mesh, measured, result.particles_without_data);
  result.final = volumes_of(result.mesh);
  result.apposition_length = mean_apposition_length(result.mesh);
  result.apposition_wanted = targets.apposition_length;
  if (lungs) {
    result.lungs_given = lungs->volume;
    result.lung_side = lungs->side;
    result.notes = lungs->notes;
  }
  if (cut)
    result.notes.push_back(
        fmt::format("the diaphragm is the {} half of one, cut in a plane; the other half of the trunk is "
                    "extrapolated, as its "
                    "mirror image",
                    cut->measured_side > 0.0 ? "right" : "left"));
  result.lung_stretch = targets.lung_volume ? result.final.lung / result.matched.lung : 1.0;
  for (const RegionFit& fit : result.fits)
    if (fit.target == "diaphragm" && fit.region == "zone_of_apposition")
      result.cut_short = fit.with_data < 1.0 / 3.0;
  result.round_diaphragm = targets.diaphragm && !cut && is_round(*targets.diaphragm);
  result.closed_diaphragm = targets.diaphragm && TargetSurface(*targets.diaphragm).closed();
  result.quality = mesh_quality(aligned_mesh, result.mesh.rest);
  for (Vec3d& p : result.mesh.rest) p = turn(similarity.rotation, p) + similarity.shift;
  return result;
}

}  // namespace trunk
