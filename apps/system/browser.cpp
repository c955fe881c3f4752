#include "apps/system/browser.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <thread>

namespace app {
namespace {

bool has_screen() {
  const char* x = std::getenv("DISPLAY");
  const char* wayland = std::getenv("WAYLAND_DISPLAY");
  return (x != nullptr && *x != '\0') || (wayland != nullptr && *wayland != '\0');
}

/// A new file that only this user can read.   @return its path; empty = it could not be written.
std::string private_file(const std::string& text) {
  std::error_code error;
  std::string path = (std::filesystem::temp_directory_path(error) / "mesopix-XXXXXX.html").string();
  constexpr int ending = 5;
  const int descriptor = error ? -1 : ::mkostemps(path.data(), ending, O_CLOEXEC);
  if (descriptor < 0) return {};
  const bool is_written = ::write(descriptor, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  ::close(descriptor);
  if (is_written) return path;
  ::unlink(path.c_str());
  return {};
}

/// Nobody waits for it: some browsers end with the last of their windows.
void start(const char* program, std::string argument) {
  std::string name = program;
  std::array<char*, 3> arguments{name.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&files, stream, "/dev/null", O_RDWR, 0);
  pid_t process = 0;
  const int error = ::posix_spawnp(&process, program, &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (error == 0) std::thread([process] { ::waitpid(process, nullptr, 0); }).detach();
}

}  // namespace

std::string page_that_leads_to(const std::string& address) {
  return "<!DOCTYPE html><meta charset=\"utf-8\"><meta http-equiv=\"refresh\" content=\"0; url=" + address +
         "\"><title>mesopix</title><p><a href=\"" + address + "\">" + address + "</a></p>\n";
}

OpenedBrowser::OpenedBrowser(const std::string& address) {
  if (!has_screen() || ::isatty(STDIN_FILENO) == 0) return;
  file_ = private_file(page_that_leads_to(address));
  if (!file_.empty()) start("xdg-open", file_);
}

OpenedBrowser::~OpenedBrowser() {
  if (!file_.empty()) ::unlink(file_.c_str());
}

}  // namespace app
