#include "commands/options/register_options.hpp"

#include "commands/commands.hpp"
#include "commands/options/surface_options.hpp"

namespace trunk {
namespace {

void add_surfaces(CLI::App& command, RegisterRequest& request) {
  constexpr const char* group = "Surfaces of the subject";
  command
      .add_option("--surface", request.surface,
                  "The diaphragm at the end of expiration (PML, STL, OBJ, PLY, VTK, VTP or VTU).")
      ->type_name("FILE")
      ->group(group);
  command
      .add_option("--lungs", request.lungs,
                  "The closed surface of the lungs. You can give it twice, for right and left.")
      ->type_name("FILE")
      ->group(group)
      ->take_all();
  command
      .add_option("--lung-side", request.lung_side,
                  "Says which lung it is, if there is only one. [its shape says it]")
      ->type_name("SIDE")
      ->group(group)
      ->check(one_of({"right", "left"}));
  command.add_option("--skin", request.skin, "The skin of the trunk. It shapes the abdominal wall.")
      ->type_name("FILE")
      ->group(group);
  command
      .add_option("--ribs", request.ribs,
                  "The ribs. They shape the zone of apposition and the wall of the lung.")
      ->type_name("FILE")
      ->group(group);
  command
      .add_option("--landmark", request.landmarks,
                  "Where a landmark of the trunk is, in the coordinates of the first file: dome_top_right, "
                  "dome_top_left, dome_saddle, lung_top or spine. You can repeat it.")
      ->type_name("NAME=X,Y,Z")
      ->group(group)
      ->take_all();
  add_surface_options(command, request.file);
}

void add_targets(CLI::App& command, RegisterRequest& request) {
  constexpr const char* group = "Registration";
  command
      .add_option("--lung-volume-ml", request.lung_volume_ml,
                  "The lung volume at the end of expiration. The height of the lung follows from it. [the "
                  "scenario's, 4760; with --lungs, what the surfaces give]")
      ->type_name("ML")
      ->group(group)
      ->check(within(200.0, 20000.0));
  command
      .add_option(
          "--apposition-length-mm", request.apposition_length_mm,
          "The mean length of the zone of apposition along the muscle. [what surface and shape memory "
          "give]")
      ->type_name("MM")
      ->group(group)
      ->check(within(5.0, 400.0));
  command
      .add_option(
          "--lower-border", request.lower_border,
          "What the lower border of the diaphragm's surface is: the costal insertion, or where the data "
          "were cut. [auto: insertion if it is low enough and goes around]")
      ->type_name("NAME")
      ->group(group)
      ->check(one_of({"auto", "insertion", "cut"}));
  command
      .add_option("--resolution", request.resolution,
                  "Uses a template whose mesh is this many times finer than the one of 113 particles. [the "
                  "scenario's]")
      ->group(group)
      ->check(whole_number(1, 16));
  command
      .add_option("--tolerance-mm", request.tolerance_mm,
                  "The largest RMS distance between trunk and surface, both ways, with exit code 0. The 95th "
                  "percentile may be twice as large. [5]")
      ->type_name("MM")
      ->group(group)
      ->check(within(0.01, 100.0));
}

}  // namespace

void add_register_options(CLI::App& command, RegisterRequest& request) {
  command.add_option("SCENARIO", request.scenario,
                     "The scenario whose trunk is registered. [the shipped scenarios/healthy.toml]");
  command
      .add_option("-o,--output", request.output,
                  "Writes the subject's trunk to this file (PML), and its scenario beside it as .toml.")
      ->type_name("FILE")
      ->required();
  add_surfaces(command, request);
  add_targets(command, request);
}

}  // namespace trunk
