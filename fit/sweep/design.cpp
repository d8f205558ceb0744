#include "sweep/design.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trunk {
namespace {

/// Returns true if the lanes of one simulation may have different values of this key.
bool varies_in_lanes(const SweepDesign::Axis& axis) {
  return axis.key.starts_with("parameters.") || axis.key.starts_with("activation.") ||
         axis.key.starts_with("lung.");
}

/// Removes the last digit in that base from a number and returns it.
std::size_t take_digit(std::size_t& number, std::size_t base) {
  const std::size_t digit = number % base;
  number /= base;
  return digit;
}

}  // namespace

std::size_t SweepDesign::runs() const noexcept {
  constexpr std::size_t too_many = std::size_t{1} << 40;  // no overflow: each factor is smaller than 2^24
  std::size_t count = scenarios.size() * std::max<std::size_t>(1, subjects.size());
  for (const Axis& axis : grid) count = std::min(too_many, count * axis.values.size());
  return std::min(too_many, count * points);
}

SweepDesign::Run SweepDesign::run(std::size_t number) const {
  Run run{0, 0, std::vector<double>(grid.size())};
  const std::size_t point = take_digit(number, points);
  for (std::size_t a = grid.size(); a-- > 0;)
    run.values[a] = grid[a].values[take_digit(number, grid[a].values.size())];
  for (const Axis& axis : sample) run.values.push_back(axis.values[point]);
  run.subject = take_digit(number, std::max<std::size_t>(1, subjects.size()));
  run.scenario = number;
  return run;
}

std::string SweepDesign::scenario_name(std::size_t number) const {
  return scenarios[run(number).scenario].path.stem().string();
}

std::string SweepDesign::subject_name(std::size_t number) const {
  return subjects.empty() ? "" : subjects[run(number).subject].name;
}

std::vector<Setting> SweepDesign::settings_of(const std::vector<double>& values) const {
  std::vector<Setting> settings;
  for (const Axis* axis : axes())
    settings.push_back({axis->key, fmt::format("{}", values[settings.size()]), axis->at});
  return settings;
}

std::size_t SweepDesign::model_of(std::size_t number) const {
  const std::size_t point = take_digit(number, points);
  std::size_t model = 0, base = 1;
  const auto append = [&](std::size_t digit, std::size_t size) {
    model += base * digit;
    base *= size;
  };
  if (!std::all_of(sample.begin(), sample.end(), &varies_in_lanes)) append(point, points);
  for (std::size_t a = grid.size(); a-- > 0;) {
    const std::size_t size = grid[a].values.size(), digit = take_digit(number, size);
    if (!varies_in_lanes(grid[a])) append(digit, size);
  }
  take_digit(number, std::max<std::size_t>(1, subjects.size()));
  append(number, scenarios.size());
  return model;
}

std::vector<const SweepDesign::Axis*> SweepDesign::axes() const {
  std::vector<const Axis*> all;
  for (const auto* part : {&grid, &sample})
    for (const Axis& axis : *part) all.push_back(&axis);
  return all;
}

Place SweepDesign::seen_from_design(Place place) const {
  const std::filesystem::path file(path);
  for (const std::filesystem::path& folder :
       {file.parent_path(), std::filesystem::absolute(file).lexically_normal().parent_path()}) {
    const std::string prefix = folder.empty() ? "" : (folder / "").string();
    if (place.file.starts_with(prefix)) place.file.erase(0, prefix.size());
  }
  return place;
}

}  // namespace trunk
