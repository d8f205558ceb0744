#include "registration/line_goals.hpp"

#include <algorithm>

namespace trunk {
namespace {

/// Returns the length of the ring that belongs to a particle of the costal insertion: half of both sides, m.
double ring_share(const TrunkMesh& mesh, std::size_t line) {
  const auto& lines = mesh.muscle_lines;
  const auto at = [&](std::size_t k) {
    return mesh.rest[static_cast<std::size_t>(lines[k % lines.size()].front())];
  };
  return 0.5 * norm(at(line + 1) - at(line + lines.size() - 1));
}

LinearActuator on_particle(int particle, const Vec3d& target, double stiffness) {
  return {{particle, particle, particle}, {1.0, 0.0, 0.0}, target, stiffness};
}

/// Returns the point at an arc length from the beginning of a polyline, which goes straight on beyond its
/// end.
Vec3d along(std::span<const Vec3d> polyline, double length) {
  std::size_t k = 0;
  for (; k + 2 < polyline.size(); ++k) {
    const double piece = norm(polyline[k + 1] - polyline[k]);
    if (length <= piece) break;
    length -= piece;
  }
  const Vec3d direction = polyline[k + 1] - polyline[k];
  return polyline[k] + (length / norm(direction)) * direction;
}

double mean_z(const TrunkMesh& mesh, std::span<const int> particles) {
  double sum = 0.0;
  for (int i : particles) sum += mesh.rest[static_cast<std::size_t>(i)].z();
  return sum / static_cast<double>(particles.size());
}

}  // namespace

void fit_insertion(const InsertionLine& line, TrunkMesh& mesh) {
  std::vector<int> border;
  for (const auto& muscle : mesh.muscle_lines) border.push_back(muscle.back());
  const double pelvis = mean_z(mesh, mesh.named("pelvis")),
               costal = mean_z(mesh, mesh.named("costal_insertion")),
               top = mean_z(mesh, mesh.named("apposition_top")), tendon = mean_z(mesh, border),
               lung_top = mean_z(mesh, mesh.named("lung_top"));
  const auto rise = [&](std::initializer_list<const char*> regions, auto&& share) {
    for (const char* region : regions)
      for (int i : mesh.named(region)) {
        Vec3d& p = mesh.rest[static_cast<std::size_t>(i)];
        p += Vec3d{0.0, 0.0, std::clamp(share(p.z()), 0.0, 1.0) * (line.height_beside(p) - costal)};
      }
  };
  const auto above = [&](double z) { return (tendon - z) / (tendon - costal); };
  rise({"abdominal_wall"}, [&](double z) { return (z - pelvis) / (costal - pelvis); });
  rise({"costal_insertion", "zone_of_apposition", "muscular_dome"}, above);
  rise({"lung_wall"}, [&](double z) { return above(top) * (lung_top - z) / (lung_top - top); });
}

void add_insertion(const TrunkMesh& mesh, const InsertionLine& insertion, std::span<const Vec3d> position,
                   double per_length, std::vector<LinearActuator>& actuators) {
  for (std::size_t k = 0; k < mesh.muscle_lines.size(); ++k) {
    const int particle = mesh.muscle_lines[k].front();
    const auto line = insertion.beside(position[static_cast<std::size_t>(particle)]);
    if (!line) continue;
    for (const Vec3d& direction : {line->upward, line->outward}) {
      actuators.push_back(on_particle(particle, line->point, per_length * ring_share(mesh, k)));
      actuators.back().along = direction;
    }
  }
}

void add_apposition_length(const TrunkMesh& mesh, double wanted, std::span<const Vec3d> position,
                           double per_length, std::vector<LinearActuator>& actuators) {
  const std::size_t top = mesh.apposition_top_row();
  std::vector<std::vector<Vec3d>> polylines;
  double mean = 0.0;
  for (const auto& line : mesh.muscle_lines) {
    polylines.emplace_back();
    for (int i : line) polylines.back().push_back(position[static_cast<std::size_t>(i)]);
    for (std::size_t row = 0; row < top; ++row)
      mean += norm(polylines.back()[row + 1] - polylines.back()[row]) /
              static_cast<double>(mesh.muscle_lines.size());
  }
  for (std::size_t k = 0; k < polylines.size(); ++k) {
    double length = 0.0;
    for (std::size_t row = 1; row <= top; ++row) {
      length += norm(polylines[k][row] - polylines[k][row - 1]);
      actuators.push_back(on_particle(mesh.muscle_lines[k][row], along(polylines[k], length * wanted / mean),
                                      per_length * ring_share(mesh, k)));
    }
  }
}

}  // namespace trunk
