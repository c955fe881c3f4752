/// A good HDF5 file that somebody changed through HDF5 itself. Its checksums are right, so what lies behind
/// them is reached. Bytes that HDF5 never wrote are not tried here: HDF5 1.10 fails on many of them, and the
/// program reads each file first in a process of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace fuzz {

/// A good file, and the names of what is in it.
struct Hdf5Sample {
  std::vector<std::uint8_t> bytes;
  std::vector<std::string> links;       ///< paths of groups and datasets
  std::vector<std::string> attributes;  ///< "PATH@NAME"
};

/// The sample that `write` writes to a path.
[[nodiscard]] Hdf5Sample hdf5_sample(const std::function<void(const std::string&)>& write);

/// Lay the sample before a reader, with the changes that an input tells.
/// @param read  gets the path; must not throw.
void read_hdf5_input(const Hdf5Sample& sample, const std::uint8_t* data, std::size_t size,
                     const std::function<void(const std::string&)>& read);

}  // namespace fuzz
