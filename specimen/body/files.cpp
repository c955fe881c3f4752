#include "specimen/body/files.hpp"

#include <fcntl.h>
#include <openssl/evp.h>
#include <unistd.h>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>
#include <stdexcept>
#include <system_error>

#include "specimen/body/error.hpp"

namespace specimen {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& reason, const std::string& cure = {}) {
  throw Error(path, "could not be written: " + reason, {}, cure, Fault::write);
}

[[noreturn]] void fail_with_errno(const std::string& path) {
  const int code = errno;
  fail(path, std::generic_category().message(code), code == ENOENT ? "create its folder first" : "");
}

/// A file under a name of its own, removed again unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& target) : target_(target), name_(unique_name(target)) {
    file_ = ::open(name_.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file_ < 0) fail_with_errno(target_);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (file_ >= 0) ::close(file_);
    if (!renamed_) ::unlink(name_.c_str());
  }

  void write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const ssize_t count = ::write(file_, bytes.data(), bytes.size());
      if (count < 0 && errno != EINTR) fail_with_errno(target_);
      if (count > 0) bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
  }

  /// Some disks report only here that they are full.
  void flush_and_close() {
    if (::fsync(file_) != 0) fail_with_errno(target_);
    const int file = file_;
    file_ = -1;
    if (::close(file) != 0) fail_with_errno(target_);
  }

  void rename_to_target() {
    if (std::rename(name_.c_str(), target_.c_str()) != 0) fail_with_errno(target_);
    renamed_ = true;
  }

 private:
  /// Two threads or two programs that write one path must not share their unfinished file.
  static std::string unique_name(const std::string& target) {
    static std::atomic<unsigned> serial{0};
    return target + ".tmp-" + std::to_string(::getpid()) + "-" + std::to_string(serial++);
  }

  std::string target_;
  std::string name_;
  int file_ = -1;
  bool renamed_ = false;
};

/// So that the new name survives a power cut. Not every file system can do it, and the bytes are safe anyway.
void flush_folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const int file = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_CLOEXEC | O_DIRECTORY);
  if (file < 0) return;
  ::fsync(file);
  ::close(file);
}

}  // namespace

void replace_file(const std::string& path, const std::function<void(const ByteSink&)>& produce) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status)) fail(path, "it is a folder", "give the name of a file");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    fail(path, "it is a device or a pipe, and a rename would replace it", "give the name of a file");
  TemporaryFile file(path);
  produce([&](std::span<const std::byte> bytes) { file.write(bytes); });
  file.flush_and_close();
  file.rename_to_target();
  flush_folder_of(path);
}

void replace_file(const std::string& path, std::span<const std::byte> bytes) {
  replace_file(path, [&](const ByteSink& sink) { sink(bytes); });
}

namespace {

/// One SHA-256 under way.
class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new(), &EVP_MD_CTX_free) {
    if (!context_) throw std::bad_alloc();
    require(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr));
  }

  void add(const void* bytes, std::size_t count) { require(EVP_DigestUpdate(context_.get(), bytes, count)); }

  std::string hexadecimal() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int length = 0;
    require(EVP_DigestFinal_ex(context_.get(), digest.data(), &length));
    static constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (unsigned int i = 0; i < length; ++i) {
      text += digits[digest[i] >> 4U];
      text += digits[digest[i] & 15U];
    }
    return text;
  }

 private:
  static void require(int ok) {
    if (ok != 1) throw std::runtime_error("OpenSSL offers no SHA-256 here");
  }

  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

[[noreturn]] void cannot_read(const std::string& path, const std::string& reason) {
  throw Error(path, reason, "must be a file that can be read", {}, Fault::write);
}

}  // namespace

std::string sha256_of_file(const std::string& path) {
  if (std::filesystem::is_directory(path)) cannot_read(path, "is a folder");
  if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path))
    cannot_read(path, "is not a regular file");  // opening a pipe would wait for its other end
  const std::unique_ptr<std::FILE, decltype(&std::fclose)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) cannot_read(path, std::generic_category().message(errno));
  Sha256 sum;
  std::array<unsigned char, 65536> piece;
  while (const std::size_t count = std::fread(piece.data(), 1, piece.size(), file.get()))
    sum.add(piece.data(), count);
  if (std::ferror(file.get()) != 0) cannot_read(path, std::generic_category().message(errno));
  return sum.hexadecimal();
}

std::string sha256_of_text(std::string_view text) {
  Sha256 sum;
  sum.add(text.data(), text.size());
  return sum.hexadecimal();
}

}  // namespace specimen
