/// SHA-256, so that a specimen can say which bytes it was made from.
#pragma once

#include <string>
#include <string_view>

namespace specimen {

/// Lower-case hexadecimal SHA-256 of a file's bytes, read in pieces.   @throws Error when it cannot be read.
[[nodiscard]] std::string sha256_of_file(const std::string& path);

/// The same of a text.
[[nodiscard]] std::string sha256_of_text(std::string_view text);

}  // namespace specimen
