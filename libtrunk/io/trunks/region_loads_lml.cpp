#include "trunks/region_loads_lml.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

#include "errors/input_error.hpp"
#include "files/read_file.hpp"
#include "pml/load_vocabulary.hpp"
#include "pml/read_lml.hpp"
#include "pml/write_lml.hpp"

namespace trunk {
namespace {

using Kind = RegionLoad::Kind;
constexpr std::size_t largest_loads_file = 10'000'000;

RegionLoad region_load(const pml::Load& load, const std::string& file) {
  const auto fail = [&](const std::string& found, const std::string& expected) {
    throw InputError({file, load.line}, found, expected);
  };
  RegionLoad result;
  result.at = {file, load.line};
  switch (load.type) {
    case pml::Load::Type::translation:
      result.kind = Kind::displacement;
      break;
    case pml::Load::Type::force:
      result.kind = Kind::force;
      break;
    case pml::Load::Type::acceleration:
      result.kind = Kind::acceleration;
      break;
    case pml::Load::Type::pressure:
      result.kind = Kind::pressure;
      break;
    case pml::Load::Type::rotation:
      fail("a Rotation cannot be imposed on particles", "a [[rigid]] part of the scenario with events_deg");
  }
  const auto* axes = std::get_if<pml::Axes>(&load.direction);
  if (!axes) fail("a direction toward an atom is not simulated", "x, y and z");
  const auto factor = [&](std::size_t k) { return (*axes)[k].factor; };
  const auto bound = [&](std::size_t k) { return (*axes)[k].kind == pml::Axis::Kind::free ? 0.0 : 1.0; };
  result.direction = {factor(0), factor(1), factor(2)};
  if (result.kind == Kind::displacement) result.axes = {bound(0), bound(1), bound(2)};
  const bool needs_direction = result.kind == Kind::force || result.kind == Kind::acceleration;
  if (needs_direction && dot(result.direction, result.direction) == 0.0)
    fail("a direction of zero", "a number other than 0 for x, y or z");
  result.region = pml::text_of(load.targets);
  result.magnitude = pml::course(load, pml::to_si(load));
  return result;
}

/// Returns the range of "3" or "0-3"; nothing if the text is neither.
std::optional<pml::AtomRange> range_of(std::string_view item) {
  pml::AtomRange range;
  const char* stop = item.data() + item.size();
  const auto low = std::from_chars(item.data(), stop, range.first);
  if (low.ec != std::errc{}) return std::nullopt;
  range.last = range.first;
  if (low.ptr == stop) return range;
  if (*low.ptr != '-') return std::nullopt;
  const auto high = std::from_chars(low.ptr + 1, stop, range.last);
  return high.ec == std::errc{} && high.ptr == stop ? std::optional(range) : std::nullopt;
}

std::vector<pml::LoadTarget> targets_of(const std::string& region) {
  std::vector<pml::LoadTarget> targets;
  for (std::size_t begin = 0; begin <= region.size();) {
    const std::size_t end = std::min(region.find(',', begin), region.size());
    const std::string item = region.substr(begin, end - begin);
    const auto range = range_of(item);
    if (item == "*")
      targets.emplace_back(pml::AllAtoms{});
    else if (range)
      targets.emplace_back(*range);
    else
      targets.emplace_back(pml::ComponentName{item});
    begin = end + 1;
  }
  return targets;
}

/// Returns a value in a unit of `factor` SI units. It is read back as the same value, unless no number is.
double in_unit(double si, double factor) {
  const double nearest = si / factor;
  for (const double value : {nearest, std::nextafter(nearest, HUGE_VAL), std::nextafter(nearest, -HUGE_VAL)})
    if (value * factor == si) return value;
  return nearest;
}

/// The units are those that the schema of CamiTK has for each type of load.
pml::Load load_of(const RegionLoad& load) {
  constexpr std::pair<pml::Load::Type, const char*> types[] = {{pml::Load::Type::force, "N"},
                                                               {pml::Load::Type::translation, "mm"},
                                                               {pml::Load::Type::acceleration, "m/s^2"},
                                                               {pml::Load::Type::pressure, "kPa"}};
  const auto [type, unit] = types[static_cast<std::size_t>(load.kind)];
  pml::Axes axes;
  const double direction[] = {load.direction.x(), load.direction.y(), load.direction.z()};
  const double imposed[] = {load.axes.x(), load.axes.y(), load.axes.z()};
  const bool displaces = load.kind == Kind::displacement;
  const bool undirected = dot(load.direction, load.direction) == 0.0;  // LML requires an axis nevertheless
  for (std::size_t k = 0; k < 3; ++k) {
    const bool acts = displaces ? imposed[k] != 0.0 : undirected || direction[k] != 0.0;
    if (!acts) continue;
    const bool held = displaces && direction[k] == 0.0;
    axes[k] = {held ? pml::Axis::Kind::fixed : pml::Axis::Kind::along, direction[k]};
  }
  pml::Load result;
  result.type = type;
  result.targets = targets_of(load.region);
  result.direction = axes;
  result.unit = unit;
  const double factor = pml::to_si(result);
  for (const auto& event : load.magnitude.events())
    result.events.push_back({event.time_s, in_unit(event.value, factor)});
  return result;
}

}  // namespace

std::vector<RegionLoad> read_region_loads(const std::filesystem::path& path) {
  const std::string file = path.string();
  std::vector<RegionLoad> result;
  for (const pml::Load& load : pml::read_lml(read_text_file(path, largest_loads_file), file).loads) try {
      result.push_back(region_load(load, file));
    } catch (const InputError& error) {
      rethrow_at({file, load.line}, error);
    }
  return result;
}

std::string region_loads_lml(const std::vector<RegionLoad>& loads) {
  pml::Loads document;
  for (const RegionLoad& load : loads) document.loads.push_back(load_of(load));
  return pml::write_lml(document);
}

}  // namespace trunk
