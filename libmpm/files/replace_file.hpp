/// Write a file completely or not at all.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace mpm {

/// Write bytes to a temporary name beside `path`, flush them to disk, rename the file, and flush the folder.
/// A reader sees the old or the new file, never a part, even after a power cut. The temporary file is removed
/// on failure.
/// @throws FileError naming the path and the reason from the system.
void replace_file(const std::string& path, std::string_view bytes);

/// The same for several pieces, one after another.
void replace_file(const std::string& path, std::initializer_list<std::string_view> pieces);

}  // namespace mpm
