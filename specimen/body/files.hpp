/// Files that are either wholly there or not at all.
/// SHA-256, so that a specimen can say which bytes it was made from.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace specimen {

/// Put bytes on disk as `path`: written to a temporary name beside it, flushed to the disk, closed, renamed.
/// Whoever reads `path` meanwhile sees the old file or the new one, never a part; a failure leaves the old
/// one and no temporary file.
/// @throws Error (Fault::write) naming the path and the system's reason.
void replace_file(const std::string& path, std::span<const std::byte> bytes);

/// Takes the next bytes of a file.
using ByteSink = std::function<void(std::span<const std::byte>)>;

/// The same for a file that is too large to be held in memory.
/// @param produce  hands the bytes to the sink that it is given, piece by piece; what it throws leaves the
/// old file as well.
void replace_file(const std::string& path, const std::function<void(const ByteSink&)>& produce);

/// Lower-case hexadecimal SHA-256 of a file's bytes, read in pieces.   @throws Error when it cannot be read.
[[nodiscard]] std::string sha256_of_file(const std::string& path);

/// The same of a text.
[[nodiscard]] std::string sha256_of_text(std::string_view text);

}  // namespace specimen
