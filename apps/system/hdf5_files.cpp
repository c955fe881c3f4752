#include "apps/system/hdf5_files.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <mutex>
#include <system_error>
#include <utility>

#include "apps/text/complaint.hpp"
#include "libmpm/files/frame_file.hpp"
#include "libmpm/files/result_file.hpp"
#include "specimen/file/specimen_file.hpp"

namespace app {
namespace {

unsigned seconds_for(const std::string& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return 20 + (error ? 0 : static_cast<unsigned>(size / 20'000'000));
}

void limit(int what, rlim_t most) {
  const struct rlimit wanted { most, most };
  (void)::setrlimit(what, &wanted);
}

/// What ends this process is nothing that anybody has to see.
void go_quiet() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU})
    (void)std::signal(signal, SIG_DFL);
  const int nowhere = ::open("/dev/null", O_WRONLY);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) (void)::dup2(nowhere, stream);
  limit(RLIMIT_CORE, 0);
}

[[noreturn]] void read_and_vanish(const std::function<void()>& read, unsigned seconds) {
  go_quiet();
  limit(RLIMIT_CPU, seconds);
  try {
    read();
  } catch (...) {  // NOLINT(bugprone-empty-catch): the program itself will meet it
  }
  ::_exit(0);
}

int status_of(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0)
    if (errno != EINTR) return 0;
  return status;
}

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw Rejected(Exit::data, path, "is damaged: " + why, "", "take a copy of it, or make it again");
}

}  // namespace

void try_reading(const std::string& path, const std::function<void()>& read, unsigned seconds) {
  const pid_t process = ::fork();
  if (process < 0) return;
  if (process == 0) read_and_vanish(read, seconds > 0 ? seconds : seconds_for(path));
  const int status = status_of(process);
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGINT || signal == SIGTERM || signal == SIGHUP)
    return;  // meant for the program, which has it too
  if (signal == SIGXCPU || signal == SIGKILL) refuse(path, "HDF5 comes to no end with it");
  if (status != 0) refuse(path, "HDF5 fails on it");
}

namespace {

Hdf5Turn locked() {
  static std::mutex mutex;
  return std::make_shared<const std::scoped_lock<std::mutex>>(mutex);
}

std::function<Hdf5Turn()>& way() {
  static std::function<Hdf5Turn()> take = locked;
  return take;
}

}  // namespace

Hdf5Turn hdf5_turn() { return way()(); }

void take_hdf5_turns_by(std::function<Hdf5Turn()> take) { way() = std::move(take); }

namespace {

template <class Read>
auto tried(const std::string& path, Read read) {
  try_reading(path, [&] { (void)read(path); });
  return read(path);
}

}  // namespace

specimen::Specimen read_specimen(const std::string& path) { return tried(path, specimen::read_specimen); }

mpm::Result read_result(const std::string& path) { return tried(path, mpm::read_result); }

std::string read_scene_text(const std::string& path) { return tried(path, mpm::read_scene_text); }

mpm::Frame read_frame(const std::string& path) { return tried(path, mpm::read_frame); }

mpm::Frame read_frame_heading(const std::string& path) { return tried(path, mpm::read_frame_heading); }

}  // namespace app
