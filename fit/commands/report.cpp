#include <fmt/format.h>

#include "commands/commands.hpp"
#include "commands/options/surface_options.hpp"
#include "errors/input_error.hpp"
#include "files/replace_file.hpp"
#include "report/page.hpp"

namespace trunk {
namespace {

struct ReportRequest {
  std::vector<std::string> files;
  std::string output;
  SurfaceRequest beside;
};

Exit report_command(const Common& common, const ReportRequest& request) {
  const std::vector<std::filesystem::path> files(request.files.begin(), request.files.end());
  require_apart(files, {request.output});
  require_writable_output(request.output, common.force);
  std::optional<ComparedSurface> beside;
  if (!request.beside.surface.empty()) {
    require_apart({request.beside.surface}, {request.output});
    if (files.size() > 1)
      throw InputError(Place{request.files[1]}, "is a second file", "one run or fit if --surface is given",
                       "leave one of them out");
    beside = compared(request.beside, request.files[0]).beside;
  }
  const std::string page = report_page(files, beside);
  replace_file(request.output, std::as_bytes(std::span(page)));
  print_result(common, {{"schema", "trunk.report/1"}, {"file", request.output}, {"bytes", page.size()}},
               fmt::format("Written to {} ({:.2f} MB): open it in a browser", request.output,
                           1e-6 * static_cast<double>(page.size())));
  return Exit::done;
}

}  // namespace

void add_report(CLI::App& app, Common& common, Run& run) {
  auto* command = app.add_subcommand(
      "report",
      "Makes a page for a browser. It shows the trunk as it breathes, the curves, and a fit or sweep.");
  const auto request = std::make_shared<ReportRequest>();
  command
      ->add_option("FILE", request->files,
                   "A run, a fit or a sweep (HDF5). Two runs or fits are shown side by side.")
      ->required()
      ->expected(1, 2);
  command
      ->add_option("-o,--output", request->output,
                   "Writes the page to this file (HTML). The page needs no network and no other file.")
      ->type_name("FILE")
      ->required();
  auto* surface = add_surface_request(*command, request->beside);
  for (const char* option : {"--at", "--region", "--align", "--surface-unit", "--axes", "--component"})
    command->get_option(option)->needs(surface);
  add_json_flag(*command, common);
  add_force_flag(*command, common, "Replaces the page if it exists.");
  command->footer(
      "Examples:\n"
      "  trunk report fit.h5 -o fit.html\n"
      "  trunk report healthy.h5 paralysed.h5 -o both.html");
  command->callback(
      [&common, &run, request] { run = [&common, request] { return report_command(common, *request); }; });
}

}  // namespace trunk
