/// specimen.h5: labels, phases, pixel size, inclusions, rings, provenance.
#pragma once

#include <string>

#include "specimen/specimen.hpp"

namespace specimen {

/// Write a specimen: to a temporary name beside `path`, flushed and closed, then renamed. Labels are
/// compressed and carry a Fletcher-32 checksum.   @throws Error (Fault::write).
void write_specimen(const std::string& path, const Specimen& specimen);

/// Read a specimen and check it: extents, types, labels within the phase table, ids.
/// @throws Error naming the file and the dataset that is wrong.
[[nodiscard]] Specimen read_specimen(const std::string& path);

/// Lower-case hexadecimal SHA-256 of a file's bytes.   @throws Error when it cannot be read.
[[nodiscard]] std::string sha256_of_file(const std::string& path);
[[nodiscard]] std::string sha256_of_text(const std::string& text);

}  // namespace specimen
