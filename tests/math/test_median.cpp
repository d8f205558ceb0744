#include "math/median.hpp"
#include "support/catch.hpp"

using trunk::median;
using trunk::upper_median;

TEST_CASE("Both medians of an odd number of values are the middle one", "[unit][math]") {
  CHECK(median({7.0}) == 7.0);
  CHECK(median({9.0, -1.0, 4.0}) == 4.0);
  CHECK(upper_median({7.0}) == 7.0);
  CHECK(upper_median({9.0, -1.0, 4.0}) == 4.0);
}

TEST_CASE("For an even number of values, median is the mean of the middle two and upper_median the larger",
          "[unit][math]") {
  CHECK(median({8.0, 1.0, 3.0, 2.0}) == 2.5);
  CHECK(upper_median({8.0, 1.0, 3.0, 2.0}) == 3.0);
  CHECK(median({3.0, 2.0}) == 2.5);
  CHECK(upper_median({3.0, 2.0}) == 3.0);
}

TEST_CASE("Equal values are their own median", "[unit][math]") {
  CHECK(median({2.0, 2.0, 2.0, 5.0}) == 2.0);
  CHECK(upper_median({2.0, 2.0, 2.0, 5.0}) == 2.0);
}

TEST_CASE("The median of no values is 0", "[unit][math]") {
  CHECK(median({}) == 0.0);
}
