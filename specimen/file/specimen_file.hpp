/// specimen.h5: labels, phases, pixel size, inclusions, rings, provenance.
#pragma once

#include <string>

#include "specimen/body/specimen.hpp"

namespace specimen {

/// Write a specimen to a temporary name beside `path`, flush, close and rename it. Every dataset is
/// compressed and has a Fletcher-32 checksum; the same specimen gives the same bytes.
/// @throws Error naming the file: for an invalid specimen, or if the disk fails (Fault::write).
void write_specimen(const std::string& path, const Specimen& specimen);

/// Read a specimen and check it: extents (before memory is allocated), types, links, checksums, labels, ids.
/// @throws Error naming the file and the faulty dataset; Fault::write if it cannot be opened.
[[nodiscard]] Specimen read_specimen(const std::string& path);

}  // namespace specimen
