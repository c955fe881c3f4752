/// Version of the HDF5 library in use.
#pragma once

#include <string>

namespace mpm {

[[nodiscard]] std::string hdf5_version();  ///< e.g. "1.10.8", from the loaded library

}  // namespace mpm
