#include "anatomy/template_levels.hpp"

#include <gsl/gsl_interp.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace trunk {
namespace {

/// Joins two rings by triangles that face outward or up; `upper` is above or inside `lower`. Of the two
/// possible diagonals it takes the one that spans the smaller angle. Ties alternate by quadrant, so that the
/// mesh is symmetric.
void stitch(const Level& lower, const Level& upper, std::vector<Triangle>& triangles) {
  const std::size_t lower_count = lower.angles.size(), upper_count = upper.angles.size();
  const auto angle = [](const Level& level, std::size_t k) {
    const std::size_t turns = k / level.angles.size();
    return level.angles[k % level.angles.size()] + 2.0 * std::numbers::pi * static_cast<double>(turns);
  };
  const auto particle = [](const Level& level, std::size_t k) {
    return level.particles[k % level.particles.size()];
  };
  for (std::size_t i = 0, j = 0; i < lower_count || j < upper_count;) {
    const double along_lower = angle(lower, i + 1) - angle(upper, j);
    const double along_upper = angle(upper, j + 1) - angle(lower, i);
    const bool tie = std::abs(along_lower - along_upper) < 1e-9;
    const double middle = 0.5 * (angle(lower, i) + angle(lower, i + 1));
    const bool advance_lower = tie ? std::sin(2.0 * middle) > 0.0 : along_lower < along_upper;
    if (j == upper_count || (i < lower_count && advance_lower)) {
      triangles.push_back({particle(lower, i), particle(lower, i + 1), particle(upper, j)});
      ++i;
    } else {
      triangles.push_back({particle(lower, i), particle(upper, j + 1), particle(upper, j)});
      ++j;
    }
  }
}

/// Closes a ring with a fan of triangles to a point above it.
void cap(const Level& ring, const Level& tip, std::vector<Triangle>& triangles) {
  const std::size_t count = ring.particles.size();
  for (std::size_t k = 0; k < count; ++k)
    triangles.push_back({ring.particles[k], ring.particles[(k + 1) % count], tip.particles[0]});
}

/// A quantity along the profile. It has its given values at the stations and is monotone between them
/// (Steffen's method), so that nothing bulges between stations.
class AlongProfile {
 public:
  template <class Value>
  AlongProfile(const std::vector<Station>& stations, Value value) {
    for (const Station& s : stations) {
      at_.push_back(static_cast<double>(at_.size()));
      value_.push_back(value(s));
    }
    interpolation_.reset(gsl_interp_alloc(gsl_interp_steffen, at_.size()));
    gsl_interp_init(interpolation_.get(), at_.data(), value_.data(), at_.size());
  }
  double operator()(double station) const {
    return gsl_interp_eval(interpolation_.get(), at_.data(), value_.data(), station, nullptr);
  }

 private:
  struct Free {
    void operator()(gsl_interp* interpolation) const { gsl_interp_free(interpolation); }
  };
  std::vector<double> at_, value_;
  std::unique_ptr<gsl_interp, Free> interpolation_;
};

}  // namespace

Level LevelBuilder::level(const std::string& region, int count, double size, double height, double tilt) {
  Level level;
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / count;
    // Exact zeros on the midline keep left and right mirror images of each other.
    const double x = count == 1 || 4 * k == count || 4 * k == 3 * count ? 0.0 : std::cos(angle);
    const double y = k == 0 || 2 * k == count ? 0.0 : std::sin(angle);
    level.particles.push_back(static_cast<int>(mesh_.rest.size()));
    level.angles.push_back(angle);
    mesh_.rest.push_back(
        {size * geometry_.half_width * x, size * geometry_.half_depth * y, height + tilt * x});
  }
  auto& particles = mesh_.regions[region];
  particles.insert(particles.end(), level.particles.begin(), level.particles.end());
  return level;
}

std::vector<Level> LevelBuilder::levels(const std::vector<Station>& stations) {
  const int r = geometry_.resolution;
  const AlongProfile size(stations, [](const Station& s) { return s.size; });
  const AlongProfile height(stations, [](const Station& s) { return s.height; });
  const AlongProfile tilt(stations, [](const Station& s) { return s.tilt; });
  const auto around = [&](std::size_t k) { return stations[k].size == 0.0 ? 0 : r * stations[k].count; };
  std::vector<Level> result;
  for (std::size_t k = 0; k < stations.size(); ++k)
    for (int part = 0; part < (k + 1 < stations.size() ? r : 1); ++part) {
      const double at = static_cast<double>(k) + static_cast<double>(part) / r;
      const int next = part > 0 ? around(k + 1) : around(k);
      const int count = std::max(1, around(k) + (next - around(k)) * part / r);
      result.push_back(
          level(part == 0 ? stations[k].region : stations[k].above, count, size(at), height(at), tilt(at)));
    }
  return result;
}

void join(const std::vector<Level>& levels, std::vector<Triangle>& triangles) {
  for (std::size_t k = 0; k + 1 < levels.size(); ++k)
    if (levels[k + 1].particles.size() == 1)
      cap(levels[k], levels[k + 1], triangles);
    else
      stitch(levels[k], levels[k + 1], triangles);
}

void turn_over(std::vector<Triangle>& triangles) {
  for (Triangle& t : triangles) std::swap(t[1], t[2]);
}

}  // namespace trunk
