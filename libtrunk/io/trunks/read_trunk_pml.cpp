#include "trunks/read_trunk_pml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>

#include "errors/input_error.hpp"
#include "files/read_file.hpp"
#include "mesh/volume.hpp"
#include "pml/read_pml.hpp"

namespace trunk {
namespace {

constexpr std::size_t largest_trunk_file = 100'000'000;

class TrunkReader {
 public:
  /// `root_line`: where the model's own element begins, for messages about its attributes.
  TrunkReader(const pml::PhysicalModel& model, const std::string& file, std::size_t root_line)
      : model_(model), file_(file), root_line_(root_line) {}

  TrunkFile read() {
    read_atoms();
    visit(model_.exclusive, false);
    if (model_.informative) visit(*model_.informative, false);
    for (const auto& [name, found] :
         {std::pair{"abdomen", !mesh().abdomen.empty()}, std::pair{"lung", !mesh().lung.empty()},
          std::pair{"muscle_lines", !mesh().muscle_lines.empty()}})
      if (!found)
        fail(fmt::format("there is no component '{}', expected a trunk as `trunk export --pml` writes it",
                         name));
    try {
      const int particles = static_cast<int>(mesh().rest.size());
      Surface("abdomen", mesh().abdomen, particles);
      Surface("lung", mesh().lung, particles);
      require_anatomy(mesh());
    } catch (const InputError& error) {
      fail(error.what());
    }
    require_human_size();
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(const std::string& text) const { throw InputError(file_, 0, text); }
  [[noreturn]] void fail_at_root(const std::string& text) const { throw InputError(file_, root_line_, text); }

  [[noreturn]] void fail_twice(const std::string& name) const {
    fail(fmt::format("component '{}' occurs twice, expected one of each name", name));
  }

  TrunkMesh& mesh() { return result_.mesh; }

  double number(const std::string& text, const std::string& what, double low) const {
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end || !std::isfinite(value) || value < low)
      fail(fmt::format("{} is '{}', expected a number of {:g} or more", what, text, low));
    return value;
  }

  double units_per_metre() const {
    const std::string* unit = pml::find(model_.attributes, "unit");
    if (!unit || *unit == "mm") return 1e3;
    if (*unit == "m") return 1.0;
    fail_at_root(fmt::format("the model's unit is '{}', expected mm or m", *unit));
  }

  /// The same limits as the parametric trunk has: a wrong unit shows here.
  void require_human_size() {
    constexpr double smallest_ml = 200, largest_ml = 20000;
    const double volume_ml = enclosed_volume<double>(mesh().lung, mesh().rest) / 1e-6;
    if (!(volume_ml >= smallest_ml && volume_ml <= largest_ml))
      fail(fmt::format(
          "the lung encloses {:.4g} ml, expected {} to {} ml: is the model's unit right, and are its "
          "triangles counter-clockwise seen from outside?",
          volume_ml, smallest_ml, largest_ml));
  }

  void read_atoms() {
    const double per_metre = units_per_metre();
    if (const std::string* axes = pml::find(model_.attributes, "axes"); axes && *axes != "RAS")
      fail_at_root(fmt::format("the model's axes are '{}', expected RAS: right, forward, up", *axes));
    if (const std::string* fineness = pml::find(model_.attributes, "fineness"))
      mesh().fineness = number(*fineness, "the model's fineness", 1e-3);
    TrunkMesh::Given& given = mesh().given;
    for (const pml::Atom& atom : model_.atoms) {
      if (atom.index != mesh().rest.size())
        fail(fmt::format(
            "atom {} follows {} others, expected the atoms of a trunk to be numbered 0, 1, 2 … in order",
            atom.index, mesh().rest.size()));
      const Vec3d& p = atom.position;  // divided: nearly always the number that was written
      mesh().rest.push_back({p.x() / per_metre, p.y() / per_metre, p.z() / per_metre});
      for (const auto& [name, field] :
           {std::pair{"mass", &given.mass}, std::pair{"stiffness", &given.stiffness},
            std::pair{"damping", &given.damping}}) {
        const std::string* text = pml::find(atom.attributes, name);
        field->push_back(text ? number(*text, fmt::format("the {} of atom {}", name, atom.index), 0.0)
                              : std::numeric_limits<double>::quiet_NaN());
      }
    }
  }

