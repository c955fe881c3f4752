/// result.h5: history, failure maps and figures of a run.
#pragma once

#include <string>

#include "libmpm/result.hpp"

namespace mpm {

/// Write a result, written to a temporary name, flushed, closed and renamed; every dataset carries its
/// `unit`.
/// @param scene_text  the resolved scene, kept as an attribute.   @throws FileError.
void write_result(const std::string& path, const Result& result, const std::string& scene_text);

/// @throws FileError naming the file and what is wrong.
[[nodiscard]] Result read_result(const std::string& path);

}  // namespace mpm
