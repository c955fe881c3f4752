#include "apps/system/processes.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/sysinfo.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "apps/text/complaint.hpp"
#include "apps/text/version.hpp"

namespace app {
namespace {

volatile std::sig_atomic_t noted = 0;

extern "C" void note_signal(int signal) {
  noted = 1;
  // A second Ctrl-C ends the program. A second SIGTERM does not: timeout and batch systems send it twice at
  // once.
  if (signal == SIGINT) std::signal(signal, SIG_DFL);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  noted = 0;
  std::signal(SIGINT, note_signal);
  std::signal(SIGTERM, note_signal);
  std::signal(SIGUSR1, note_signal);
  pipe_before_ = std::signal(SIGPIPE, SIG_IGN);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  std::signal(SIGUSR1, SIG_DFL);
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

/// Both ends are closed with it.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), 0) != 0)
      throw Rejected(Exit::io, complaint("pipe", std::strerror(errno), "close other programs"));
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  [[nodiscard]] int end(std::size_t which) const { return ends_[which]; }
  void close_end(std::size_t which) {
    if (ends_[which] >= 0) ::close(ends_[which]);
    ends_[which] = -1;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

/// The files that a program begins with.
class Files {
 public:
  Files() { posix_spawn_file_actions_init(&actions_); }
  ~Files() { posix_spawn_file_actions_destroy(&actions_); }
  Files(const Files&) = delete;
  Files& operator=(const Files&) = delete;

  void read_nothing() { posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0); }
  void write_into(const Pipe& pipe, int stream) {
    posix_spawn_file_actions_adddup2(&actions_, pipe.end(1), stream);
    for (const std::size_t which : {0, 1}) posix_spawn_file_actions_addclose(&actions_, pipe.end(which));
  }
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// @return whether there may be more.
bool read_some(int from, std::string& text) {
  std::array<char, 4096> buffer;
  const ssize_t size = ::read(from, buffer.data(), buffer.size());
  if (size > 0) text.append(buffer.data(), static_cast<std::size_t>(size));
  return size > 0 || (size < 0 && errno == EINTR);
}

/// Of both at once: a program that waits until one is read would wait for ever.
void read_both(Pipe& out, Pipe& err, ProgramOutcome& outcome) {
  std::array<pollfd, 2> watched{{{out.end(0), POLLIN, 0}, {err.end(0), POLLIN, 0}}};
  while (watched[0].fd >= 0 || watched[1].fd >= 0) {
    if (::poll(watched.data(), watched.size(), -1) < 0) continue;  // a signal came
    for (const std::size_t which : {0, 1})
      if (watched[which].revents != 0 &&
          !read_some(watched[which].fd, which == 0 ? outcome.out : outcome.err))
        watched[which].fd = -1;
  }
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
  Pipe out, err;
  Files files;
  files.read_nothing();
  files.write_into(out, STDOUT_FILENO);
  files.write_into(err, STDERR_FILENO);
  pid_t process = 0;
  if (const int error =
          ::posix_spawnp(&process, arguments[0], files.get(), nullptr, arguments.data(), environ);
      error != 0)
    throw Rejected(Exit::io, complaint(words[0], std::strerror(error), "must be a program in the PATH"));
  out.close_end(1);
  err.close_end(1);
  ProgramOutcome outcome;
  read_both(out, err, outcome);
  outcome.code = wait_for(process);
  return outcome;
}

std::string this_program() {
  std::error_code error;
  const std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? "mesopix" : path.string();
}

}  // namespace app
