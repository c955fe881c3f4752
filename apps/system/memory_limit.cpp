#include "apps/system/memory_limit.hpp"

#include <sys/resource.h>
#include <sys/sysinfo.h>

#include <algorithm>
#include <charconv>
#include <fstream>

#include "apps/text/version.hpp"

namespace app {
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

}  // namespace app
