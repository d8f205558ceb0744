#pragma once

#include <string>

namespace trunk {

/// Version of the HDF5 library in use, as in "1.10.8".
std::string hdf5_version();

}  // namespace trunk
