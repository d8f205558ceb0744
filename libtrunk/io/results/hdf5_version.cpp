#include "results/hdf5_version.hpp"

#include <fmt/format.h>
#include <hdf5.h>

namespace trunk {

std::string hdf5_version() {
  unsigned major = 0, minor = 0, patch = 0;
  H5get_libversion(&major, &minor, &patch);
  return fmt::format("{}.{}.{}", major, minor, patch);
}

}  // namespace trunk
