#include "libmpm/solver/threads.hpp"

#include <algorithm>
#include <fstream>
#include <string>
#include <thread>

namespace mpm {

int idle_cores() {
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  std::ifstream load("/proc/loadavg");
  return idle_cores(load, cores);
}

// "0.20 0.18 0.12 3/80 11206": three of 80 tasks run now, and one of them is this one.
int idle_cores(std::istream& load, int cores) {
  std::string average;
  int running = 1;
  for (int i = 0; i < 3; ++i) load >> average;
  if (!(load >> running)) return cores;
  return std::clamp(cores - (running - 1), 1, cores);
}

}  // namespace mpm
