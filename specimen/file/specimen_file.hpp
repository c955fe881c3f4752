/// specimen.h5: labels, phases, pixel size, inclusions, rings, provenance.
#pragma once

#include <string>

#include "specimen/body/specimen.hpp"

namespace specimen {

/// Write a specimen: to a temporary name beside `path`, flushed and closed, then renamed. Every dataset is
/// compressed and carries a Fletcher-32 checksum; the same specimen gives the same bytes.
/// @throws Error naming the file: for a specimen that is not valid, or a disk that fails (Fault::write).
void write_specimen(const std::string& path, const Specimen& specimen);

/// Read a specimen and check it: extents before memory is asked for, types, links, checksums, labels within
/// the phase table, ids.
/// @throws Error naming the file and the dataset that is wrong; Fault::write when it cannot be opened at all.
[[nodiscard]] Specimen read_specimen(const std::string& path);

}  // namespace specimen
