#include <fmt/format.h>

#include "commands/commands.hpp"
#include "commands/options/surface_options.hpp"
#include "errors/input_error.hpp"
#include "exports/csv_table.hpp"
#include "exports/vtk_files.hpp"
#include "files/replace_file.hpp"
#include "math/units.hpp"

namespace trunk {
namespace {

constexpr const char* sign_of_distance =
    "positive: the model lies on the side that the surface faces: above a diaphragm, outside a closed "
    "surface";

constexpr double most_turn = 30.0;  // degrees, by --align; our choice: subjects lie straight in a scanner

struct CompareRequest : SurfaceRequest {
  std::string run, output;
};

Json distances_json(const Distances& d) {
  return {{"mean_mm", mm_per_m * d.mean},
          {"rms_mm", mm_per_m * d.rms},
          {"median_mm", mm_per_m * d.median},
          {"percentile95_mm", mm_per_m * d.percentile95},
          {"hausdorff_mm", mm_per_m * d.hausdorff}};
}

std::vector<double> in_mm(std::vector<double> metres) {
  for (double& x : metres) x *= mm_per_m;
  return metres;
}

Json repairs_json(const RepairReport& r) {
  return {{"points_merged", r.merged_points},
          {"points_isolated", r.isolated_points},
          {"triangles_degenerate", r.degenerate},
          {"triangles_twice", r.duplicates},
          {"triangles_turned", r.turned},
          {"slivers", r.slivers},
          {"specks", r.specks},
          {"islands", r.islands},
          {"sheet_triangles", r.sheet_triangles},
          {"sheet_thickness_mm", mm_per_m * r.sheet_thickness},
          {"pieces", r.pieces},
          {"borders", r.borders},
          {"branching_edges", r.branching_edges},
          {"closed", r.closed()},
          {"oriented", r.oriented}};
}

Json compare_json(const CompareRequest& request, const SurfaceAnswer& answer) {
  const auto& [file, beside] = answer;
  const auto& [surface, region, c] = beside;
  Json json{{"schema", "trunk.compare/1"},
            {"run", request.run},
            {"surface", request.surface},
            {"format", file.format},
            {"unit", file.unit},
            {"axes", file.axes},
            {"region", region.name},
            {"at", request.at},
            {"time_s", region.time_s},
            {"sign", sign_of_distance},
            {"mean_signed_mm", mm_per_m * c.mean_side},
            {"model_to_surface", distances_json(c.to_surface)},
            {"surface_to_model", distances_json(c.from_surface)},
            {"hausdorff_mm", mm_per_m * std::max(c.to_surface.hausdorff, c.from_surface.hausdorff)},
            {"covered_percent", 100.0 * c.covered},
            {"covered_to_surface", distances_json(c.covered_to_surface)},
            {"particles", region.particles},
            {"signed_distance_mm", in_mm(c.side)},
            {"at_border", c.at_border},
            {"surface_triangles", surface.triangles.size()},
            {"repairs", repairs_json(file.repaired)},
            {"notes", file.notes}};
  if (request.align)
    json["aligned"] = {
        {"shift_mm",
         {mm_per_m * c.moved.shift.x(), mm_per_m * c.moved.shift.y(), mm_per_m * c.moved.shift.z()}},
        {"angle_degrees", c.moved.angle * degrees_per_rad}};
  return json;
}

std::string distances_line(const char* name, const Distances& d) {
  return fmt::format("  {:<24}{:>9.2f}{:>9.2f}{:>9.2f}{:>9.2f}{:>11.2f}\n", name, mm_per_m * d.mean,
                     mm_per_m * d.rms, mm_per_m * d.median, mm_per_m * d.percentile95,
                     mm_per_m * d.hausdorff);
}

std::string compare_table(const CompareRequest& request, const RunRegion& region, const ShapeComparison& c) {
  std::string text = fmt::format("{} of {} at {:.3f} s ({}) beside {}, mm\n", region.name, request.run,
                                 region.time_s, request.at, request.surface);
  text +=
      fmt::format("  {:<24}{:>9}{:>9}{:>9}{:>9}{:>11}\n", "", "mean", "RMS", "median", "95 %", "Hausdorff");
  text += distances_line("model to surface", c.to_surface);
  if (c.covered < 0.995 && c.covered > 0.0)
    text += distances_line(fmt::format("  the {:.0f} % over it", 100.0 * c.covered).c_str(),
                           c.covered_to_surface);
  text += distances_line("surface to model", c.from_surface);
  text += fmt::format("  signed mean {:+.2f} mm ({})", mm_per_m * c.mean_side, sign_of_distance);
  if (request.align)
    text += fmt::format("\n  the surface was turned by {:.1f} degrees and moved to fit (--align)",
                        c.moved.angle * degrees_per_rad);
  return text;
}

/// Returns a table with a row for each particle, or a surface with the same numbers, as the file name asks.
std::string map_text(const std::filesystem::path& output, const RunRegion& region, const ShapeComparison& c) {
  std::vector<double> flat, x, y, z, border(c.at_border.begin(), c.at_border.end());
  for (const Vec3d& p : region.points) {
    flat.insert(flat.end(), {p.x(), p.y(), p.z()});
    x.push_back(mm_per_m * p.x());
    y.push_back(mm_per_m * p.y());
    z.push_back(mm_per_m * p.z());
  }
  if (output.extension() == ".vtp")
    return surface_vtp(flat, region.triangles,
                       {{"signed_distance_mm", "mm", in_mm(c.side)}, {"at_border", "1", border}});
  CsvTable table;
  table.add("particle", "1", region.particles);
  table.add("x", "mm", x);
  table.add("y", "mm", y);
  table.add("z", "mm", z);
  table.add("signed_distance", "mm", in_mm(c.side));
  table.add("at_border", "1", border);
  return table.csv();
}

void prepare_output(const Common& common, const CompareRequest& request) {
  if (request.output.empty()) return;
  const std::string extension = std::filesystem::path(request.output).extension();
  if (extension != ".csv" && extension != ".vtp")
    throw InputError(Place{request.output}, "the name does not say what to write",
                     "a name that ends in .csv or .vtp");
  require_apart({request.run, request.surface}, {request.output});
  require_writable_output(request.output, common.force);
}

Exit compare_command(const Common& common, const CompareRequest& request) {
  prepare_output(common, request);
  const SurfaceAnswer answer = compared(request, request.run);
  const auto& [surface, region, comparison] = answer.beside;
  if (!request.output.empty()) {
    const std::string map = map_text(request.output, region, comparison);
    replace_file(request.output, std::as_bytes(std::span(map)));
  }
  print_result(common, compare_json(request, answer), compare_table(request, region, comparison));
  const double turned = comparison.moved.angle * degrees_per_rad;
  if (turned <= most_turn) return Exit::done;
  print_error(fmt::format(
      "--align turned the surface by {:.0f} degrees; expected at most {:g}; check its axes, and whether it "
      "shows the {}",
      turned, most_turn, request.region));
  return Exit::not_converged;
}

}  // namespace

void add_compare(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand(
      "compare", "Compares the shape of a simulated trunk with a measured surface. Distances are in mm.");
  const auto request = std::make_shared<CompareRequest>();
  command
      ->add_option("RUN", request->run,
                   "A run or a fit (HDF5). For a fit, this command compares the best run.")
      ->required();
  add_surface_request(*command, *request)->required();
  command
      ->add_option("-o,--output", request->output,
                   "Writes the signed distance of every particle to this file: a table if the name ends in "
                   ".csv, a surface if it ends in .vtp.")
      ->type_name("FILE");
  add_json_flag(*command, common);
  add_force_flag(*command, common, "Replaces the output if it exists.");
  command->footer(
      "The exit code is 3 if --align turned the surface by more than 30 degrees.\n\n"
      "Examples:\n"
      "  trunk compare run.h5 --surface diaphragm.stl\n"
      "  trunk compare run.h5 --surface lung.vtp --region lung --at end -o lung.csv");
  command->callback(
      [&common, &run, request] { run = [&common, request] { return compare_command(common, *request); }; });
}

}  // namespace trunk
