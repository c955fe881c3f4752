/// An input of the fuzzer as a file that a reader opens by its name.
#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace fuzz {

/// In memory where the system has a folder there; removed with the program.
inline std::string temporary_path(const std::string& name) {
  const std::filesystem::path memory = "/dev/shm";
  const auto folder = std::filesystem::is_directory(memory) ? memory : std::filesystem::temp_directory_path();
  return folder / ("mesopix-fuzz-" + std::to_string(::getpid()) + "-" + name);
}

class InputFile {
 public:
  InputFile() : path_(temporary_path("input")) {}
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile() { std::filesystem::remove(path_); }

  /// Put these bytes in the place of all there was.   @return the path.
  const std::string& hold(const std::uint8_t* bytes, std::size_t size) const {
    std::filesystem::remove(
        path_);  // some disks flush a file that is cut and written again, which takes long
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
    return path_;
  }

 private:
  std::string path_;
};

}  // namespace fuzz
