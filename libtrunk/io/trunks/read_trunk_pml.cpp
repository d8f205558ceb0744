#include "trunks/read_trunk_pml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>

#include "errors/input_error.hpp"
#include "files/read_file.hpp"
#include "math/units.hpp"
#include "mesh/volume.hpp"
#include "pml/read_pml.hpp"

namespace trunk {
namespace {

constexpr std::size_t largest_trunk_file = 100'000'000;

class TrunkReader {
 public:
  /// `root_line` is the line of the element physicalModel, for messages about its attributes.
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
        fail(fmt::format("there is no component '{}'", name), "a trunk such as `trunk export --pml` writes");
    try {
      const int particles = static_cast<int>(mesh().rest.size());
      const Surface abdomen("abdomen", mesh().abdomen, particles);
      const Surface lung("lung", mesh().lung, particles);
      require_anatomy(mesh());
    } catch (const InputError& error) {
      rethrow_at({file_}, error);
    }
    require_human_size();
    return std::move(result_);
  }

 private:
  [[noreturn]] void fail(std::string found, std::string expected, std::string remedy = "") const {
    throw InputError({file_}, std::move(found), std::move(expected), std::move(remedy));
  }
  [[noreturn]] void fail_at_root(std::string found, std::string expected) const {
    throw InputError({file_, root_line_}, std::move(found), std::move(expected));
  }

  [[noreturn]] void fail_twice(const std::string& name) const {
    fail(fmt::format("component '{}' occurs twice", name), "one component of each name");
  }

  TrunkMesh& mesh() { return result_.mesh; }

  double number(const std::string& text, const std::string& what, double low) const {
    double value = 0.0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc{} || stop != end || !std::isfinite(value) || value < low)
      fail(fmt::format("{} is '{}'", what, text), fmt::format("a number of {:g} or more", low));
    return value;
  }

  double units_per_metre() const {
    const std::string* unit = pml::find(model_.attributes, "unit");
    if (!unit || *unit == "mm") return mm_per_m;
    if (*unit == "m") return 1.0;
    fail_at_root(fmt::format("the model's unit is '{}'", *unit), "mm or m");
  }

  /// Applies the limits of the parametric trunk, which a trunk in a wrong unit exceeds.
  void require_human_size() {
    constexpr double smallest_ml = 200, largest_ml = 20000;
    const double volume_ml = enclosed_volume<double>(mesh().lung, mesh().rest) / m3_per_ml;
    if (!(volume_ml >= smallest_ml && volume_ml <= largest_ml))
      fail(fmt::format("the lung encloses {:.4g} ml", volume_ml),
           fmt::format("{} to {} ml", smallest_ml, largest_ml),
           "check the unit of the model, and that its triangles are counter-clockwise seen from outside");
  }

  void read_atoms() {
    const double per_metre = units_per_metre();
    if (const std::string* axes = pml::find(model_.attributes, "axes"); axes && *axes != "RAS")
      fail_at_root(fmt::format("the model's axes are '{}'", *axes), "RAS: right, forward, up");
    if (const std::string* fineness = pml::find(model_.attributes, "fineness"))
      mesh().fineness = number(*fineness, "the model's fineness", 1e-3);
    TrunkMesh::Given& given = mesh().given;
    for (const pml::Atom& atom : model_.atoms) {
      if (atom.index != mesh().rest.size())
        fail(fmt::format("atom {} follows {} others", atom.index, mesh().rest.size()),
             "atoms that are numbered 0, 1, 2 … in order");
      const Vec3d& p = atom.position;  // division nearly always gives the number that was written
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
        fail(fmt::format("component '{}' has items that are not TRIANGLE cells", name),
             "TRIANGLE cells only");
      const auto at = [&](std::size_t k) { return static_cast<int>(cell->atoms[k]); };
      result.push_back({at(0), at(1), at(2)});
    }
    return result;
  }

  void read_muscle_lines(const pml::StructuralComponent& component) {
    for (const auto& item : component.items) {
      const auto* cell = std::get_if<pml::Cell>(&item);
      if (!cell || cell->type != "POLY_LINE")
        fail("component 'muscle_lines' has items that are not POLY_LINE cells", "POLY_LINE cells only");
      mesh().muscle_lines.emplace_back(cell->atoms.begin(), cell->atoms.end());
    }
    const std::string* strength = pml::find(component.attributes, "strength");
    if (!strength) return;
    mesh().given.fibre_strength = number(*strength, "the strength of muscle_lines", 0.0);
    if (mesh().given.fibre_strength == 0.0)
      fail("the strength of muscle_lines is 0", "a strength above 0", "describe paralysis in the scenario");
  }

  std::vector<int> atoms_of(const pml::StructuralComponent& component, const std::string& name) const {
    std::vector<int> particles;
    std::set<std::size_t> seen;
    for (const auto& item : component.items)
      if (const auto* atom = std::get_if<pml::AtomReference>(&item)) {
        if (!seen.insert(atom->index).second)
          fail(fmt::format("component '{}' lists atom {} twice", name, atom->index), "every atom once");
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
      fail(fmt::format("component '{}' has rigid=\"{}\"", name, *motion), "fixed or free",
           "describe a driven part as [[rigid]] in the scenario");
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
