#include "scenarios/rigid_parts.hpp"

#include "math/units.hpp"
#include "scenarios/keys.hpp"

namespace trunk {
namespace {

RigidBody::Motion motion_of(const toml::node& value, const Place& at) {
  const auto word = value.value_exact<std::string>();
  if (word == "fixed") return RigidBody::Motion::fixed;
  if (word == "driven") return RigidBody::Motion::driven;
  if (word == "free") return RigidBody::Motion::free;
  throw InputError(at, fmt::format("rigid.motion is {}", shown(value)), "\"fixed\", \"driven\" or \"free\"");
}

/// Converts to mm by division, so that reading gives the same bits.
Vec3d in_mm(const Vec3d& a) {
  return {a.x() / m_per_mm, a.y() / m_per_mm, a.z() / m_per_mm};
}

}  // namespace

RigidPart rigid_part_of(const toml::table& table, const Place& place) {
  RigidPart part;
  part.at = place;
  part.imposed.axis = {0.0, 0.0, 1.0};
  bool has_axis = false, has_point = false;
  const auto read_key = [&](const std::string& key, const toml::node& value, const Place& at) {
    ImposedMotion& imposed = part.imposed;
    if (key == "region" && value.is_string()) {
      part.region = *value.value_exact<std::string>();
    } else if (key == "surface_for" && value.is_string()) {
      part.surface_for = *value.value_exact<std::string>();
    } else if (key == "motion") {
      part.motion = motion_of(value, at);
    } else if (key == "axis_point_mm") {
      imposed.point = m_per_mm * direction_of(value, "rigid." + key, at);
      has_point = true;
    } else if (key == "axis") {
      imposed.axis = direction_of(value, "rigid." + key, at);
      if (dot(imposed.axis, imposed.axis) == 0.0)
        throw InputError(at, "rigid.axis is zero", "a direction that is not zero");
      has_axis = true;
      const double length = norm(imposed.axis);
      if (std::abs(length - 1.0) > 1e-15) imposed.axis = (1.0 / length) * imposed.axis;
    } else if (key == "events_deg") {
      imposed.angle = events_of(value, "rigid." + key, rad_per_degree, 0.0, at);
    } else if (key == "direction") {
      imposed.direction = direction_of(value, "rigid." + key, at);
    } else if (key == "events_mm") {
      imposed.shift = events_of(value, "rigid." + key, m_per_mm, 0.0, at);
    } else {
      throw InputError(
          at, fmt::format("unknown or wrong key '{}' in [[rigid]]", key),
          "region, motion, surface_for, axis, axis_point_mm, events_deg, direction or events_mm");
    }
  };
  for_each_key(table, place, read_key);
  const bool moves = !part.imposed.angle.empty() || !part.imposed.shift.empty();
  if (part.region.empty()) throw InputError(place, "[[rigid]] is incomplete", "region");
  if (moves != (part.motion == RigidBody::Motion::driven))
    throw InputError(place,
                     moves ? "[[rigid]] has events_deg or events_mm, but its motion is not \"driven\""
                           : "[[rigid]] is driven, but has neither events_deg nor events_mm",
                     moves ? "motion = \"driven\" or no events" : "events or another motion");
  if (!part.imposed.angle.empty() && !(has_axis && has_point))
    throw InputError(place, "[[rigid]] has events_deg, but not both axis and axis_point_mm", "both");
  if (!part.imposed.shift.empty() && dot(part.imposed.direction, part.imposed.direction) == 0.0)
    throw InputError(place, "[[rigid]] has events_mm, but no direction", "a direction that is not zero");
  for (const PiecewiseLinear* course : {&part.imposed.angle, &part.imposed.shift})
    if (!course->empty() && course->events().front().value != 0.0)
      throw InputError(place, "[[rigid]] does not begin at 0, so the part would jump",
                       "events whose first value is 0");
  return part;
}

std::string toml_direction(const Vec3d& d) {
  return fmt::format("[{}, {}, {}]", d.x(), d.y(), d.z());
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
                        toml_events(m.shift, m_per_mm));
  return text;
}

}  // namespace trunk
