/// Put a whole file on disk, or nothing.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace mpm {

/// Write bytes to a temporary name beside `path`, flush them to the disk, rename, and flush the folder: a
/// reader sees the old file or the new one, never a part, even after the power has failed. The temporary file
/// is removed when anything fails.
/// @throws FileError naming the path and what the system said.
void replace_file(const std::string& path, std::string_view bytes);

/// The same of several pieces, one behind the other.
void replace_file(const std::string& path, std::initializer_list<std::string_view> pieces);

}  // namespace mpm
