#include "sheet/ring_weights.hpp"

#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/random.hpp"

using namespace trunk;
using namespace trunk::test;

namespace {

const Vec3d up{0, 0, 1};

std::vector<Vec3d> regular(int count) {
  std::vector<Vec3d> ring;
  for (int k = 0; k < count; ++k) {
    const double angle = 0.3 + 2.0 * std::numbers::pi * k / count;
    ring.push_back({0.05 * std::cos(angle), 0.05 * std::sin(angle), 0.0});
  }
  return ring;
}

/// The weighted centre over the spacing, and how far the second moment is from that of a circle.
struct Moments {
  double off_centre, anisotropy;
};

Moments moments(const std::vector<Vec3d>& ring, const std::vector<double>& weight) {
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t j = 0; j < ring.size(); ++j) {
    const Vec3d& r = ring[j];
    x += weight[j] * r.x();
    y += weight[j] * r.y();
    xx += weight[j] * r.x() * r.x();
    xy += weight[j] * r.x() * r.y();
    yy += weight[j] * r.y() * r.y();
  }
  return {std::hypot(x, y) / std::sqrt(xx + yy), std::hypot(xx - yy, 2.0 * xy) / (xx + yy)};
}

std::vector<double> even(std::size_t count) {
  return std::vector<double>(count, 1.0 / static_cast<double>(count));
}

}  // namespace

TEST_CASE("Neighbours of a regular ring weigh the same", "[unit][sheet]") {
  for (const int count : {3, 4, 5, 6, 7, 8, 12, 64})
    for (const double w : ring_weights(regular(count), up)) CHECK(w == Approx(1.0 / count).epsilon(1e-8));
}

TEST_CASE("Weights centre a ring over its particle and make it round", "[unit][sheet]") {
  // The ring of a mesh with its diagonals one way and an aspect of 2, and rings with 7 and 5 neighbours.
  const std::vector<std::vector<Vec3d>> rings = {
      {{2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {-2, 0, 0}, {-2, -1, 0}, {0, -1, 0}},
      {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}},
      {{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}};
  for (const auto& ring : rings) {
    const Moments plain = moments(ring, even(ring.size())), weighted = moments(ring, ring_weights(ring, up));
    CAPTURE(ring.size(), plain.off_centre, weighted.off_centre, plain.anisotropy, weighted.anisotropy);
    CHECK(weighted.off_centre < 1e-5);
    CHECK(weighted.anisotropy < 0.3 * plain.anisotropy);
  }
}

TEST_CASE("Weights keep their bound and their sum, and turn with the ring", "[property][sheet]") {
  Random random(71);
  for (int n = 0; n < 200; ++n) {
    std::vector<Vec3d> ring;
    const int count = 3 + static_cast<int>(random.below(8));
    for (int k = 0; k < count; ++k) {
      const double angle = 2.0 * std::numbers::pi * (k + random.between(0.0, 0.9)) / count;
      const double far = random.between(0.01, 0.15);
      ring.push_back({far * std::cos(angle), 0.3 * far * std::sin(angle), 0.1 * random.between(-far, far)});
    }
    const std::vector<double> weight = ring_weights(ring, up);
    double sum = 0.0;
    for (const double w : weight) {
      sum += w;
      CHECK(w > 0.14 / count);  // 0.15/m, divided by a sum that is near 1
    }
    CHECK(sum == Approx(1.0).epsilon(1e-14));
    std::vector<Vec3d> turned;  // by 1 rad, and in another order
    for (int k = 0; k < count; ++k) {
      const Vec3d& r = ring[static_cast<std::size_t>((k + 1) % count)];
      turned.push_back({std::cos(1.0) * r.x() - std::sin(1.0) * r.y(),
                        std::sin(1.0) * r.x() + std::cos(1.0) * r.y(), r.z()});
    }
    const std::vector<double> again = ring_weights(turned, up);
    for (int k = 0; k < count; ++k)
      CHECK(again[static_cast<std::size_t>(k)] ==
            Approx(weight[static_cast<std::size_t>((k + 1) % count)]).epsilon(1e-7));
  }
}
