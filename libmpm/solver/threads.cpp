#include "libmpm/solver/threads.hpp"

#include <algorithm>
#include <exception>
#include <fstream>
#include <string>
#include <thread>

#include "libmpm/kernels/instruction_set.hpp"

namespace mpm {

Team::Team(int threads) : barrier_(threads) {
  others_.reserve(static_cast<std::size_t>(std::max(threads, 1)));
  try {
    for (int part = 1; part < threads; ++part) others_.emplace_back([this, part] { serve(part); });
  } catch (
      const std::exception&) {  // EAGAIN, or no memory for a stack: those that there are can do all of it
    missing_ = threads - this->threads();
  }
  barrier_.set_threads(this->threads());
  is_complete_.store(1, std::memory_order_release);
  is_complete_.notify_all();
}

Team::~Team() { dismiss(); }

void Team::dismiss() {
  parts_ = 0;
  if (!others_.empty()) barrier_.arrive_and_wait();
  others_.clear();
}

void Team::serve(int part) {
  is_complete_.wait(0, std::memory_order_acquire);
  const FlushToZero flush;
  for (;;) {
    barrier_.arrive_and_wait();
    if (parts_ == 0) return;
    if (part < parts_) call_(work_, part);
    barrier_.arrive_and_wait();
  }
}

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
