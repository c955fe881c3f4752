#include "apps/system/processes.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/sysinfo.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <system_error>

#include "apps/text/complaint.hpp"
#include "apps/text/version.hpp"

namespace app {
namespace {

volatile std::sig_atomic_t noted = 0;
volatile std::sig_atomic_t keys = 0;  ///< how often Ctrl-C was pressed

extern "C" void note_signal(int signal) {
  noted = 1;
  // A third Ctrl-C ends the program; the second may come while the results so far are being written. A second
  // SIGTERM changes nothing: timeout and batch systems send it twice at once.
  if (signal == SIGINT) {
    keys = keys + 1;
    if (keys > 1) std::signal(signal, SIG_DFL);
  }
}

}  // namespace

InterruptGuard::InterruptGuard() {
  noted = 0;
  keys = 0;
  std::signal(SIGINT, note_signal);
  std::signal(SIGTERM, note_signal);
  std::signal(SIGUSR1, note_signal);
  hang_up_before_ = std::signal(SIGHUP, note_signal);
  if (hang_up_before_ == SIG_IGN) std::signal(SIGHUP, SIG_IGN);  // as nohup has it
  pipe_before_ = std::signal(SIGPIPE, SIG_IGN);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGUSR1, SIG_DFL);
  std::signal(SIGHUP, hang_up_before_);
  std::signal(SIGPIPE, pipe_before_);
}

bool InterruptGuard::interrupted() const { return noted != 0; }

namespace {

std::string first_line(const char* path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

}  // namespace

std::uint64_t memory_to_take(std::uint64_t machine, const std::string& container) {
  std::uint64_t allowed = 0;
  const auto read = std::from_chars(container.data(), container.data() + container.size(), allowed);
  return read.ec == std::errc() ? std::min(machine, allowed) : machine;  // "max" is no limit
}

void limit_memory() {
  struct sysinfo about {};
  struct rlimit limit {};
  if (build().sanitized || ::sysinfo(&about) != 0 || ::getrlimit(RLIMIT_DATA, &limit) != 0) return;
  const std::uint64_t machine = (std::uint64_t{about.totalram} + about.totalswap) * about.mem_unit;
  const rlim_t wanted = memory_to_take(machine, first_line("/sys/fs/cgroup/memory.max"));
  limit.rlim_cur =
      std::min(wanted, std::min(limit.rlim_cur, limit.rlim_max));  // RLIM_INFINITY is the largest
  (void)::setrlimit(RLIMIT_DATA, &limit);                          // without it all works as it did
}

namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using MemoryFile = std::unique_ptr<std::FILE, Close>;

/// A file in memory, so that another program can be asked even when no disk takes a byte.
MemoryFile memory_file() {
  const int descriptor = ::memfd_create("output", MFD_CLOEXEC);
  MemoryFile file(descriptor < 0 ? nullptr : ::fdopen(descriptor, "w+"));
  if (!file)
    throw Rejected(Exit::io, "output of another program", std::strerror(errno), "close other programs");
  return file;
}

std::string text_of(std::FILE* file) {
  std::fseek(file, 0, SEEK_END);
  std::string text(static_cast<std::size_t>(std::max(0L, std::ftell(file))), '\0');
  std::rewind(file);
  text.resize(std::fread(text.data(), 1, text.size(), file));
  return text;
}

int wait_for(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

ProgramOutcome run_other_program(const std::vector<std::string>& words) {
  std::vector<std::string> copies = words;
  std::vector<char*> arguments;
  for (std::string& word : copies) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const MemoryFile out = memory_file(), err = memory_file();
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&files, ::fileno(out.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, ::fileno(err.get()), STDERR_FILENO);
  pid_t process = 0;
  const int error = ::posix_spawnp(&process, arguments[0], &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) throw Rejected(Exit::io, words[0], std::strerror(error), "must be a program in the PATH");
  const int code = wait_for(process);
  return {code, text_of(out.get()), text_of(err.get())};
}

std::string this_program() {
  std::error_code error;
  const std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? "mesopix" : path.string();
}

}  // namespace app
