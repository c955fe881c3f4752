#include "specimen/teach/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace specimen {

void share_out(int count, int threads, const std::function<void(int)>& work) {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int hands = std::min(count, threads > 0 ? threads : cores);
  std::atomic<int> next{0};
  std::exception_ptr fault;
  std::mutex guard;
  const auto serve = [&] {
    try {
      for (int i = next++; i < count; i = next++) work(i);
    } catch (...) {
      next = count;
      const std::lock_guard lock(guard);
      if (!fault) fault = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> helpers;
    try {
      for (int i = 1; i < hands; ++i) helpers.emplace_back(serve);
    } catch (const std::system_error&) {  // the system gives no more threads: those that are here do it
    }
    serve();
  }
  if (fault) std::rethrow_exception(fault);
}

}  // namespace specimen
