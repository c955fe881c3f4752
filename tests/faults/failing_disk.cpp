// A disk that fails on demand, for LD_PRELOAD: calls that write below one folder are counted, and one of them
// fails.
//   FAULT_FOLDER  what lies below it is counted: open (to create), write, fsync, close, rename, mkdir
//   FAULT_LOG     a line a call, "write PATH"; "FAULT write PATH" for one that failed
//   FAULT_AT      number of the call that fails, from 1; 0 or missing = none
//   FAULT_ERROR   its errno
//   FAULT_MODE    once    that call alone
//                 onward  as a full disk: from there on all that need space fail; close and rename do not
//                 short   a write writes half of what it was given, and says so; other calls are well
//                 kill    the program is gone before the call
//                 stall   only fsync is counted, and that call takes FAULT_SECONDS longer
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdarg>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

enum class Verdict { pass, fail, shorten };

std::string_view setting(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

long number(const char* name) { return std::strtol(std::string(setting(name)).c_str(), nullptr, 10); }

std::string absolute(const char* path) {
  if (path[0] == '/') return path;
  char folder[PATH_MAX];
  if (::getcwd(folder, sizeof folder) == nullptr) return path;
  return std::string(folder) + "/" + path;
}

/// Of a file that is open for writing; else empty.
std::string path_of(int descriptor) {
  const int flags = ::fcntl(descriptor, F_GETFL);
  if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY) return {};
  char path[PATH_MAX];
  const ssize_t size = ::readlink(("/proc/self/fd/" + std::to_string(descriptor)).c_str(), path, sizeof path);
  return size < 0 ? std::string() : std::string(path, static_cast<std::size_t>(size));
}

void log(const std::string& line) {
  static const int file =
      static_cast<int>(::syscall(SYS_openat, AT_FDCWD, std::string(setting("FAULT_LOG")).c_str(),
                                 O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
  (void)::syscall(SYS_write, file, line.data(), line.size());
}

bool needs_space(std::string_view call) { return call != "close" && call != "rename"; }

Verdict judge(std::string_view call, const std::string& path) {
  static std::atomic<long> calls{0};
  static const std::string folder = std::string(setting("FAULT_FOLDER")) + "/";
  static const long at = number("FAULT_AT");
  static const std::string mode(setting("FAULT_MODE"));
  const int before = errno;
  if (path.compare(0, folder.size(), folder) != 0 || (mode == "stall" && call != "fsync"))
    return Verdict::pass;
  const long count = ++calls;
  const bool hit = at > 0 && (mode == "onward" ? count >= at && needs_space(call) : count == at) &&
                   (mode != "short" || call == "write");
  log((hit ? "FAULT " : "") + std::string(call) + " " + path + "\n");
  if (hit && mode == "kill") (void)::kill(::getpid(), SIGKILL);
  if (hit && mode == "stall") {
    const double seconds = std::strtod(std::string(setting("FAULT_SECONDS")).c_str(), nullptr);
    ::usleep(static_cast<useconds_t>(1e6 * seconds));
    return Verdict::pass;
  }
  errno = hit && mode != "short" ? static_cast<int>(number("FAULT_ERROR")) : before;
  if (!hit) return Verdict::pass;
  return mode == "short" ? Verdict::shorten : Verdict::fail;
}

template <class Function>
Function real(const char* name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

int open_with(const char* name, const char* path, int flags, mode_t mode) {
  static_assert(O_CREAT != 0);
  if ((flags & O_CREAT) != 0 && judge("open", absolute(path)) == Verdict::fail) return -1;
  return real<int (*)(const char*, int, ...)>(name)(path, flags, mode);
}

mode_t mode_in(int flags, std::va_list arguments) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  std::va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_in(flags, arguments);
  va_end(arguments);
  return open_with("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  std::va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_in(flags, arguments);
  va_end(arguments);
  return open_with("open64", path, flags, mode);
}

ssize_t write(int descriptor, const void* bytes, size_t size) {
  static const auto next = real<ssize_t (*)(int, const void*, size_t)>("write");
  const Verdict verdict = judge("write", path_of(descriptor));
  if (verdict == Verdict::fail) return -1;
  return next(descriptor, bytes, verdict == Verdict::shorten ? (size + 1) / 2 : size);
}

ssize_t writev(int descriptor, const iovec* pieces, int count) {
  static const auto next = real<ssize_t (*)(int, const iovec*, int)>("writev");
  if (judge("write", path_of(descriptor)) == Verdict::fail) return -1;
  return next(descriptor, pieces, count);
}

ssize_t pwrite(int descriptor, const void* bytes, size_t size, off_t offset) {
  static const auto next = real<ssize_t (*)(int, const void*, size_t, off_t)>("pwrite");
  if (judge("write", path_of(descriptor)) == Verdict::fail) return -1;
  return next(descriptor, bytes, size, offset);
}

ssize_t pwrite64(int descriptor, const void* bytes, size_t size, off64_t offset) {
  static const auto next = real<ssize_t (*)(int, const void*, size_t, off64_t)>("pwrite64");
  if (judge("write", path_of(descriptor)) == Verdict::fail) return -1;
  return next(descriptor, bytes, size, offset);
}

int fsync(int descriptor) {
  static const auto next = real<int (*)(int)>("fsync");
  return judge("fsync", path_of(descriptor)) == Verdict::fail ? -1 : next(descriptor);
}

int fdatasync(int descriptor) {
  static const auto next = real<int (*)(int)>("fdatasync");
  return judge("fsync", path_of(descriptor)) == Verdict::fail ? -1 : next(descriptor);
}

/// As in Linux, the descriptor is gone even where closing it fails.
int close(int descriptor) {
  static const auto next = real<int (*)(int)>("close");
  const Verdict verdict = judge("close", path_of(descriptor));
  const int error = errno;
  const int closed = next(descriptor);
  if (verdict != Verdict::fail) return closed;
  errno = error;
  return -1;
}

int rename(const char* from, const char* to) noexcept {
  static const auto next = real<int (*)(const char*, const char*)>("rename");
  return judge("rename", absolute(to)) == Verdict::fail ? -1 : next(from, to);
}

int mkdir(const char* path, mode_t mode) noexcept {
  static const auto next = real<int (*)(const char*, mode_t)>("mkdir");
  return judge("mkdir", absolute(path)) == Verdict::fail ? -1 : next(path, mode);
}

}  // extern "C"
