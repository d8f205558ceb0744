#include "anatomy/trunk.hpp"

#include <algorithm>
#include <cmath>

#include "errors/input_error.hpp"
#include "forces/shape_memory.hpp"

namespace trunk {
namespace {

std::size_t index(int i) {
  return static_cast<std::size_t>(i);
}

std::vector<const Level*> diaphragm_levels(const TemplateMesh& m) {
  return {&m.costal_insertion, &m.apposition_middle, &m.apposition_top,
          &m.tendon_border,    &m.dome_top,          &m.dome_saddle};
}

std::vector<double> stiffness_weights(const TemplateMesh& m, const Tissue& tissue) {
  std::vector<double> weight(m.rest.size(), 1.0);
  for (const Level* level : {&m.tendon_border, &m.dome_top, &m.dome_saddle})
    for (int i : level->particles) weight[index(i)] = tissue.tendon_factor;
  for (const Level* level : diaphragm_levels(m))
    for (int i : level->particles) {
      const double paralysed = share_of_side(tissue.paralysed, m.rest[index(i)].x());
      weight[index(i)] *= 1.0 + paralysed * (tissue.paralysed_stiffness - 1.0);
    }
  return weight;
}

std::vector<double> abdominal_shares(const TemplateMesh& m) {
  std::vector<double> share(m.rest.size(), 0.0);
  for (const Level* level : {&m.pelvic_floor, &m.pelvis, &m.abdominal_wall_low, &m.abdominal_wall_high})
    for (int i : level->particles) share[index(i)] = 1.0;
  return share;
}

std::vector<Fibre> make_fibres(const TemplateMesh& m, const Tissue& tissue) {
  const Level& end = tissue.fibre_end == FibreEnd::tendon_border ? m.tendon_border : m.apposition_top;
  std::vector<Fibre> fibres;
  for (std::size_t k = 0; k < end.particles.size(); ++k) {
    const int insertion = m.costal_insertion.particles[k];
    const double paralysed = share_of_side(tissue.paralysed, m.rest[index(insertion)].x());
    fibres.push_back({insertion, end.particles[k], 1.0 - paralysed});
  }
  return fibres;
}

/// The hindmost particle of each free ring lies on the spine.
std::vector<int> spine(const TemplateMesh& m) {
  std::vector<int> particles;
  for (const Level* level : {&m.abdominal_wall_low, &m.abdominal_wall_high, &m.costal_insertion})
    particles.push_back(
        *std::min_element(level->particles.begin(), level->particles.end(),
                          [&](int a, int b) { return m.rest[index(a)].y() < m.rest[index(b)].y(); }));
  return particles;
}

void hold(Model& model, const std::vector<int>& particles) {
  for (int i : particles) model.mobility[index(i)] = {0.0, 0.0, 0.0};
}

/// The rib cage outside the zone of apposition: the tangent plane of the trunk's ellipse at each particle. A
/// particle slides along it freely (our choice); sliding sideways by s it may leave the ellipse by s^2/2R,
/// under 0.05 mm for the few mm it does.
std::vector<Support> make_supports(const TrunkGeometry& g, const TemplateMesh& m, const Model& model) {
  std::vector<Support> supports;
  const auto& vertex = model.abdomen.rings.vertex;
  for (const Level* level : {&m.apposition_middle, &m.apposition_top})
    for (int i : level->particles) {
      const Vec3d& p = m.rest[index(i)];
      const Vec3d gradient{p.x() / (g.half_width * g.half_width), p.y() / (g.half_depth * g.half_depth), 0.0};
      const Vec3d normal = (1.0 / norm(gradient)) * gradient;
      const auto row = std::find(vertex.begin(), vertex.end(), i) - vertex.begin();
      supports.push_back({i, static_cast<int>(row), normal, normal, dot(normal, p)});
    }
  return supports;
}

void require_possible(const TrunkGeometry& g, const Tissue& tissue) {
  for (const double length : {g.half_width, g.half_depth, g.abdomen_height, g.apposition_length,
                              g.dome_height_right, g.dome_height_left, g.end_expiratory_volume})
    if (!std::isfinite(length) || length <= 0.0)
      throw InputError("a length or volume of the trunk is " + std::to_string(length) +
                       ", expected a finite number above 0");
  for (const double factor : {tissue.tendon_factor, tissue.paralysed_stiffness})
    if (!std::isfinite(factor) || factor < 0.0)
      throw InputError("a stiffness factor is " + std::to_string(factor) + ", expected 0 or more");
}

}  // namespace

double share_of_side(Side side, double x) {
  switch (side) {
    case Side::none:
      return 0.0;
    case Side::both:
      return 1.0;
    case Side::right:
      return x > 0.0 ? 1.0 : x < 0.0 ? 0.0 : 0.5;
    case Side::left:
      return share_of_side(Side::right, -x);
  }
  return 0.0;
}

Trunk make_trunk(const TrunkGeometry& geometry, const Tissue& tissue, Reaction reaction) {
  require_possible(geometry, tissue);
  Trunk trunk;
  trunk.mesh = make_template_mesh(geometry);
  const TemplateMesh& mesh = trunk.mesh;
  const int particles = static_cast<int>(mesh.rest.size());
  for (const Level* level : mesh.levels())
    for (int i : level->particles) trunk.regions[level->region].push_back(i);
  trunk.regions["spine"] = spine(mesh);

  const Surface abdomen("abdomen", mesh.abdomen, particles);
  const Surface lung("lung", mesh.lung, particles);
  Model& model = trunk.model;
  model.rest = mesh.rest;
  model.mass.assign(mesh.rest.size(), tissue.particle_mass);
  model.damping_weight.assign(mesh.rest.size(), 1.0);
  model.mobility.assign(mesh.rest.size(), {1.0, 1.0, 1.0});
  model.shape_memory = make_shape_memory(abdomen, mesh.rest, stiffness_weights(mesh, tissue),
                                         abdominal_shares(mesh), reaction);
  model.fibres = make_fibres(mesh, tissue);
  model.abdomen = {
      mesh.abdomen, ring_table(abdomen), enclosed_volume<double>(abdomen.triangles(), mesh.rest), {}};
  model.lung = mesh.lung;
  for (const char* region : {"pelvis", "spine", "lung_wall", "lung_top"}) hold(model, trunk.regions[region]);
  if (tissue.ribs) {
    hold(model, trunk.regions["costal_insertion"]);
    model.supports = make_supports(geometry, mesh, model);
  }
  require_valid(model);
  return trunk;
}

}  // namespace trunk
