#include "surface/axes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "errors/input_error.hpp"
#include "math/median.hpp"

namespace trunk {
namespace {

using Numbers = std::array<double, 3>;

Numbers numbers_of(const Vec3d& a) {
  return {a.x(), a.y(), a.z()};
}

constexpr std::string_view trunk_letters = "RAS", opposite_letters = "LPI";

[[noreturn]] void refuse(std::string_view text) {
  throw InputError(
      {}, fmt::format("axes '{}' found", text.substr(0, 40)),
      "three letters, one of R/L, A/P and S/I each, that say to which side x, y and z of the file "
      "grow (LPS), or the coordinates of the file that are right, forward and up (x,-z,y)");
}

/// The middles of the edges that belong to one triangle only.
std::vector<Vec3d> border_points(const MeasuredSurface& s) {
  std::map<std::pair<int, int>, int> edges;
  for (const Triangle& t : s.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++edges[std::minmax(t[i], t[(i + 1) % 3])];
  std::vector<Vec3d> border;
  for (const auto& [edge, count] : edges)
    if (count == 1)
      border.push_back(0.5 * (s.points[static_cast<std::size_t>(edge.first)] +
                              s.points[static_cast<std::size_t>(edge.second)]));
  return border;
}

struct Extent {
  Numbers low{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  double operator[](std::size_t i) const { return high[i] - low[i]; }
};

Extent extent_of(const std::vector<Vec3d>& points) {
  Extent extent;
  for (const Vec3d& p : points)
    for (std::size_t i = 0; i < 3; ++i) {
      extent.low[i] = std::min(extent.low[i], numbers_of(p)[i]);
      extent.high[i] = std::max(extent.high[i], numbers_of(p)[i]);
    }
  return extent;
}

/// Returns the net area along each axis, and its share of all area: 1 if the surface is a height field over
/// that axis.
std::pair<Numbers, Numbers> net_areas(const MeasuredSurface& s) {
  Numbers net{}, all{}, share{};
  for (const Triangle& t : s.triangles) {
    const auto at = [&](std::size_t i) { return s.points[static_cast<std::size_t>(t[i])]; };
    const Numbers area = numbers_of(cross(at(1) - at(0), at(2) - at(0)));
    for (std::size_t i = 0; i < 3; ++i) {
      net[i] += area[i];
      all[i] += std::abs(area[i]);
    }
  }
  for (std::size_t i = 0; i < 3; ++i) share[i] = all[i] > 0.0 ? std::abs(net[i]) / all[i] : 0.0;
  return {net, share};
}

/// Returns the mean height of the border in the outer fifth at the high end of an axis, minus that at its low
/// end.
double border_rise(const std::vector<Vec3d>& border, std::size_t along, std::size_t vertical, double up) {
  const Extent extent = extent_of(border);
  double sum[2] = {}, count[2] = {};
  for (const Vec3d& p : border) {
    const double at = (numbers_of(p)[along] - extent.low[along]) / extent[along];
    if (at > 0.2 && at < 0.8) continue;
    sum[at > 0.5] += up * numbers_of(p)[vertical];
    count[at > 0.5] += 1.0;
  }
  return count[0] > 0.0 && count[1] > 0.0 ? sum[1] / count[1] - sum[0] / count[0] : 0.0;
}

/// Returns the border points of the cut, if half a dome was cut across `along`, and the end of that axis
/// where they lie, -1 or +1; no points for a dome that is whole. The cut may be ragged, and short at the
/// spine.
std::pair<std::vector<Vec3d>, double> cut_across(const std::vector<Vec3d>& border, const Extent& extent,
                                                 std::size_t along, std::size_t across, std::size_t vertical,
                                                 double up) {
  constexpr double widest = 1.15, slab = 0.2, least_border = 0.2, least_depth = 0.45, least_height = 0.25,
                   from_top = 0.4;
  if (extent[along] > widest * extent[across]) return {};
  for (const double end : {-1.0, 1.0}) {
    const double at = end < 0.0 ? extent.low[along] : extent.high[along];
    std::vector<Vec3d> cut;
    for (const Vec3d& p : border)
      if (std::abs(numbers_of(p)[along] - at) < slab * extent[along]) cut.push_back(p);
    if (static_cast<double>(cut.size()) < least_border * static_cast<double>(border.size())) continue;
    const Extent of_cut = extent_of(cut);
    const double below_top = up > 0.0 ? extent.high[vertical] - of_cut.high[vertical]
                                      : of_cut.low[vertical] - extent.low[vertical];
    if (of_cut[across] > least_depth * extent[across] && of_cut[vertical] > least_height * extent[vertical] &&
        below_top < from_top * extent[vertical])
      return {std::move(cut), end};
  }
  return {};
}

char name_of_axis(std::size_t i) {
  return static_cast<char>('x' + static_cast<char>(i));
}

std::string signed_axis(std::size_t i, double sign) {
  return std::string(1, sign > 0.0 ? '+' : '-') + name_of_axis(i);
}

}  // namespace

Axes::Axes(std::string_view text) {
  std::string plain;
  for (const char c : text)
    if (c != ' ') plain += static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  std::array<bool, 3> seen{};
  std::size_t target = 0;
  if (plain.size() == 3 && plain.find_first_of("XYZ") == std::string::npos) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t same = trunk_letters.find(plain[i]), opposite = opposite_letters.find(plain[i]);
      target = std::min(same, opposite);
      if (target > 2 || std::exchange(seen[target], true)) refuse(text);
      source_[target] = i;
      sign_[target] = same <= 2 ? 1.0 : -1.0;
    }
    return;
  }
  for (std::size_t i = 0; i < plain.size(); ++target) {
    if (target > 2) refuse(text);
    sign_[target] = plain[i] == '-' ? -1.0 : 1.0;
    if (plain[i] == '-' || plain[i] == '+') ++i;
    if (i >= plain.size() || plain[i] < 'X' || plain[i] > 'Z') refuse(text);
    source_[target] = static_cast<std::size_t>(plain[i++] - 'X');
    if (std::exchange(seen[source_[target]], true)) refuse(text);
    if (i < plain.size() && plain[i++] != ',') refuse(text);
  }
  if (target != 3 || plain.back() == ',') refuse(text);
}

Vec3d Axes::operator()(const Vec3d& of_file) const {
  const Numbers p = numbers_of(of_file);
  return {sign_[0] * p[source_[0]], sign_[1] * p[source_[1]], sign_[2] * p[source_[2]]};
}

bool Axes::mirrors() const {
  const bool cyclic = source_[1] == (source_[0] + 1) % 3;
  return (sign_[0] * sign_[1] * sign_[2] > 0.0) != cyclic;
}

std::string Axes::letters() const {
  std::string text(3, '?');
  for (std::size_t i = 0; i < 3; ++i)
    text[source_[i]] = sign_[i] > 0.0 ? trunk_letters[i] : opposite_letters[i];
  return text;
}

std::optional<DomeCut> cut_of_half_dome(const MeasuredSurface& dome) {
  constexpr double height_field = 0.6;
  const std::vector<Vec3d> border = border_points(dome);
  if (border.empty() || net_areas(dome).second[2] < height_field) return std::nullopt;
  const Extent extent = extent_of(dome.points);
  const auto [cut, end] = cut_across(border, extent, 0, 1, 2, 1.0);
  if (cut.empty()) return std::nullopt;
  std::vector<double> x;
  for (const Vec3d& p : cut) x.push_back(p.x());
  return DomeCut{median(std::move(x)), -end};
}

std::optional<GuessedAxes> guess_axes(const MeasuredSurface& dome) {
  constexpr double height_field = 0.6, clear_rise = 0.05;  // our choice
  const std::vector<Vec3d> border = border_points(dome);
  const auto [net, share] = net_areas(dome);
  const auto vertical =
      static_cast<std::size_t>(std::max_element(share.begin(), share.end()) - share.begin());
  if (border.empty() || share[vertical] < height_field) return std::nullopt;
  // Half a dome, or another part of one, looks like a dome from more than one side.
  if (std::count_if(share.begin(), share.end(), [](double s) { return s >= height_field; }) > 1)
    return std::nullopt;

  const Extent extent = extent_of(dome.points);
  const double up = net[vertical] > 0.0 ? 1.0 : -1.0;
  std::size_t lateral = (vertical + 1) % 3, forward = (vertical + 2) % 3;
  if (extent[forward] > extent[lateral]) std::swap(forward, lateral);
  if (extent[lateral] < 1.1 * extent[forward]) return std::nullopt;

  GuessedAxes guess;
  const double rise = border_rise(border, forward, vertical, up);
  guess.front_known = std::abs(rise) > clear_rise * extent[vertical];
  const double front = rise < 0.0 && guess.front_known ? -1.0 : 1.0;
  // Right-handed: right = forward x up.
  const double right = (forward + 1) % 3 == vertical ? front * up : -front * up;
  const auto coordinate = [](std::size_t i, double sign) {
    return std::string(sign < 0.0 ? "-" : "") + name_of_axis(i);
  };
  guess.axes =
      Axes(coordinate(lateral, right) + "," + coordinate(forward, front) + "," + coordinate(vertical, up));
  guess.reasons =
      "the dome rises to " + signed_axis(vertical, up) + " and is widest along " + name_of_axis(lateral) +
      (guess.front_known
           ? ", and its border is higher, as in front, towards " + signed_axis(forward, front)
           : "; front and back cannot be told, so " + signed_axis(forward, front) + " was taken as front") +
      "; left and right follow from right-handed axes";
  return guess;
}

}  // namespace trunk
