#include "apps/text_file.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include "apps/complaint.hpp"

namespace app {

std::string read_text_file(const std::string& path) {
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  const bool folder = std::filesystem::is_directory(path);
  std::ostringstream text;
  if (stream.is_open() && stream.peek() != std::ifstream::traits_type::eof()) text << stream.rdbuf();
  if (folder || !stream.is_open() || stream.bad()) {
    const std::string reason = folder ? "is a folder" : std::generic_category().message(errno);
    throw Rejected(Exit::io, complaint(path, reason, "must be a file that can be read"));
  }
  return text.str();
}

}  // namespace app
