#include "apps/system/hdf5_files.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <mutex>
#include <new>
#include <system_error>
#include <utility>

#include "apps/text/complaint.hpp"
#include "libmpm/files/frame_file.hpp"
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

struct Ended {
  int status = 0;
  double seconds = 0;  ///< of computing
};

Ended ended(pid_t process) {
  Ended how;
  rusage used{};
  while (::wait4(process, &how.status, 0, &used) < 0)
    if (errno != EINTR) return {};
  for (const timeval& part : {used.ru_utime, used.ru_stime})
    how.seconds += static_cast<double>(part.tv_sec) + 1e-6 * static_cast<double>(part.tv_usec);
  return how;
}

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw Rejected(Exit::data, path, "is damaged: " + why, "", "take a copy of it, or make it again");
}

/// In a process of its own.   @param reserve  of memory beyond the limit of the program [bytes].
Ended trial(const std::function<void()>& read, unsigned seconds, rlim_t reserve) {
  const pid_t process = ::fork();
  if (process < 0) return {};
  if (process > 0) return ended(process);
  struct rlimit memory {};
  if (::getrlimit(RLIMIT_DATA, &memory) == 0 && memory.rlim_cur < memory.rlim_max) {
    memory.rlim_cur = std::min(memory.rlim_max, memory.rlim_cur + reserve);
    (void)::setrlimit(RLIMIT_DATA, &memory);
  }
  read_and_vanish(read, seconds);
}

}  // namespace

void try_reading(const std::string& path, const std::function<void()>& read, unsigned seconds) {
  const unsigned most = seconds > 0 ? seconds : seconds_for(path);
  const auto [status, taken] = trial(read, most, 0);
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGINT || signal == SIGTERM || signal == SIGHUP)
    return;  // meant for the program, which has it too
  if (signal == SIGKILL && taken < 0.9 * most) throw std::bad_alloc();  // the system ends what takes too much
  if (signal == SIGXCPU || signal == SIGKILL) refuse(path, "HDF5 comes to no end with it");
  if (status == 0) return;
  // Without memory HDF5 fails on good files too.
  if (trial(read, most, rlim_t{1} << 28U).status == 0) throw std::bad_alloc();
  refuse(path, "HDF5 fails on it");
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

mpm::RunTexts read_run_texts(const std::string& path) { return tried(path, mpm::read_run_texts); }

mpm::Frame read_frame(const std::string& path) { return tried(path, mpm::read_frame); }

mpm::Frame read_frame_heading(const std::string& path) { return tried(path, mpm::read_frame_heading); }

std::vector<mpm::TableColumn> read_table(const std::string& path) { return tried(path, mpm::read_table); }

}  // namespace app
