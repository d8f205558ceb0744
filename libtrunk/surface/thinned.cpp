#include "surface/thinned.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "surface/repair.hpp"

namespace trunk {
namespace {

MeasuredSurface clustered(const MeasuredSurface& s, double cube) {
  std::map<std::tuple<long, long, long>, int> cubes;
  std::vector<int> cluster;
  std::vector<double> count;
  MeasuredSurface result{s.name, {}, {}};
  for (const Vec3d& p : s.points) {
    const auto place = [&](double x) { return std::lround(x / cube); };
    const auto [at, is_new] =
        cubes.try_emplace({place(p.x()), place(p.y()), place(p.z())}, static_cast<int>(cubes.size()));
    if (is_new) {
      result.points.emplace_back();
      count.push_back(0.0);
    }
    const auto c = static_cast<std::size_t>(at->second);
    cluster.push_back(at->second);
    result.points[c] += p;
    count[c] += 1.0;
  }
  for (std::size_t c = 0; c < count.size(); ++c) result.points[c] = (1.0 / count[c]) * result.points[c];
  std::set<Triangle> seen;
  for (Triangle t : s.triangles) {
    for (int& i : t) i = cluster[static_cast<std::size_t>(i)];
    Triangle sorted = t;
    std::sort(sorted.begin(), sorted.end());
    if (sorted[0] != sorted[1] && sorted[1] != sorted[2] && seen.insert(sorted).second)
      result.triangles.push_back(t);
  }
  return result;
}

}  // namespace

MeasuredSurface thinned(const MeasuredSurface& surface, std::size_t most_triangles) {
  MeasuredSurface result = surface;
  for (double cube = largest_extent(surface) / 200.0; result.triangles.size() > most_triangles; cube *= 1.3)
    result = clustered(surface, cube);
  return result;
}

}  // namespace trunk
