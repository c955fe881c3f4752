/// Files that are either wholly there or not at all.
#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace specimen {

/// Put bytes on disk as `path`: written to a temporary name beside it, flushed to the disk, closed, renamed.
/// Whoever reads `path` meanwhile sees the old file or the new one, never a part; a failure leaves the old
/// one and no temporary file.
/// @throws Error (Fault::write) naming the path and the system's reason.
void replace_file(const std::string& path, std::span<const std::byte> bytes);

}  // namespace specimen
