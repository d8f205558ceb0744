#include <bit>
#include <cstdint>
#include <limits>

#include "math/vec3.hpp"
#include "support/catch.hpp"
#include "support/random.hpp"

using namespace trunk;
using trunk::test::Random;

namespace {

/// A double that is not `double`, so that Vec3<Plain> is the general form.
struct Plain {
  double value = 0.0;
  constexpr Plain() = default;
  constexpr explicit Plain(double v) : value(v) {}
  friend constexpr Plain operator+(Plain a, Plain b) { return Plain(a.value + b.value); }
  friend constexpr Plain operator-(Plain a, Plain b) { return Plain(a.value - b.value); }
  friend constexpr Plain operator*(Plain a, Plain b) { return Plain(a.value * b.value); }
  friend constexpr Plain operator/(Plain a, Plain b) { return Plain(a.value / b.value); }
  friend constexpr Plain operator-(Plain a) { return Plain(-a.value); }
  friend constexpr bool operator<(Plain a, Plain b) { return a.value < b.value; }
  friend Plain sqrt(Plain a) { return Plain(std::sqrt(a.value)); }
};
static_assert(Scalar<Plain> && Scalar<double> && Scalar<long double>);

bool same_bits(double a, Plain b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b.value);
}
bool same_bits(const Vec3d& a, const Vec3<Plain>& b) {
  return same_bits(a.x(), b.x()) && same_bits(a.y(), b.y()) && same_bits(a.z(), b.z());
}

}  // namespace

TEST_CASE("Vec3<double> equals the general form bit for bit", "[property][math]") {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const double size = std::pow(10.0, random.between(-6, 6));
    const Vec3d a = random.vector(size), b = random.vector(1.0);
    const double k = random.between(-3, 3);
    const auto pa = lift<Plain>(a), pb = lift<Plain>(b);
    REQUIRE(same_bits(a + b, pa + pb));
    REQUIRE(same_bits(a - b, pa - pb));
    REQUIRE(same_bits(k * a, Plain(k) * pa));
    REQUIRE(same_bits(hadamard(a, b), hadamard(pa, pb)));
    REQUIRE(same_bits(turned(a), turned(pa)));
    REQUIRE(same_bits(cross(a, b), cross(pa, pb)));
    REQUIRE(same_bits(dot(a, b), dot(pa, pb)));
    REQUIRE(same_bits(norm(a), norm(pa)));
    REQUIRE(same_bits(scaled(b, a), scaled(b, pa)));
  }
}

TEST_CASE("The cross product turns x into y into z and is antisymmetric", "[unit][math]") {
  const Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  CHECK(norm(cross(x, y) - z) == 0.0);
  CHECK(norm(cross(y, z) - x) == 0.0);
  CHECK(norm(cross(z, x) - y) == 0.0);
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Vec3d a = random.vector(1), b = random.vector(1);
    CHECK(norm(cross(a, b) + cross(b, a)) == 0.0);
    CHECK(std::abs(dot(cross(a, b), a)) < 1e-15);
    // Lagrange's identity: the length is right too.
    const double area = dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b);
    CHECK(dot(cross(a, b), cross(a, b)) == Approx(area).epsilon(1e-12));
  }
}

TEST_CASE("Selection takes the first value where the mask is true", "[unit][math]") {
  const Vec3d a{1, 2, 3}, b{4, 5, 6};
  CHECK(norm(select(true, a, b) - a) == 0.0);
  CHECK(norm(select(false, a, b) - b) == 0.0);
  CHECK(select(true, 1.0L, 2.0L) == 1.0L);
}

TEST_CASE("A test for finite values sees NaN and infinity", "[unit][math]") {
  const double inf = std::numeric_limits<double>::infinity();
  CHECK(finite(0.0));
  CHECK(finite(-1e300));
  CHECK(finite(std::numeric_limits<double>::denorm_min()));
  CHECK_FALSE(finite(inf));
  CHECK_FALSE(finite(-inf));
  CHECK_FALSE(finite(std::nan("")));
}
