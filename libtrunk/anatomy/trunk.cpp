#include "anatomy/trunk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "anatomy/rigid_parts.hpp"
#include "anatomy/template_mesh.hpp"
#include "errors/input_error.hpp"
#include "forces/shape_memory.hpp"
#include "mesh/areas.hpp"
#include "sheet/sheet.hpp"

namespace trunk {
namespace {

constexpr const char* diaphragm[] = {"costal_insertion", "zone_of_apposition", "muscular_dome",
                                     "central_tendon"};
constexpr const char* abdominal_wall[] = {"pelvis", "abdominal_wall"};

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

/// Returns the given value of each particle if that is a number, else the value of the tissue.
std::vector<double> preferred(const std::vector<double>& given, std::vector<double> otherwise) {
  for (std::size_t i = 0; i < given.size() && i < otherwise.size(); ++i)
    if (std::isfinite(given[i])) otherwise[i] = given[i];
  return otherwise;
}

/// Returns the share of elasticity that paralysis leaves to each particle.
std::vector<double> softening(const TrunkMesh& m, const Tissue& tissue) {
  std::vector<double> factor(m.rest.size(), 1.0);
  for (const char* region : diaphragm)
    for (int i : m.named(region)) {
      const double paralysed = share_of_side(tissue.paralysed, m.rest[index(i)].x() - m.midline());
      factor[index(i)] = 1.0 + paralysed * (tissue.paralysed_stiffness - 1.0);
    }
  return factor;
}

std::vector<double> abdominal_shares(const TrunkMesh& m) {
  std::vector<double> share(m.rest.size(), 0.0);
  for (const char* region : abdominal_wall)
    for (int i : m.named(region)) share[index(i)] = 1.0;
  return share;
}

std::vector<Fibre> make_fibres(const TrunkMesh& m, const Tissue& tissue, double strength) {
  const std::size_t end = tissue.fibre_end == FibreEnd::tendon_border ? m.muscle_lines.front().size() - 1
                                                                      : m.apposition_top_row();
  std::vector<Fibre> fibres;
  for (const auto& line : m.muscle_lines) {
    const double paralysed = share_of_side(tissue.paralysed, m.rest[index(line.front())].x() - m.midline());
    fibres.push_back({line.front(), line[end], strength * (1.0 - paralysed)});
  }
  return fibres;
}

/// See Tissue::held_stiffness. Particles of a free rigid body are not held.
void stiffen_held(double factor, Model& model) {
  std::set<int> moving;
  for (const RigidBody& body : model.bodies)
    if (body.motion == RigidBody::Motion::free) moving.insert(body.particles.begin(), body.particles.end());
  ShapeMemory& memory = model.shape_memory;
  for (std::size_t r = 0; r < memory.rings.size(); ++r) {
    const int i = memory.rings.vertex[r];
    const Vec3d& mobility = model.mobility[index(i)];
    if (dot(mobility, mobility) == 0.0 && !moving.contains(i)) memory.stiffness_weight[r] *= factor;
  }
}

/// Returns one spring for every edge. The stiffness of a sheet of such springs does not depend on their
/// length.
std::vector<MembraneEdge> make_membrane(const TrunkMesh& m, double stiffness) {
  std::vector<MembraneEdge> edges;
  if (stiffness == 0.0) return edges;
  std::set<std::pair<int, int>> seen;
  for (const Triangle& t : m.abdomen)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto [a, b] = std::minmax(t[corner], t[(corner + 1) % 3]);
      if (seen.emplace(a, b).second)
        edges.push_back({a, b, norm(m.rest[index(b)] - m.rest[index(a)]), stiffness});
    }
  return edges;
}

/// Returns the width of the strip of muscle of each line at its insertion, m.
std::vector<double> muscle_widths(const TrunkMesh& m) {
  std::vector<double> widths;
  const std::size_t count = m.muscle_lines.size();
  const auto insertion = [&](std::size_t line) {
    return m.rest[index(m.muscle_lines[line % count].front())];
  };
  for (std::size_t line = 0; line < count; ++line) {
    const Vec3d here = insertion(line);
    widths.push_back(0.5 * (norm(insertion(line + 1) - here) + norm(here - insertion(line + count - 1))));
  }
  return widths;
}

/// Makes the elastic particles those of a sheet, and fibres strips of muscle. What the tissue has for a
/// particle or a fibre of a mesh of fineness n is taken back to the 113-particle mesh, and counts for the
/// area or the width there. Mass serves the stability of the step only, so a stiffer particle is heavier. =>
/// model. Returns the factors of lay_sheet.
std::vector<double> make_sheet(const TrunkMesh& m, const Tissue& tissue, Model& model) {
  const double finer = m.fineness * m.fineness;
  for (double& weight : model.shape_memory.stiffness_weight) weight /= finer;
  std::vector<double> factor = lay_sheet(m.abdomen, m.rest, model.shape_memory);
  for (const int i : model.shape_memory.rings.vertex)
    model.mass[index(i)] =
        std::max(model.mass[index(i)], tissue.particle_mass * factor[index(i)] / (finer * finer));
  constexpr double usual_width = 0.070;  // m, of a strip of the 113-particle template
  const std::vector<double> width = muscle_widths(m);
  for (std::size_t line = 0; line < width.size(); ++line)
    model.fibres[line].activity *= m.fineness * width[line] / usual_width;
  return factor;
}

/// Stiffens the rings on the borders of what is held. Ribs hold the zone of apposition along its normal. The
/// spine is a line with the wall on both sides.
void stiffen_borders(const TrunkMesh& m, std::span<const double> factor, Model& model) {
  const std::vector<bool> pushed = pushed_particles(model);
  std::vector<bool> border = pushed;
  border.flip();
  std::vector<bool> clamped = border;
  for (const Support& support : model.supports) clamped[index(support.particle)] = true;
  for (const int i : m.named("spine")) border[index(i)] = false;
  trunk::stiffen_borders(m.rest, clamped, border, factor, model.shape_memory);
}

/// Returns the damping of each particle (see DampingBy). Particles off the elastic surface have no area, and
/// damping moves none of them.
std::vector<double> damping_weights(const TrunkMesh& m, DampingBy share) {
  constexpr double template_area = 4.554e-3;  // m2, the mean over the 92 elastic particles of the template
  std::vector<double> weights(m.rest.size(), 1.0 / (m.fineness * m.fineness));
  if (share == DampingBy::particle) return weights;
  const std::vector<double> area = particle_areas(m.abdomen, m.rest);
  for (std::size_t i = 0; i < area.size(); ++i)
    if (area[i] > 0.0) weights[i] = area[i] / template_area;
  return weights;
}

void require_possible(const Tissue& tissue) {
  for (const double factor : {tissue.tendon_factor, tissue.paralysed_stiffness, tissue.rib_friction,
                              tissue.membrane_stiffness, tissue.particle_mass, tissue.held_stiffness})
    if (!std::isfinite(factor) || factor < 0.0)
      throw InputError({}, fmt::format("a mass, stiffness or factor of the tissue is {}", factor),
                       "0 or more");
}

}  // namespace

