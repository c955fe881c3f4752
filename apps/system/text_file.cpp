#include "apps/system/text_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "apps/text/complaint.hpp"

namespace app {

std::string read_text_file(const std::string& path, std::size_t longest) {
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  const bool folder = std::filesystem::is_directory(path);
  std::string text;
  while (!folder && stream && text.size() <= longest) {
    constexpr std::size_t piece = std::size_t{1} << 16U;
    const std::size_t before = text.size();
    text.resize(before + piece);
    stream.read(text.data() + before, piece);
    text.resize(before + static_cast<std::size_t>(stream.gcount()));
  }
  if (folder || !stream.is_open() || stream.bad()) {
    const std::string reason = folder ? "is a folder" : std::generic_category().message(errno);
    throw Rejected(Exit::io, complaint(path, reason, "must be a file that can be read"));
  }
  if (text.size() > longest)
    throw Rejected(Exit::data,
                   complaint(path, "is too long", fmt::format("at most {} MiB are read", longest >> 20U)));
  return text;
}

}  // namespace app
