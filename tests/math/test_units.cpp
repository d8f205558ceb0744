#include "math/units.hpp"
#include "support/catch.hpp"

#include <cmath>

using namespace trunk;

TEST_CASE("The two directions of a unit undo each other", "[unit][math]") {
  CHECK(m_per_mm * mm_per_m == 1.0);
  CHECK(m3_per_ml * ml_per_m3 == 1.0);
  CHECK(m3_per_litre * litres_per_m3 == 1.0);
  CHECK(s_per_ms * ms_per_s == 1.0);
  CHECK(rad_per_degree * degrees_per_rad == Approx(1.0).epsilon(1e-15));
}

TEST_CASE("Units have their standard sizes", "[unit][math]") {
  CHECK(1000.0 * m3_per_ml == Approx(m3_per_litre).epsilon(1e-15));
  CHECK(std::pow(10.0 * m_per_mm, 3) == Approx(m3_per_ml).epsilon(1e-15));
  // Conventional density of water 1000 kg/m3 and of mercury 13595.1 kg/m3, standard gravity 9.80665 m/s2.
  CHECK(Pa_per_cmH2O == Approx(0.01 * 1000.0 * 9.80665).epsilon(1e-12));
  CHECK(Pa_per_mmHg == Approx(1e-3 * 13595.1 * 9.80665).epsilon(1e-6));
  CHECK(180.0 * rad_per_degree == Approx(std::acos(-1.0)).epsilon(1e-15));
}
