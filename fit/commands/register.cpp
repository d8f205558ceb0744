#include <fmt/format.h>

#include <chrono>

#include "commands/commands.hpp"
#include "commands/options/shipped_files.hpp"
#include "commands/read_subject.hpp"
#include "commands/text/registration_text.hpp"
#include "dynamics/stability.hpp"
#include "errors/input_error.hpp"
#include "files/replace_file.hpp"
#include "math/units.hpp"
#include "scenarios/read_scenario.hpp"
#include "trunks/read_trunk_pml.hpp"

namespace trunk {
namespace {

namespace fs = std::filesystem;

LowerBorder lower_border_of(const std::string& word) {
  if (word == "insertion") return LowerBorder::insertion;
  return word == "cut" ? LowerBorder::cut : LowerBorder::automatic;
}

/// Returns whether the scenario's time step is unstable on this mesh: a finer mesh and thin triangles need
/// shorter steps.
bool step_too_long(Scenario scenario, const TrunkMesh& mesh) {
  scenario.tissue.damping = DampingBy::area;
  scenario.time.start = Start::rest;  // a trunk whose breathing cannot repeat is still judged by its shape
  scenario.mesh = std::make_shared<const TrunkMesh>(mesh);
  const Trunk trunk = make_trunk(scenario);
  return !scenario.automatic_step &&
         scenario.time.dt_s >= stable_time_step(trunk.model, scenario.parameters, scenario.time.damping);
}

/// Returns the subject's scenario: the registered one with another trunk. It keeps numbers that belong to the
/// registered trunk until `trunk fit` finds the subject's own. A doubt stands in its title, which every
/// result and report shows.
std::string subject_toml(const fs::path& scenario, const fs::path& pml, const RegistrationVerdict& verdict,
                         bool shorter_steps) {
  const fs::path extended = fs::proximate(fs::absolute(scenario), fs::absolute(pml).parent_path());
  const auto quoted = [](const std::string& text) { return Json(text).dump(); };
  return fmt::format(
      "# Written by `trunk register`. The trunk is the subject's; the parameters are still those of the "
      "scenario it extends:\n"
      "# `trunk fit` finds the subject's own.\n"
      "schema = \"trunk.scenario/1\"\nextends = {}\ntitle = {}\n\n[geometry]\npml = {}\n\n"
      "[tissue]\ndamping = \"area\"  # so that the triangles of this mesh do not change it\n{}",
      quoted(extended.string()),
      quoted(pml.stem().string() +
             (verdict.done() ? "" : " (registration in doubt: " + verdict.status + ")")),
      quoted(pml.filename().string()),
      shorter_steps ? "\n[time]\ndt_ms = \"auto\"  # the scenario's is unstable on this mesh\n" : "");
}

TrunkMesh trunk_to_register(const RegisterRequest& request, ScenarioFile& file) {
  if (request.resolution) {
    if (file.scenario.mesh)
      throw InputError(Place{"--resolution"},
                       "the trunk comes from " + file.scenario.mesh_file + " and has its own", "",
                       "leave the option out");
    file.scenario.geometry.resolution = *request.resolution;
  }
  return mesh_of(file.scenario);
}

/// Throws InputError if the trunk is one that other commands would refuse.
void require_upright(const TrunkMesh& mesh) {
  try {
    require_anatomy(mesh);
  } catch (const InputError& error) {
    Mistake mistake = error.mistake();
    mistake.found = "registered to this surface, " + mistake.found;
    mistake.remedy = "check the axes of the surface, and whether it is what the option says";
    throw InputError(mistake);
  }
}

void print_notes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) print_note("note: " + note);
}

/// Returns the registered trunk. If the surfaces are refused, the notes about them come first, since they
/// often tell why: the axes, the unit.
Registration registered(const TrunkMesh& trunk, const RegistrationSubject& subject) {
  try {
    Registration found = register_trunk(trunk, subject.measurements, [](int n, int of) {
      print_progress(fmt::format("register: iteration {} of {}", n + 1, of));
    });
    require_upright(found.mesh);
    return found;
  } catch (const InputError&) {
    print_notes(subject.notes);
    throw;
  }
}

