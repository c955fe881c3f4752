/// Opening and reading of picture files.
#pragma once

#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "specimen/body/error.hpp"

namespace specimen {

/// Bytes of a file.
using Bytes = std::vector<std::uint8_t>;

struct CloseFile {
  void operator()(std::FILE* file) const { (void)std::fclose(file); }
};

/// An open picture file, and its limits.
struct PictureSource {
  std::string path;
  std::int64_t max_pixels = 0;  ///< larger pictures are refused
  std::int64_t bytes = 0;       ///< length of the file
  std::unique_ptr<std::FILE, CloseFile> file;
  /// Told the size once it has passed its check; only once.
  mutable std::function<void(std::int64_t rows, std::int64_t cols)> before_pixels{};
};

/// The error for a file with invalid content: "path: problem; cure".
[[nodiscard]] Error bad_picture(const std::string& path, std::string problem, std::string cure = {});

/// The error for a file of several pictures, where nobody can say which one is meant: "path: holds several
/// pages; ...".
[[nodiscard]] Error several_pictures(const std::string& path, std::string what_it_is);

/// Open a picture for reading.   @throws Error (Fault::write) with the reason from the system.
[[nodiscard]] PictureSource open_picture(const std::string& path, std::int64_t max_pixels);

/// Read exactly `count` bytes.   @throws Error if the file ends before.
void read_exactly(const PictureSource& source, std::uint8_t* bytes, std::size_t count);

}  // namespace specimen
