/// Files of taught classifiers: NAME.mesomodel.
#pragma once

#include <string>

#include "specimen/teach/taught.hpp"

namespace specimen {

/// The bytes of a file: a line "mesopix model", lines of what was taught in words that a person can read, an
/// empty line, the trees in little-endian binary, and the SHA-256 of all that.
[[nodiscard]] std::string encode_model(const TaughtModel& model);

/// @param path  for messages.
/// @throws Error for what is no model, is damaged, or was taught with other features or by a later version.
[[nodiscard]] TaughtModel decode_model(const std::string& bytes, const std::string& path);

/// Read a file.   @throws Error as above, and if it cannot be read.
[[nodiscard]] TaughtModel read_model(const std::string& path);

}  // namespace specimen
