/// Which HDF5 reads and writes the files.
#pragma once

#include <string>

namespace mpm {

[[nodiscard]] std::string hdf5_version();  ///< "1.10.8", asked of the library that is loaded

}  // namespace mpm
