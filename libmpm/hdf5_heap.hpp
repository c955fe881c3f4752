/// A look at the part of an HDF5 file that has no checksum. Not installed: private to result_file*.
#pragma once

#include <string>

namespace mpm::hdf5 {

/// Look through every global heap of a file, where the texts of any length lie. HDF5 1.10 goes through a heap
/// whose lengths are wrong without an end, or beyond its end.
/// @throws Fault when a length is wrong.   A file that cannot be read passes: opening it says why.
void require_sound_heaps(const std::string& path);

}  // namespace mpm::hdf5
