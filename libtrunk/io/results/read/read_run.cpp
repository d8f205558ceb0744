#include <algorithm>
#include <charconv>
#include <sstream>

#include "errors/input_error.hpp"
#include "results/hdf5/read.hpp"
#include "results/read/open_results.hpp"
#include "results/read/read_numbers.hpp"
#include "results/read/read_parts.hpp"
#include "results/read/read_records.hpp"

namespace trunk {
namespace {

using hdf5::has_link, hdf5::read_doubles, hdf5::read_integers;

std::vector<std::int32_t> read_codes(hid_t group, const std::string& path) {
  const auto wide = read_integers(group, path);
  std::vector<std::int32_t> codes(wide.size());
  std::transform(wide.begin(), wide.end(), codes.begin(),
                 [](auto value) { return static_cast<std::int32_t>(value); });
  return codes;
}

/// Returns the meanings of codes that write_flags wrote.
std::vector<std::string> read_meanings(hid_t group, const std::string& path) {
  std::istringstream words(hdf5::read_attribute_if_any(hdf5::open_dataset(group, path), "flag_meanings"));
  std::vector<std::string> meanings;
  for (std::string word; words >> word;) meanings.push_back(word);
  return meanings;
}

template <std::size_t N>
std::vector<std::array<std::int32_t, N>> read_cells(hid_t group, const std::string& path) {
  const auto flat = read_codes(group, path);
  if (flat.size() % N != 0) throw hdf5::Error(path + " has the wrong shape");
  std::vector<std::array<std::int32_t, N>> cells(flat.size() / N);
  for (std::size_t i = 0; i < flat.size(); ++i) cells[i / N][i % N] = flat[i];
  return cells;
}

/// Throws Error if a cell names a particle that does not exist.
template <class Cells>
void require_particles(const Cells& cells, std::size_t particles, const std::string& path) {
  for (const auto& cell : cells)
    for (const std::int32_t i : cell)
      if (i < 0 || static_cast<std::size_t>(i) >= particles)
        throw hdf5::Error(path + " names a particle that does not exist");
}

void require_size(std::size_t size, std::size_t expected, const std::string& path) {
  if (size != expected) throw hdf5::Error(path + " has the wrong length");
}

Trajectory read_trajectory(hid_t run) {
  Trajectory t;
  if (!has_link(run, "particles")) return t;
  const hdf5::Group particles = hdf5::open_group(run, "particles/trajectory");
  t.particles = read_doubles(particles, "particle").size();
  t.time_s = read_doubles(particles, "position/time");
  t.step = read_integers(particles, "position/step");
  const std::size_t places = t.time_s.size() * t.particles;
  require_size(t.step.size(), t.time_s.size(), "position/step");
  const auto frames = [&](const char* quantity) {
    if (!has_link(particles, quantity)) return std::vector<double>();
    auto values = read_doubles(particles, std::string(quantity) + "/value");
    require_size(values.size(), 3 * places, quantity);
    return values;
  };
  t.position_m = frames("position");
  t.velocity_m_s = frames("velocity");
  t.force_N = frames("force");
  if (has_link(particles, "mass")) t.mass_kg = read_doubles(particles, "mass");
  const auto codes = [&](const std::string& name, std::vector<std::int32_t>& to,
                         std::vector<std::string>& names, std::size_t size) {
    to = read_codes(particles, name);
    names = read_meanings(particles, name);
    require_size(to.size(), size, name);
  };
  if (has_link(particles, "species")) codes("species", t.region, t.region_names, t.particles);
  if (has_link(particles, "rigid")) codes("rigid", t.rigid, t.rigid_names, t.particles);
  if (has_link(particles, "contact")) codes("contact/value", t.contact, t.contact_names, places);
  return t;
}

void read_connectivity(hid_t run, Trajectory& t) {
  if (t.particles == 0) return;
  const hdf5::Group cells = hdf5::open_group(run, "connectivity");
  t.triangles = read_cells<3>(cells, "triangles");
  require_particles(t.triangles, t.particles, "triangles");
  if (has_link(cells, "triangle_component")) {
    t.triangle_component = read_codes(cells, "triangle_component");
    t.component_names = read_meanings(cells, "triangle_component");
    require_size(t.triangle_component.size(), t.triangles.size(), "triangle_component");
  }
  if (has_link(cells, "fibres")) t.fibres = read_cells<2>(cells, "fibres");
  require_particles(t.fibres, t.particles, "fibres");
  if (has_link(cells, "fibre_activity")) t.fibre_activity = read_doubles(cells, "fibre_activity");
  if (!has_link(cells, "muscle_lines")) return;
  const auto flat = read_codes(cells, "muscle_lines");
  const std::size_t points = std::max<std::size_t>(1, read_doubles(cells, "line_point").size());
  for (std::size_t first = 0; first + points <= flat.size(); first += points)
    t.muscle_lines.emplace_back(flat.begin() + static_cast<std::ptrdiff_t>(first),
                                flat.begin() + static_cast<std::ptrdiff_t>(first + points));
  require_particles(t.muscle_lines, t.particles, "muscle_lines");
}

Series read_one_series(hid_t group, const std::string& name, const std::string& path, std::size_t size) {
  const hdf5::Dataset dataset = hdf5::open_dataset(group, path);
  Series series{name, hdf5::read_attribute_if_any(dataset, "units"),
                hdf5::read_attribute_if_any(dataset, "long_name"), read_doubles(group, path)};
  require_size(series.values.size(), size, path);
  return series;
}

void read_curves(hid_t run, RunRecord& record) {
  const hdf5::Group curves = hdf5::open_group(run, "curves");
  record.curve_time_s = read_doubles(curves, "time");
  for (const std::string& name : hdf5::link_names(curves))
    if (name != "time")
      record.curves.push_back(read_one_series(curves, name, name, record.curve_time_s.size()));
  if (!has_link(run, "observables")) return;
  const hdf5::Group observables = hdf5::open_group(run, "observables");
  for (const std::string& name : hdf5::link_names(observables))
    record.frame_series.push_back(
        read_one_series(observables, name, name + "/value", record.trajectory.time_s.size()));
}

}  // namespace

Provenance layout::read_provenance(hid_t root) {
  const hdf5::Group group = hdf5::open_group(root, "provenance");
  const auto text = [&](const char* name) { return hdf5::read_attribute_if_any(group, name); };
  Provenance p{text("version"),
               text("git_sha"),
               text("git_dirty") == "1",
               text("compiler"),
               text("build_type"),
               text("argv"),
               0,
               {},
               {}};
  const std::string seed = text("seed");
  std::from_chars(seed.data(), seed.data() + seed.size(), p.seed);
  std::istringstream inputs(text("input_sha256"));
  for (std::string line; std::getline(inputs, line);)
    if (const auto gap = line.find("  "); gap != std::string::npos)
      p.input_sha256.emplace_back(line.substr(gap + 2), line.substr(0, gap));
  std::istringstream libraries(text("libraries"));
  for (std::string line; std::getline(libraries, line);)
    if (const auto gap = line.find(' '); gap != std::string::npos)
      p.libraries.emplace_back(line.substr(0, gap), line.substr(gap + 1));
  return p;
}

RunRecord layout::read_run_content(hid_t run) {
  RunRecord record;
  record.title = hdf5::read_attribute(run, "title");
  record.status = hdf5::read_attribute(run, "status");
  record.message = hdf5::read_attribute(run, "message");
  record.scenario_toml = hdf5::read_text(run, "parameters/scenario_toml");
  if (has_link(run, "parameters/trunk_pml")) record.trunk_pml = hdf5::read_text(run, "parameters/trunk_pml");
  record.parameters = read_numbers(run, "parameters");
  record.measures = read_numbers(run, "measures");
  if (has_link(run, "intervals")) record.intervals = read_numbers(run, "intervals");
  record.structure = read_structure(run);
  record.trajectory = read_trajectory(run);
  read_connectivity(run, record.trajectory);
  read_curves(run, record);
  record.provenance = read_provenance(run);
  return record;
}

RunRecord read_run(const std::filesystem::path& path) {
  RunRecord record;
  layout::read_results(path, [&](hid_t root, const std::string& kind) {
    if (kind == "sweep") throw InputError({path.string()}, "is a sweep", "a run or a fit");
    record = kind == "run" ? layout::read_run_content(root)
                           : layout::read_run_content(hdf5::open_group(root, "best_run"));
  });
  return record;
}

}  // namespace trunk
