#pragma once

#include <string>

namespace trunk {

/// Returns the version of the HDF5 library in use, such as "1.10.8".
std::string hdf5_version();

}  // namespace trunk
