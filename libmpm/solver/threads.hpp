/// The barrier of the threads of a run, used thousands of times a second, and a team of threads that share
/// work; and the number of idle cores.
#pragma once

#include <atomic>
#include <cstdint>
#include <istream>
#include <thread>
#include <vector>

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace mpm {

/// Like std::barrier, but for waits shorter than a system call: a thread first spins, then yields its core,
/// and only then sleeps. With a sleep at every wait, two threads are slower than one in a run of moving
/// points.
class Barrier {
 public:
  explicit Barrier(int threads) : threads_(threads), missing_(threads) {}

  /// From now on for another number of threads.   @pre nobody waits.
  void set_threads(int threads) {
    threads_ = threads;
    missing_.store(threads, std::memory_order_relaxed);
  }

  /// Returns when all threads have arrived.
  void arrive_and_wait() {
    const std::uint32_t round = round_.load(std::memory_order_relaxed);
    if (missing_.fetch_sub(1, std::memory_order_acq_rel) == 1) {
      missing_.store(threads_, std::memory_order_relaxed);
      round_.fetch_add(1, std::memory_order_release);
      round_.notify_all();
      return;
    }
    const auto is_over = [&] { return round_.load(std::memory_order_acquire) != round; };
    for (int i = 0; i < looks; ++i) {
      if (is_over()) return;
      pause();
    }
    for (int i = 0; i < offers; ++i) {
      if (is_over()) return;
      std::this_thread::yield();
    }
    while (!is_over()) round_.wait(round, std::memory_order_acquire);
  }

 private:
  static constexpr int looks = 2000;  ///< some 50 microseconds
  static constexpr int offers = 200;

  static void pause() {
#ifdef __x86_64__
    _mm_pause();
#endif
  }

  int threads_;
  alignas(64) std::atomic<int> missing_;
  alignas(64) std::atomic<std::uint32_t> round_{0};
};

/// Threads that wait for work and share it. All are made before any of them waits for another; where the
/// system gives fewer than were asked for, the team is as large as it can be, and never smaller than the
/// thread that asks.
class Team {
 public:
  explicit Team(int threads);
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
  ~Team();

  [[nodiscard]] int threads() const { return static_cast<int>(others_.size()) + 1; }
  /// Threads that the system refused.
  [[nodiscard]] int missing() const { return missing_; }
  /// Ends all threads but the one that calls, so that another team can have them.
  void dismiss();

  /// Calls work(part) for every part in [0, parts), each on a thread of its own, and returns when all are
  /// done.   @pre parts <= threads(); work does not throw.
  template <class Work>
  void share(int parts, const Work& work) {
    if (parts == 1) return work(0);
    parts_ = parts;
    work_ = &work;
    call_ = [](const void* what, int part) { (*static_cast<const Work*>(what))(part); };
    barrier_.arrive_and_wait();
    work(0);
    barrier_.arrive_and_wait();
  }

 private:
  void serve(int part);

  Barrier barrier_;
  std::atomic<std::uint32_t> is_complete_{0};  ///< 1 = its size is known
  int missing_ = 0;
  int parts_ = 0;  ///< 0 = no more work comes
  const void* work_ = nullptr;
  void (*call_)(const void*, int) = nullptr;
  std::vector<std::jthread> others_;
};

/// Number of cores that are idle now, >= 1; all cores if the system does not say.
[[nodiscard]] int idle_cores();
/// The same for `cores` >= 1, from what Linux says in /proc/loadavg.
[[nodiscard]] int idle_cores(std::istream& load, int cores);

}  // namespace mpm
