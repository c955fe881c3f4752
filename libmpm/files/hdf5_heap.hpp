/// A look at the part of an HDF5 file that has no checksum. Not installed: private to hdf5_read.
#pragma once

#include <string>

namespace mpm::hdf5 {

/// Whether the lengths in every global heap of a file are right. Texts of any length lie in such heaps, and
/// the sources of virtual datasets. HDF5 1.10 goes through a heap with wrong lengths without an end, or
/// beyond its end, as soon as an attribute or a dataset that needs it is opened.
/// @return true for a file that cannot be read: opening it says why.
[[nodiscard]] bool heaps_are_sound(const std::string& path);

}  // namespace mpm::hdf5
