#include "apps/command/command.hpp"

#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

namespace app {

InputKind kind_of_input(const std::string& path) {
  if (std::filesystem::is_directory(path)) return InputKind::folder;
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw Rejected(
        Exit::io, complaint(path, std::generic_category().message(errno), "must be a file that can be read"));
  std::array<char, 8> start{};
  stream.read(start.data(), start.size());
  using namespace std::string_view_literals;
  if (std::string_view(start.data(), start.size()) == "\x89HDF\r\n\x1a\n"sv) return InputKind::hdf5;
  return std::filesystem::path(path).extension() == ".toml" ? InputKind::scene : InputKind::picture;
}

}  // namespace app