double share_of_side(Side side, double x) {
  constexpr double midline_width = 2e-3;
  switch (side) {
    case Side::none:
      return 0.0;
    case Side::both:
      return 1.0;
    case Side::right:
      return std::clamp(0.5 + x / midline_width, 0.0, 1.0);
    case Side::left:
      return share_of_side(Side::right, -x);
  }
  return 0.0;
}

TrunkMesh::Given healthy_tissue(const TrunkMesh& m, const Tissue& tissue) {
  const double finer = m.fineness * m.fineness;
  TrunkMesh::Given field;
  field.mass.assign(m.rest.size(), tissue.particle_mass / finer);
  field.damping =
      damping_weights(m, tissue.elasticity == ElasticLaw::sheet ? DampingBy::area : tissue.damping);
  field.stiffness.assign(m.rest.size(), finer);
  for (int i : m.named("central_tendon")) field.stiffness[index(i)] *= tissue.tendon_factor;
  field.mass = preferred(m.given.mass, std::move(field.mass));
  field.damping = preferred(m.given.damping, std::move(field.damping));
  field.stiffness = preferred(m.given.stiffness, std::move(field.stiffness));
  field.fibre_strength = m.given.fibre_strength > 0.0 ? m.given.fibre_strength : 1.0 / m.fineness;
  return field;
}

Trunk make_trunk(const TrunkMesh& mesh, const Tissue& tissue, Reaction reaction,
                 const std::vector<RigidPart>& parts) {
  require_possible(tissue);
  if (tissue.elasticity == ElasticLaw::sheet && reaction == Reaction::published)
    throw InputError({}, "the published reaction is shared equally, and a sheet shares it by weights",
                     "the reaction \"variational\" with the elasticity \"sheet\"",
                     "set tissue.reaction or tissue.elasticity");
  require_anatomy(mesh);
  const int particles = static_cast<int>(mesh.rest.size());
  const Surface abdomen("abdomen", mesh.abdomen, particles);
  const Surface lung("lung", mesh.lung, particles);
  TrunkMesh::Given healthy = healthy_tissue(mesh, tissue);
  std::vector<double> stiffness = healthy.stiffness;
  const std::vector<double> left = softening(mesh, tissue);
  for (std::size_t i = 0; i < stiffness.size(); ++i) stiffness[i] *= left[i];

  Trunk trunk{{}, mesh};
  Model& model = trunk.model;
  model.rest = mesh.rest;
  model.mass = std::move(healthy.mass);
  model.damping_weight = std::move(healthy.damping);
  model.mobility.assign(mesh.rest.size(), {1.0, 1.0, 1.0});
  model.shape_memory = make_shape_memory(abdomen, mesh.rest, stiffness, abdominal_shares(mesh), reaction);
  model.membrane = make_membrane(mesh, tissue.membrane_stiffness);
  model.fibres = make_fibres(mesh, tissue, healthy.fibre_strength);
  std::vector<double> sheet_factor;
  if (tissue.elasticity == ElasticLaw::sheet) sheet_factor = make_sheet(mesh, tissue, model);
  model.abdomen = held_volume(abdomen, mesh.rest);
  model.lung = mesh.lung;
  model.lung_rings = ring_table(lung);
  model.domes = {mesh.named("dome_top_right"), mesh.named("dome_top_left")};
  model.lung_fans = fans(mesh.lung);
  for (int i : mesh.named("fixed")) model.mobility[index(i)] = {0.0, 0.0, 0.0};
  add_rigid_parts(mesh, tissue, parts, model);
  if (tissue.elasticity == ElasticLaw::sheet)
    stiffen_borders(mesh, sheet_factor, model);
  else
    stiffen_held(tissue.held_stiffness, model);
  leave_out_unpushed(pushed_particles(model), model.shape_memory);
  require_valid(model);
  return trunk;
}

Trunk make_template_trunk(const TrunkGeometry& geometry, const Tissue& tissue, Reaction reaction) {
  return make_trunk(make_template_mesh(geometry), tissue, reaction);
}

}  // namespace trunk
