#include "commands/text/registration_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/units.hpp"

namespace trunk {
namespace {

Json distances_json(const std::optional<Distances>& found) {
  if (!found) return nullptr;
  const Distances& d = *found;
  return {{"rms_mm", mm_per_m * d.rms},
          {"median_mm", mm_per_m * d.median},
          {"p95_mm", mm_per_m * d.percentile95},
          {"hausdorff_mm", mm_per_m * d.hausdorff}};
}

using Numbers = std::optional<Distances>;

std::string fit_row(const std::string& name, const Numbers& to_target, const Numbers& from_target,
                    double with_data) {
  const auto numbers = [](const Numbers& d) {
    if (!d) return fmt::format(" {:>31} |", "");
    return fmt::format(" {:>7.2f} {:>7.2f} {:>7.2f} {:>7.2f} |", mm_per_m * d->rms, mm_per_m * d->median,
                       mm_per_m * d->percentile95, mm_per_m * d->hausdorff);
  };
  return fmt::format("{:<30}{}{} {:>6.0f} %\n", name, numbers(to_target), numbers(from_target),
                     100.0 * with_data);
}

/// Returns the row of one region. A target as a whole has a second row if its surface is open: all of the
/// trunk's part, with what lies beyond the border of the surface.
std::string fit_rows(const RegionFit& fit) {
  if (fit.region != "all")
    return fit_row(fit.target + ", " + fit.region, fit.to_target, fit.from_target, fit.with_data);
  return fit_row(fit.target, fit.to_target, fit.from_target, fit.with_data) +
         (fit.to_target_all ? fit_row(fit.target + ", extrapolated too", fit.to_target_all, {}, 1.0) : "");
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

namespace {

/// Returns why a registration is not that of a subject, or nothing. The limits are our choice: adults differ
/// by a third in size, they lie straight in a scanner, and the lung over a diaphragm has to be guessed. What
/// is beyond is mostly another unit, other axes, or another organ.
std::string implausible(const Registration& found) {
  constexpr double least_scale = 0.6, most_scale = 1.5, most_turn = 30.0;  // degrees
  constexpr double least_stretch = 0.6, most_stretch = 2.5;
  const double scale = found.alignment.similarity.scale,
               turn = degrees_per_rad * found.alignment.similarity.angle();
  if (!(scale >= least_scale && scale <= most_scale))
    return fmt::format(
        "the trunk became {:.2f} times as large; expected {:g} to {:g} times; check the unit of the surface, "
        "and "
        "whether it is what the option says and complete",
        scale, least_scale, most_scale);
  if (!(turn <= most_turn))
    return fmt::format(
        "the trunk was turned by {:.0f} degrees; expected at most {:g}; check the axes of the surface, and "
        "whether "
        "it is what the option says, or give a --landmark such as dome_top_right",
        turn, most_turn);
  if (!(found.lung_stretch >= least_stretch && found.lung_stretch <= most_stretch))
    return fmt::format(
        "the surfaces make a lung of {:.0f} ml, which was stretched to {:.0f} ml; expected a stretch of {:g} "
        "to "
        "{:g}; check the unit of the surface, and whether it is what the option says, or give "
        "--lung-volume-ml",
        ml_per_m3 * found.matched.lung, ml_per_m3 * found.final.lung, least_stretch, most_stretch);
  return "";
}

}  // namespace

RegistrationVerdict verdict_of(const Registration& found, double tolerance) {
  if (!found.quality.sound())
    return {"unsound_mesh",
            fmt::format("{} triangles are folded and the smallest angle is {:.2f} degrees; try another "
                        "--lower-border, a landmark or a cleaner surface",
                        found.quality.folded, degrees_per_rad * found.quality.smallest_angle)};
  if (const std::string why = implausible(found); !why.empty()) return {"implausible", why};
  for (const RegionFit& fit : found.fits) {
    if (fit.region != "all") continue;  // a target is judged as a whole
    // Our choice; there is nothing between ribs, and nothing between lungs but the heart.
    const double least = fit.target == "ribs" ? 0.05 : fit.target == "lungs" ? 0.4 : 0.6;
    if (fit.with_data < least)
      return {
          "mostly_extrapolated",
          fmt::format("only {:.0f} % of the trunk's {} lie by the surface given for them; expected {:.0f} % "
                      "or more, because the rest is a guess; give another surface too (--surface, --lungs, "
                      "--skin) or a landmark",
                      100.0 * fit.with_data, fit.target, 100.0 * least)};
    for (const std::optional<Distances>& d : {fit.to_target, fit.from_target})
      if (d && !(d->rms <= tolerance && d->percentile95 <= 2.0 * tolerance))
        return {
            "beyond_tolerance",
            fmt::format("the trunk is {:.1f} mm (RMS; 95th percentile {:.1f}) from the {}; expected at most "
                        "{:g} and {:g}; check the axes and the unit of the surface, and whether it is "
                        "complete, or give a --landmark such as dome_top_right",
                        mm_per_m * d->rms, mm_per_m * d->percentile95, fit.target, mm_per_m * tolerance,
                        2.0 * mm_per_m * tolerance)};
  }
  if (found.apposition_wanted && std::abs(found.apposition_length - *found.apposition_wanted) > tolerance)
    return {
        "beyond_tolerance",
        fmt::format("the zone of apposition is {:.1f} mm long; expected the {:.1f} mm that you gave; this "
                    "surface leaves no room for them",
                    mm_per_m * found.apposition_length, mm_per_m * *found.apposition_wanted)};
  return {"registered", "registered"};
}

std::vector<std::string> warnings_of(const Registration& found) {
  std::vector<std::string> warnings;
  if (found.closed_diaphragm)
    warnings.push_back(
        "the surface given as the diaphragm is closed and thick, but a diaphragm is an open dome or a thin "
        "sheet. "
        "The trunk was bent onto it all the same; if it is a lung, give it with --lungs");
  if (found.round_diaphragm)
    warnings.push_back(
        "the surface given as the diaphragm is as deep as it is wide, but a diaphragm is wider than deep. It "
        "may be "
        "a part, a hemisphere or another organ, or its axes are others");
  if (found.cut_short)
    warnings.push_back(
        "the surface given as the diaphragm is cut short: it shows less than a third of the zone of "
        "apposition, so "
        "that this zone and the costal insertion are the template's. You can give --apposition-length-mm, or "
        "the "
        "rest of the surface");
  if (found.lung_side != LungSide::both)
    warnings.push_back(
        fmt::format("the given lung holds {:.0f} ml; the {:.0f} ml of the trunk's lung are those of two such "
                    "lungs and of what "
                    "lies between them. You can set the volume with --lung-volume-ml",
                    ml_per_m3 * found.lungs_given, ml_per_m3 * found.final.lung));
  else if (found.lungs_given > 0.0 && std::abs(found.final.lung / found.lungs_given - 1.0) > 0.05)
    warnings.push_back(fmt::format(
        "the given lungs hold {:.0f} ml, but the trunk's lung holds {:.0f} ml; the model has no heart "
        "beside the lung. You can set its volume with --lung-volume-ml",
        ml_per_m3 * found.lungs_given, ml_per_m3 * found.final.lung));
  if (found.held_back)
    warnings.push_back(
        "the last iteration was held back because triangles would fold; a finer surface, another "
        "--lower-border or "
        "a lower --resolution may fit better");
  return warnings;
}

Json registration_json(const Registration& found, const RegistrationVerdict& verdict) {
  const Similarity& s = found.alignment.similarity;
  Json json{{"schema", "trunk.register/1"}, {"status", verdict.status}, {"message", verdict.message}};
  json["similarity"] = {
      {"scale", s.scale},
      {"rotation_deg", degrees_per_rad * s.angle()},
      {"translation_mm", {mm_per_m * s.shift.x(), mm_per_m * s.shift.y(), mm_per_m * s.shift.z()}},
      {"rms_mm", mm_per_m * found.alignment.rms}};
  json["regions"] = Json::array();
  for (const RegionFit& fit : found.fits)
    json["regions"].push_back({{"target", fit.target},
                               {"region", fit.region},
                               {"to_target", distances_json(fit.to_target)},
                               {"to_target_with_extrapolated", distances_json(fit.to_target_all)},
                               {"from_target", distances_json(fit.from_target)},
                               {"with_data_percent", 100.0 * fit.with_data}});
  json["lung_volume_aligned_ml"] = ml_per_m3 * found.aligned.lung;
  json["lung_volume_matched_ml"] = ml_per_m3 * found.matched.lung;
  json["lung_volume_ml"] = ml_per_m3 * found.final.lung;
  json["abdominal_volume_aligned_ml"] = ml_per_m3 * found.aligned.abdomen;
  json["abdominal_volume_ml"] = ml_per_m3 * found.final.abdomen;
  json["lung_stretch"] = found.lung_stretch;
  json["lungs_given_ml"] = found.lungs_given > 0.0 ? Json(ml_per_m3 * found.lungs_given) : Json();
  json["apposition_length_mm"] = mm_per_m * found.apposition_length;
  json["apposition_length_wanted_mm"] =
      found.apposition_wanted ? Json(mm_per_m * *found.apposition_wanted) : Json();
  json["costal_insertion_found_percent"] = 100.0 * found.insertion_covered;
  json["extrapolated_regions"] = found.extrapolated;
  json["particles"] = found.mesh.rest.size();
  json["particles_without_data"] = found.particles_without_data;
  json["smallest_angle_deg"] = degrees_per_rad * found.quality.smallest_angle;
  json["folded_triangles"] = found.quality.folded;
  json["iterations"] = found.iterations;
  json["alignment_iterations"] = found.alignment.iterations;
  json["last_movement_mm"] = mm_per_m * found.moved;
  json["held_back"] = found.held_back;
  return json;
}

std::string registration_text(const Registration& found, const RegistrationVerdict& verdict) {
  const Similarity& s = found.alignment.similarity;
  std::string text = fmt::format(
      "{}: scale {:.3f}, turned {:.1f} degrees, shifted ({:.0f}, {:.0f}, {:.0f}) mm, then matched in {} "
      "iterations\n",
      verdict.done() ? "Registered" : "Not as wanted", s.scale, degrees_per_rad * s.angle(),
      mm_per_m * s.shift.x(), mm_per_m * s.shift.y(), mm_per_m * s.shift.z(), found.iterations);
  text += fmt::format("{:<30} {:^31} | {:^31} |\n", "mm", "trunk to surface", "surface to trunk");
  text += fmt::format("{:<30}", "");
  for (int direction = 0; direction < 2; ++direction)
    text += fmt::format(" {:>7} {:>7} {:>7} {:>7} |", "RMS", "median", "95 %", "most");
  text += " with data\n";
  for (const RegionFit& fit : found.fits) text += fit_rows(fit);
  text += fmt::format(
      "lung {:.0f} ml (aligned {:.0f}, matched {:.0f}), abdomen {:.0f} ml (aligned {:.0f}), zone of "
      "apposition {:.1f} mm\n",
      ml_per_m3 * found.final.lung, ml_per_m3 * found.aligned.lung, ml_per_m3 * found.matched.lung,
      ml_per_m3 * found.final.abdomen, ml_per_m3 * found.aligned.abdomen, mm_per_m * found.apposition_length);
  text +=
      found.insertion_covered > 0.0
          ? fmt::format(
                "costal insertion: on the lower border of the surface, on {:.0f} % of the way around\n",
                100.0 * found.insertion_covered)
          : "costal insertion: extrapolated, the lower border of the surface is not it or there is none\n";
  text += fmt::format("extrapolated: {} ({} of {} particles without data)\n",
                      found.extrapolated.empty() ? "no region" : listed(found.extrapolated),
                      found.particles_without_data, found.mesh.rest.size());
  return text + fmt::format("smallest angle {:.1f} degrees, {} triangles folded\n",
                            degrees_per_rad * found.quality.smallest_angle, found.quality.folded);
}

}  // namespace trunk
