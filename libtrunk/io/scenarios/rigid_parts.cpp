#include "scenarios/rigid_parts.hpp"

#include "math/units.hpp"
#include "scenarios/keys.hpp"

namespace trunk {
namespace {

RigidBody::Motion motion_of(const toml::node& value, const TomlPlace& at) {
  const auto word = value.value_exact<std::string>();
  if (word == "fixed") return RigidBody::Motion::fixed;
  if (word == "driven") return RigidBody::Motion::driven;
  if (word == "free") return RigidBody::Motion::free;
  at.fail(fmt::format("rigid.motion is {}, expected \"fixed\", \"driven\" or \"free\"", shown(value)));
}

/// Divided, so that it is read back to the bit.
Vec3d in_mm(const Vec3d& a) {
  return {a.x() / 1e-3, a.y() / 1e-3, a.z() / 1e-3};
}

}  // namespace

RigidPart rigid_part_of(const toml::table& table, const TomlPlace& place) {
  RigidPart part;
  part.at = {place.file, place.line};
  part.imposed.axis = {0.0, 0.0, 1.0};
  bool has_axis = false, has_point = false;
  const auto read_key = [&](const std::string& key, const toml::node& value, const TomlPlace& at) {
    ImposedMotion& imposed = part.imposed;
    if (key == "region" && value.is_string()) {
      part.region = *value.value_exact<std::string>();
    } else if (key == "surface_for" && value.is_string()) {
      part.surface_for = *value.value_exact<std::string>();
    } else if (key == "motion") {
      part.motion = motion_of(value, at);
    } else if (key == "axis_point_mm") {
      imposed.point = 1e-3 * direction_of(value, "rigid." + key, at);
      has_point = true;
    } else if (key == "axis") {
      imposed.axis = direction_of(value, "rigid." + key, at);
      if (dot(imposed.axis, imposed.axis) == 0.0) at.fail("rigid.axis is zero, expected a direction");
      has_axis = true;
      const double length = norm(imposed.axis);
      if (std::abs(length - 1.0) > 1e-15) imposed.axis = (1.0 / length) * imposed.axis;
    } else if (key == "events_deg") {
      imposed.angle = events_of(value, "rigid." + key, rad_per_degree, 0.0, at);
    } else if (key == "direction") {
      imposed.direction = direction_of(value, "rigid." + key, at);
    } else if (key == "events_mm") {
      imposed.shift = events_of(value, "rigid." + key, 1e-3, 0.0, at);
    } else {
      at.fail(
          fmt::format("unknown or wrong key '{}' in [[rigid]], expected region, motion, surface_for, axis, "
                      "axis_point_mm, events_deg, direction or events_mm",
                      key));
    }
  };
  for_each_key(table, place, read_key);
  const bool moves = !part.imposed.angle.empty() || !part.imposed.shift.empty();
  if (part.region.empty()) place.fail("[[rigid]] is incomplete, expected region");
  if (moves != (part.motion == RigidBody::Motion::driven))
    place.fail(
        "[[rigid]] has events_deg or events_mm where its motion is not \"driven\", or none where it is");
  if (!part.imposed.angle.empty() && !(has_axis && has_point))
    place.fail("[[rigid]] has events_deg and not both axis and axis_point_mm, expected both");
  if (!part.imposed.shift.empty() && dot(part.imposed.direction, part.imposed.direction) == 0.0)
    place.fail("[[rigid]] has events_mm and no direction, expected one that is not zero");
  for (const PiecewiseLinear* course : {&part.imposed.angle, &part.imposed.shift})
    if (!course->empty() && course->events().front().value != 0.0)
      place.fail(
          "[[rigid]] does not begin at 0, expected events whose first value is 0: the part would jump");
  return part;
}

std::string toml_direction(const Vec3d& d) {
  return fmt::format("[{}, {}, {}]", d.x(), d.y(), d.z());
}

std::string toml_events(const PiecewiseLinear& course, double to_si) {
  std::string text;
  for (const auto& event : course.events())
    text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", event.time_s, event.value / to_si);
  return "[" + text + "]";
}

std::string to_toml(const RigidPart& part) {
  constexpr std::string_view motions[] = {"fixed", "driven", "free"};
  const ImposedMotion& m = part.imposed;
  std::string text = fmt::format("\n[[rigid]]\nregion = {}\nmotion = \"{}\"\n", toml_text(part.region),
                                 motions[static_cast<std::size_t>(part.motion)]);
  if (!part.surface_for.empty()) text += "surface_for = " + toml_text(part.surface_for) + "\n";
  if (!m.angle.empty())
    text += fmt::format("axis_point_mm = {}\naxis = {}\nevents_deg = {}\n", toml_direction(in_mm(m.point)),
                        toml_direction(m.axis), toml_events(m.angle, rad_per_degree));
  if (!m.shift.empty())
    text += fmt::format("direction = {}\nevents_mm = {}\n", toml_direction(m.direction),
                        toml_events(m.shift, 1e-3));
  return text;
}

}  // namespace trunk
