#include <fmt/format.h>

#include <charconv>
#include <chrono>

#include "commands/commands.hpp"
#include "commands/options/shipped_files.hpp"
#include "commands/options/surface_options.hpp"
#include "commands/text/registration_text.hpp"
#include "dynamics/stability.hpp"
#include "errors/input_error.hpp"
#include "files/replace_file.hpp"
#include "scenarios/read_scenario.hpp"
#include "surface/axes.hpp"
#include "trunks/read_trunk_pml.hpp"

namespace trunk {
namespace {

namespace fs = std::filesystem;

struct RegisterRequest {
  std::string scenario, output, surface, skin, ribs;
  std::vector<std::string> lungs, landmarks;
  SurfaceOptions file;
  std::string lower_border = "auto";
  std::optional<double> lung_volume_ml, apposition_length_mm;
  std::optional<int> resolution;
  double tolerance_mm = 5.0;
};

/// Coordinates of the surface files in the trunk's unit and axes.
struct FileFrame {
  double metres = 1.0;
  Axes axes;
};

/// "name=x,y,z", in the coordinates of the files.
std::pair<std::string, Vec3d> landmark_of(const std::string& text, const FileFrame& frame) {
  const auto fail = [&]() -> InputError {
    return InputError("--landmark " + text + ": expected name=x,y,z in the coordinates of the surface files");
  };
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0) throw fail();
  double at[3];
  const char *next = text.data() + equals + 1, *end = text.data() + text.size();
  for (int k = 0; k < 3; ++k) {
    const auto [stop, error] = std::from_chars(next, end, at[k]);
    const bool last = k == 2;
    if (error != std::errc{} || !std::isfinite(at[k]) || (last ? stop != end : stop == end || *stop != ','))
      throw fail();
    next = stop + 1;
  }
  return {text.substr(0, equals), frame.axes(frame.metres * Vec3d{at[0], at[1], at[2]})};
}

/// Reads the surfaces and landmarks of a subject; the first file's frame is that of the landmarks.
class SubjectReader {
 public:
  explicit SubjectReader(const RegisterRequest& request) : request_(request) {}

  SubjectMeasurements read() {
    if (!request_.surface.empty()) targets_.diaphragm = surface(request_.surface);
    for (const std::string& file : request_.lungs) targets_.lungs.push_back(surface(file));
    if (!request_.skin.empty()) targets_.skin = surface(request_.skin);
    if (!request_.ribs.empty()) targets_.ribs = surface(request_.ribs);
    if (files_.empty()) throw CLI::RequiredError("--surface, --lungs, --skin or --ribs FILE");
    for (const std::string& text : request_.landmarks) targets_.landmarks.insert(landmark_of(text, *frame_));
    return std::move(targets_);
  }

  const std::vector<fs::path>& files() const { return files_; }
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  MeasuredSurface surface(const std::string& file) {
    SurfaceOptions options = request_.file;
    if (frame_) options.axes_of_others = frame_->axes.letters();
    ImportedSurface read = read_surface(file, options);
    for (const std::string& note : read.notes) notes_.push_back(file + ": " + note);
    files_.push_back(file);
    const double metres = read.unit == "m" ? 1.0 : read.unit == "cm" ? 1e-2 : 1e-3;
    if (!frame_) frame_ = {metres, Axes(read.axes)};
    return std::move(read.surface);
  }