  void visit(const pml::MultiComponent& group, bool regions) {
    const std::string* name = pml::find(group.attributes, "name");
    regions = regions || (name && *name == "Regions");
    for (const pml::MultiComponent& inner : group.components) visit(inner, regions);
    for (const pml::StructuralComponent& component : group.structures) read_component(component, regions);
  }

  void read_component(const pml::StructuralComponent& component, bool is_region) {
    const std::string* name = pml::find(component.attributes, "name");
    if (!name || *name == "Node Neighborhoods") return;
    for (const auto& [known, is_there] :
         {std::pair{"abdomen", !mesh().abdomen.empty()}, std::pair{"lung", !mesh().lung.empty()},
          std::pair{"muscle_lines", !mesh().muscle_lines.empty()}})
      if (is_there && *name == known) fail_twice(*name);
    if (*name == "abdomen")
      mesh().abdomen = triangles(component, *name);
    else if (*name == "lung")
      mesh().lung = triangles(component, *name);
    else if (*name == "muscle_lines")
      read_muscle_lines(component);
    else if (auto particles = atoms_of(component, *name); !particles.empty())
      add_named(*name, std::move(particles), component.attributes, is_region);
  }

  std::vector<Triangle> triangles(const pml::StructuralComponent& component, const std::string& name) const {
    std::vector<Triangle> result;
    for (const auto& item : component.items) {
      const auto* cell = std::get_if<pml::Cell>(&item);
      if (!cell || cell->type != "TRIANGLE")
        fail(fmt::format("component '{}' has something else than TRIANGLE cells", name));
      const auto at = [&](std::size_t k) { return static_cast<int>(cell->atoms[k]); };
      result.push_back({at(0), at(1), at(2)});
    }
    return result;
  }

  void read_muscle_lines(const pml::StructuralComponent& component) {
    for (const auto& item : component.items) {
      const auto* cell = std::get_if<pml::Cell>(&item);
      if (!cell || cell->type != "POLY_LINE")
        fail("component 'muscle_lines' has something else than POLY_LINE cells");
      mesh().muscle_lines.emplace_back(cell->atoms.begin(), cell->atoms.end());
    }
    const std::string* strength = pml::find(component.attributes, "strength");
    if (!strength) return;
    mesh().given.fibre_strength = number(*strength, "the strength of muscle_lines", 0.0);
    if (mesh().given.fibre_strength == 0.0)
      fail("the strength of muscle_lines is 0, expected more (paralysis is the scenario's)");
  }

  std::vector<int> atoms_of(const pml::StructuralComponent& component, const std::string& name) const {
    std::vector<int> particles;
    std::set<std::size_t> seen;
    for (const auto& item : component.items)
      if (const auto* atom = std::get_if<pml::AtomReference>(&item)) {
        if (!seen.insert(atom->index).second)
          fail(fmt::format("component '{}' lists atom {} twice, expected it once", name, atom->index));
        particles.push_back(static_cast<int>(atom->index));
      }
    return particles;
  }

  void add_named(const std::string& name, std::vector<int> particles, const pml::Attributes& attributes,
                 bool is_region) {
    Regions& regions = is_region ? mesh().regions : mesh().landmarks;
    if (!mesh().named(name).empty()) fail_twice(name);
    regions[name] = std::move(particles);
    const std::string* motion = pml::find(attributes, "rigid");
    if (!motion) return;
    if (*motion != "fixed" && *motion != "free")
      fail(fmt::format(
          "component '{}' has rigid=\"{}\", expected fixed or free (a driven one is a [[rigid]] of the "
          "scenario)",
          name, *motion));
    RigidPart part;
    part.region = name;
    part.motion = *motion == "free" ? RigidBody::Motion::free : RigidBody::Motion::fixed;
    if (const std::string* facing = pml::find(attributes, "surfaceFor")) part.surface_for = *facing;
    part.at = {file_};
    result_.rigid.push_back(std::move(part));
  }

  const pml::PhysicalModel& model_;
  const std::string& file_;
  std::size_t root_line_;
  TrunkFile result_;
};

}  // namespace

TrunkFile trunk_of_pml(const std::string& text, const std::string& name) {
  const pml::PhysicalModel model = pml::read_pml(text, name);
  const std::size_t root = std::min(text.find("<physicalModel"), text.size());
  const auto newlines = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(root), '\n');
  return TrunkReader(model, name, static_cast<std::size_t>(newlines) + 1).read();
}

TrunkFile read_trunk_pml(const std::filesystem::path& path) {
  return trunk_of_pml(read_text_file(path, largest_trunk_file), path.string());
}

}  // namespace trunk
