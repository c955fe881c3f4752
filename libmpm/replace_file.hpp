/// Put a whole file on disk, or nothing.
#pragma once

#include <string>
#include <string_view>

namespace mpm {

/// Write bytes to a temporary name beside `path`, flush them to the disk and rename: a reader sees the old
/// file or the new one, never a part. The temporary file is removed when anything fails.
/// @throws FileError naming the path and what the system said.
void replace_file(const std::string& path, std::string_view bytes);

}  // namespace mpm