Exit register_command(const Common& common, RegisterRequest request) {
  const auto start = std::chrono::steady_clock::now();
  const fs::path pml = request.output, toml = fs::path(pml).replace_extension(".toml");
  if (pml.extension() != ".pml")
    throw InputError(Place{request.output}, "does not end in .pml", "a name that ends in .pml",
                     "the scenario goes beside it as .toml");
  if (request.scenario.empty())
    request.scenario = shipped_file("scenarios/healthy.toml", "SCENARIO").string();
  ScenarioFile scenario = read_scenario(request.scenario);
  const TrunkMesh trunk = trunk_to_register(request, scenario);
  RegistrationSubject subject = read_subject(request);
  SubjectMeasurements& targets = subject.measurements;
  const bool own_volume = request.lung_volume_ml || targets.lungs.empty();
  if (own_volume)
    targets.lung_volume = m3_per_ml * request.lung_volume_ml.value_or(
                                          ml_per_m3 * scenario.scenario.geometry.end_expiratory_volume);
  if (request.apposition_length_mm) targets.apposition_length = m_per_mm * *request.apposition_length_mm;
  targets.lower_border = lower_border_of(request.lower_border);
  if (!request.lung_side.empty())
    targets.lung_side = request.lung_side == "right" ? LungSide::right : LungSide::left;
  std::vector<fs::path> inputs = scenario.inputs;
  inputs.insert(inputs.end(), subject.files.begin(), subject.files.end());
  require_apart(inputs, {pml, toml});
  require_writable_output(pml, common.force);
  require_writable_output(toml, common.force);

  const Registration found = registered(trunk, subject);
  subject.notes.insert(subject.notes.end(), found.notes.begin(), found.notes.end());
  const RegistrationVerdict verdict = verdict_of(found, m_per_mm * request.tolerance_mm);
  replace_file(pml, trunk_pml(found.mesh, found.mesh.given, scenario.scenario.rigid, pml.stem().string()));
  replace_file(toml,
               subject_toml(request.scenario, pml, verdict, step_too_long(scenario.scenario, found.mesh)));
  const std::vector<std::string> warnings = warnings_of(found);
  print_notes(subject.notes);
  for (const std::string& warning : warnings) print_note("warning: " + warning);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  Json json = registration_json(found, verdict);
  json["notes"] = subject.notes;
  json["warnings"] = warnings;
  json["wall_s"] = wall.count();
  json["files"] = {pml.string(), toml.string()};
  print_result(common, json,
               registration_text(found, verdict) +
                   fmt::format("Written in {:.1f} s: {} {}\nSimulate it: trunk simulate {} -o run.h5",
                               wall.count(), pml.string(), toml.string(), toml.string()));
  if (verdict.done()) return Exit::done;
  print_error(verdict.message);
  return Exit::not_converged;
}

}  // namespace

void add_register(CLI::App& app, Common& common, Run& run) {
  auto* command =
      app.add_subcommand("register",
                         "Brings a trunk onto surfaces that were segmented in a subject's images. "
                         "It writes the subject's trunk and scenario.");
  const auto request = std::make_shared<RegisterRequest>();
  add_register_options(*command, *request);
  add_json_flag(*command, common);
  add_force_flag(*command, common, "Replaces files that exist.");
  command->footer(
      "The exit code is 3 if the trunk is farther from a surface than the tolerance, if triangles are "
      "folded, or "
      "if the trunk would be turned, scaled or stretched more than a subject can be. The files are written "
      "all "
      "the same.\n\n"
      "Examples:\n"
      "  trunk register --surface diaphragm.stl -o subject.pml\n"
      "  trunk register --lungs right.vtp --lungs left.vtp --axes LPS -o subject.pml");
  command->callback(
      [&common, &run, request] { run = [&common, request] { return register_command(common, *request); }; });
}

}  // namespace trunk
