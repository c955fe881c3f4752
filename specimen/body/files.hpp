/// Writing of files completely or not at all, and the SHA-256 of files.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace specimen {

/// Write bytes to a temporary name beside `path`, flush them to disk, close and rename the file. A reader
/// sees the old or the new file, never a part. On failure the old file remains and the temporary file is
/// removed.
/// @throws Error (Fault::write) naming the path and the reason from the system.
void replace_file(const std::string& path, std::span<const std::byte> bytes);

/// Takes the next bytes of a file.
using ByteSink = std::function<void(std::span<const std::byte>)>;

/// The same for a file that does not fit in memory.
/// @param produce  passes the bytes to its sink, piece by piece. If it throws, the old file remains.
void replace_file(const std::string& path, const std::function<void(const ByteSink&)>& produce);

/// SHA-256 of the bytes of a file, in lower-case hexadecimal.   @throws Error if it cannot be read.
[[nodiscard]] std::string sha256_of_file(const std::string& path);

/// SHA-256 of a text, in lower-case hexadecimal.
[[nodiscard]] std::string sha256_of_text(std::string_view text);

}  // namespace specimen
