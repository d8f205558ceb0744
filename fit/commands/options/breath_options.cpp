#include "commands/options/breath_options.hpp"

#include "commands/commands.hpp"
#include "math/units.hpp"

namespace trunk {

void add_breath_options(CLI::App& command, BreathSelection& selection) {
  const auto numbers = [&command](const std::string& option, std::vector<std::size_t>& chosen,
                                  const std::string& what) {
    command
        .add_option_function<std::vector<std::string>>(
            option,
            [option, &chosen](const std::vector<std::string>& given) {
              for (const std::string& text : given)
                for (const std::size_t number : breath_numbers(option, text)) chosen.push_back(number);
            },
            what + " `trunk breaths` lists their numbers. Write them as in 3,7 or 3-5.")
        ->type_name("N,N-M")
        ->group("Which breaths to use")
        ->take_all();
  };
  numbers("--exclude", selection.excluded, "Rejects these breaths.");
  numbers("--include", selection.included, "Keeps these breaths, even if they look odd.");
  const auto time = [&command](const std::string& option, std::optional<double>& chosen,
                               const std::string& what) {
    command
        .add_option_function<double>(
            option, [&chosen](const double& s) { chosen = s; }, what)
        ->type_name("S")
        ->group("Which breaths to use")
        ->check(within(-1e9, 1e9));
  };
  time("--begin", selection.begin_s,
       "Uses only breaths that begin at this time of the recording, in s, or later. Their numbers stay those "
       "of the whole recording.");
  time("--end", selection.end_s, "Uses only breaths that end by this time of the recording, in s.");
  command
      .add_option_function<double>(
          "--calibrate-tidal-volume",
          [&selection](double ml) { selection.calibrate_tidal_volume_m3 = m3_per_ml * ml; },
          "Scales the signal so that the median kept breath has this tidal volume in ml. A belt needs it, "
          "and so "
          "does a volume of wrong calibration.")
      ->type_name("ML")
      ->group("Which breaths to use")
      ->check(within(30.0, 6000.0));
}

}  // namespace trunk
