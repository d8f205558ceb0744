#include "commands/options/breath_options.hpp"

#include "errors/input_error.hpp"

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
            what + ": numbers as trunk breaths lists them, as in 3,7 or 3-5")
        ->take_all();
  };
  numbers("--exclude", selection.excluded, "breaths to reject");
  numbers("--include", selection.included, "breaths to keep though they look odd");
  command.add_option_function<double>(
      "--calibrate-tidal-volume",
      [&selection](double ml) {
        if (!(ml >= 1 && ml <= 10000))  // CLI::Range lets NaN pass
          throw InputError("--calibrate-tidal-volume: expected 1 to 10000 ml");
        selection.calibrate_tidal_volume_m3 = 1e-6 * ml;
      },
      "ml that the median kept breath had: scales a belt, or a volume of wrong calibration");
}

}  // namespace trunk
