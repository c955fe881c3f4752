#include "apps/system/machine.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include "apps/system/job_pool.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/text_parts.hpp"
#include "libmpm/kernels/instruction_set.hpp"
#include "libmpm/solver/threads.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

/// What stands behind the colon of the first line that begins so; empty where none does.
std::string entry(const char* file, const std::string& name) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
    if (line.rfind(name, 0) == 0) return std::string(trimmed(line.substr(line.find(':') + 1)));
  return {};
}

/// "16309248 kB" [bytes].
std::uint64_t bytes_of(const std::string& kilobytes) {
  return std::uint64_t{1024} * std::strtoull(kilobytes.c_str(), nullptr, 10);
}

/// The least of the control group that this program is in, and of those round it.
double quota_of_container() {
  const fs::path root = "/sys/fs/cgroup";
  const std::string own = entry("/proc/self/cgroup", "0:");  // ":/user.slice/..."
  fs::path group = root / fs::path(own.empty() ? own : own.substr(1)).relative_path();
  double least = 0;
  for (;; group = group.parent_path()) {
    std::ifstream file(group / "cpu.max");
    std::string line;
    std::getline(file, line);
    const double quota = quota_of(line);
    if (quota > 0) least = least > 0 ? std::min(least, quota) : quota;
    if (group == root || !group.has_relative_path()) return least;
  }
}

std::uint64_t memory_limit_of_program() {
  struct rlimit limit {};
  if (::getrlimit(RLIMIT_DATA, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return 0;
  return limit.rlim_cur;
}

}  // namespace

double quota_of(const std::string& cpu_max) {
  std::istringstream words(cpu_max);
  double time = 0, period = 0;
  return words >> time >> period && period > 0 ? time / period : 0;  // "max" is no number
}

Machine this_machine() {
  Machine machine;
  machine.processor = entry("/proc/cpuinfo", "model name");
  machine.cores = core_count();
  machine.idle_cores = mpm::idle_cores();
  machine.quota = quota_of_container();
  for (const auto* kernels : mpm::available_kernels()) machine.instruction_sets.emplace_back(kernels->name);
  machine.memory = bytes_of(entry("/proc/meminfo", "MemTotal"));
  machine.free_memory = bytes_of(entry("/proc/meminfo", "MemAvailable"));
  machine.memory_limit = memory_limit_of_program();
  return machine;
}

std::uint64_t free_disk(const std::string& folder) {
  std::error_code error;
  const fs::space_info space = fs::space(folder, error);
  if (error) throw Rejected(Exit::io, folder, error.message(), "must be a folder");
  return space.available;
}

std::string why_not_writable(const std::string& folder) {
  std::string name = (fs::path(folder) / ".mesopix-XXXXXX").string();
  const int file = ::mkstemp(name.data());
  if (file < 0) return std::generic_category().message(errno);
  const bool written = ::write(file, "mesopix", 7) == 7 && ::fsync(file) == 0;
  const std::string reason = written ? "" : std::generic_category().message(errno);
  ::close(file);
  ::unlink(name.c_str());
  return reason;
}

}  // namespace app
