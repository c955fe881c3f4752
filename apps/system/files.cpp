#include "apps/system/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <regex>
#include <system_error>
#include <utility>

#include "apps/text/complaint.hpp"
#include "apps/text/words.hpp"
#include "libmpm/scene/error.hpp"
#include "specimen/body/error.hpp"

namespace app {

std::string ending_of(const std::string& path) {
  return lower(std::filesystem::path(path).extension().string());
}

void require_regular_file(const std::string& path) {
  std::error_code unknown;
  const std::filesystem::file_status status = std::filesystem::status(path, unknown);
  if (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status) ||
      std::filesystem::is_directory(status))
    return;
  throw Rejected(Exit::io, path, "is not a regular file", "must be a file that can be read",
                 "save what comes from the pipe or device in a file first");
}

std::string read_text_file(const std::string& path, std::size_t longest) {
  require_regular_file(path);
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
    throw Rejected(Exit::io, path, reason, "must be a file that can be read");
  }
  if (text.size() > longest)
    throw Rejected(Exit::data, path, "is too long", fmt::format("at most {} MiB are read", longest >> 20U));
  return text;
}

}  // namespace app

NotWritten::NotWritten(std::vector<mpm::FileError> all)
    : mpm::FileError(all.front()), files(std::move(all)) {}

void Attempts::operator()(const std::function<void()>& write) {
  try {
    write();
  } catch (const mpm::FileError& error) {
    failures_.push_back(error);
  } catch (const specimen::Error& error) {
    if (error.fault != specimen::Fault::write) throw;
    failures_.emplace_back(error.field, error.value, error.allowed, error.cure);
  }
}

void Attempts::conclude() const {
  if (!failures_.empty()) throw NotWritten(failures_);
}

namespace app {
namespace {

namespace fs = std::filesystem;

int open_lock(const fs::path& lock) {
  const int descriptor = ::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0)
    throw mpm::FileError(lock.string(), "cannot be created: " + std::generic_category().message(errno), "",
                         "choose a folder that may be written to");
  return descriptor;
}

/// Not when the program that held it has removed it since it was opened.
bool is_still_there(int descriptor, const fs::path& lock) {
  struct stat opened = {}, found = {};
  return ::fstat(descriptor, &opened) == 0 && ::stat(lock.c_str(), &found) == 0 &&
         opened.st_dev == found.st_dev && opened.st_ino == found.st_ino;
}

/// @return false while another program has the lock.
bool take(int descriptor) { return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK; }

int hold(const fs::path& lock) {
  for (;;) {
    const int descriptor = open_lock(lock);
    const bool taken = take(descriptor);
    if (taken && is_still_there(descriptor, lock)) return descriptor;
    ::close(descriptor);
    if (!taken)
      throw Rejected(Exit::interrupted, lock.parent_path().string(), "another program is writing a run there",
                     "", "wait until it has ended, or choose another folder");
  }
}

/// The process that writes the file of that name for now: "x.12-3.tmp" or "x.tmp-12-3"; 0 = no such name.
int writer_of(const std::string& name) {
  static const std::regex pattern(R"(.+[.](?:([0-9]{1,9})-[0-9]+[.]tmp|tmp-([0-9]{1,9})-[0-9]+))");
  std::smatch parts;
  if (!std::regex_match(name, parts, pattern)) return 0;
  return std::stoi(parts[1].matched ? parts[1] : parts[2]);
}

}  // namespace

namespace {

template <class IsDoomed>
void remove_temporary(const fs::path& folder, const IsDoomed& is_doomed) {
  std::error_code error;
  std::vector<fs::path> doomed;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const int writer = writer_of(entry.path().filename().string());
    if (writer > 0 && is_doomed(entry, writer)) doomed.push_back(entry.path());
  }
  for (const fs::path& path : doomed) fs::remove(path, error);
}

}  // namespace

void remove_remainders(const fs::path& folder) {
  remove_temporary(folder, [](const fs::directory_entry&, int writer) {
    // In containers every program may have the number of this one.
    return writer == ::getpid() || (::kill(writer, 0) != 0 && errno == ESRCH);
  });
}

void remove_old_remainders(const fs::path& folder) {
  remove_temporary(folder, [](const fs::directory_entry& entry, int) {
    std::error_code error;
    const fs::file_time_type written = entry.last_write_time(error);
    return !error && fs::file_time_type::clock::now() - written > std::chrono::hours(1);
  });
}

HeldFolder::HeldFolder(const fs::path& folder)
    : lock_(folder / "in_progress.lock"), descriptor_(hold(lock_)) {}

HeldFolder::~HeldFolder() {
  if (is_still_there(descriptor_, lock_))  // else the folder was moved, and another may be in its place
    ::unlink(lock_.c_str());               // before it is let go: who opens it now makes another
  ::close(descriptor_);
}

}  // namespace app
