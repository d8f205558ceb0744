#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "parallel/workers.hpp"
#include "support/catch.hpp"

using namespace trunk;

TEST_CASE("Each item is done once on any number of threads, and work stops when it is cancelled", "[unit]") {
  std::vector<std::size_t> items(500);
  std::iota(items.begin(), items.end(), std::size_t{0});
  for (unsigned threads : {1u, 2u, 7u}) {
    std::vector<int> seen(items.size(), 0);
    work_off<std::size_t>(
        items, threads, {}, [](std::size_t i) { return i; }, [&](std::size_t i) { ++seen[i]; });
    CHECK(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }));
  }
  int taken = 0;
  work_off<std::size_t>(
      items, 2, [&] { return taken >= 10; }, [](std::size_t i) { return i; }, [&](std::size_t) { ++taken; });
  CHECK(taken >= 10);
  CHECK(taken < 100);
  CHECK_THROWS_WITH(work_off<std::size_t>(
                        items, 2, {}, [](std::size_t i) { return i; },
                        [](std::size_t) { throw std::runtime_error("disk full"); }),
                    "disk full");
}