  const RegisterRequest& request_;
  SubjectMeasurements targets_;
  std::vector<fs::path> files_;
  std::vector<std::string> notes_;
  std::optional<FileFrame> frame_;
};

LowerBorder lower_border_of(const std::string& word) {
  if (word == "insertion") return LowerBorder::insertion;
  return word == "cut" ? LowerBorder::cut : LowerBorder::automatic;
}

/// A finer mesh, or thin triangles, may ask for shorter steps than the scenario's.
bool step_too_long(Scenario scenario, const TrunkMesh& mesh) {
  scenario.mesh = std::make_shared<const TrunkMesh>(mesh);
  const Trunk trunk = make_trunk(scenario);
  return !scenario.automatic_step &&
         scenario.time.dt_s >= stable_time_step(trunk.model, scenario.parameters, scenario.time.damping);
}

/// The scenario of the subject: the one that was registered, with another trunk. Numbers that were fitted to
/// the other trunk are in it until `trunk fit` finds this subject's.
std::string subject_toml(const fs::path& scenario, const fs::path& pml, bool shorter_steps) {
  const fs::path extended = fs::proximate(fs::absolute(scenario), fs::absolute(pml).parent_path());
  const auto quoted = [](const std::string& text) { return Json(text).dump(); };
  return fmt::format(
      "# Written by `trunk register`. The trunk is the subject's; the parameters are still those of the "
      "scenario it extends:\n"
      "# `trunk fit` finds the subject's own.\n"
      "schema = \"trunk.scenario/1\"\nextends = {}\ntitle = {}\n\n[geometry]\npml = {}\n{}",
      quoted(extended.string()), quoted(pml.stem().string()), quoted(pml.filename().string()),
      shorter_steps ? "\n[time]\ndt_ms = \"auto\"  # the scenario's is unstable on this mesh\n" : "");
}

TrunkMesh trunk_to_register(const RegisterRequest& request, ScenarioFile& file) {
  if (request.resolution) {
    if (file.scenario.mesh)
      throw InputError("--resolution: the trunk comes from " + file.scenario.mesh_file + " and has its own");
    file.scenario.geometry.resolution = *request.resolution;
  }
  return mesh_of(file.scenario);
}

/// A trunk that other commands would refuse is not written.
void require_upright(const TrunkMesh& mesh) {
  try {
    require_anatomy(mesh);
  } catch (const InputError& error) {
    throw InputError(std::string("registered to this surface, ") + error.what() +
                     "; is the surface in these axes, "
                     "and is it what the option says?");
  }
}

Exit register_command(const Common& common, RegisterRequest request) {
  const auto start = std::chrono::steady_clock::now();
  const fs::path pml = request.output, toml = fs::path(pml).replace_extension(".toml");
  if (pml.extension() != ".pml")
    throw InputError(request.output, 0,
                     "expected a name that ends in .pml: the scenario goes beside it as .toml");
  if (request.scenario.empty())
    request.scenario = shipped_file("scenarios/healthy.toml", "SCENARIO").string();
  ScenarioFile scenario = read_scenario(request.scenario);
  const TrunkMesh trunk = trunk_to_register(request, scenario);
  SubjectReader reader(request);
  SubjectMeasurements targets = reader.read();
  const bool own_volume = request.lung_volume_ml || targets.lungs.empty();
  if (own_volume)
    targets.lung_volume =
        1e-6 * request.lung_volume_ml.value_or(1e6 * scenario.scenario.geometry.end_expiratory_volume);
  if (request.apposition_length_mm) targets.apposition_length = 1e-3 * *request.apposition_length_mm;
  targets.lower_border = lower_border_of(request.lower_border);
  std::vector<fs::path> inputs = scenario.inputs;
  inputs.insert(inputs.end(), reader.files().begin(), reader.files().end());
  require_apart(inputs, {pml, toml});
  require_writable_output(pml, common.force);
  require_writable_output(toml, common.force);

  const Registration found = register_trunk(trunk, targets, [](int n, int of) {
    print_progress(fmt::format("register: iteration {} of {}", n + 1, of));
  });
  const RegistrationVerdict verdict = verdict_of(found, 1e-3 * request.tolerance_mm);
  require_upright(found.mesh);
  replace_file(pml, trunk_pml(found.mesh, found.mesh.given, scenario.scenario.rigid, pml.stem().string()));
  replace_file(toml, subject_toml(request.scenario, pml, step_too_long(scenario.scenario, found.mesh)));
  const std::vector<std::string> warnings = warnings_of(found);
  for (const std::string& note : reader.notes()) print_note("note: " + note);
  for (const std::string& warning : warnings) print_note("warning: " + warning);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  Json json = registration_json(found, verdict);
  json["notes"] = reader.notes();
  json["warnings"] = warnings;
  json["wall_s"] = wall.count();
  json["files"] = {pml.string(), toml.string()};
  print_result(common, json,
               registration_text(found, verdict) +
                   fmt::format("Written in {:.1f} s: {} {}\nSimulate it: trunk simulate {} -o run.h5",
                               wall.count(), pml.string(), toml.string(), toml.string()));
  if (verdict.done()) return Exit::done;
  print_note("trunk: " + verdict.message);
  return Exit::not_converged;
}

}  // namespace

void add_register(CLI::App& app, Common& common, Run& run) {
  auto* command =
      app.add_subcommand("register", "Bring a trunk onto the surfaces segmented in a subject's images");
  const auto request = std::make_shared<RegisterRequest>();
  command->add_option("SCENARIO", request->scenario,
                      "whose trunk is registered [scenarios/healthy.toml, as shipped]");
  command->add_option("--surface", request->surface,
                      "the diaphragm at the end of expiration: PML, STL, OBJ, PLY, VTK or VTP");
  command
      ->add_option("--lungs", request->lungs,
                   "closed surface of the lungs; may be given twice, right and left")
      ->take_all();
  command->add_option("--skin", request->skin, "the skin of the trunk, for the abdominal wall");
  command->add_option("--ribs", request->ribs, "the ribs, for the zone of apposition and the lung's wall");
  add_surface_options(*command, request->file);
  command
      ->add_option("--landmark", request->landmarks,
                   "name=x,y,z: where a landmark of the trunk is (dome_top_right, dome_top_left, "
                   "dome_saddle, lung_top, spine), in "
                   "the coordinates of the first file; may be repeated")
      ->take_all();
  command
      ->add_option("--lung-volume-ml", request->lung_volume_ml,
                   "at the end of expiration; the lung's height follows from it [the scenario's, 4760; with "
                   "--lungs as the matching leaves it]")
      ->check(within(200.0, 20000.0));
  command
      ->add_option(
          "--apposition-length-mm", request->apposition_length_mm,
          "mean length of the zone of apposition along the muscle [as the surface and shape memory leave it]")
      ->check(within(5.0, 400.0));
  command
      ->add_option("--lower-border", request->lower_border,
                   "what the diaphragm's lower border is: the costal insertion, or where the data were cut "
                   "[auto: insertion where it is low enough and goes around]")
      ->check(CLI::IsMember({"auto", "insertion", "cut"}));
  command
      ->add_option("--resolution", request->resolution,
                   "of the template, times that of its 113 particles [the scenario's]")
      ->check(CLI::Range(1, 16));
  command
      ->add_option(
          "--tolerance-mm", request->tolerance_mm,
          "largest RMS distance between trunk and surface, both ways, that exits 0; the 95th percentile "
          "may be twice that [5]")
      ->check(within(0.01, 100.0));
  command
      ->add_option("-o,--output", request->output,
                   "the subject's trunk (PML); its scenario goes beside it as .toml")
      ->required();
  command->add_flag("--json", common.json, "print one JSON object");
  command->add_flag("--force", common.force, "replace files that exist");
  command->footer(
      "Exit codes: 0 done, 2 bad input, 3 written, but farther from a surface than the tolerance or with "
      "triangles "
      "that are not sound.");
  command->callback(
      [&common, &run, request] { run = [&common, request] { return register_command(common, *request); }; });
}

}  // namespace trunk
