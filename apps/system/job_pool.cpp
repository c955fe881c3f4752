#include "apps/system/job_pool.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

namespace app {
namespace {

/// The list that the workers take their jobs from.
class Queue {
 public:
  Queue(const std::vector<std::function<void()>>& jobs, const Watch& watch)
      : jobs_(jobs), watch_(watch), errors_(jobs.size()) {}

  void work() {
    for (std::size_t job = take(); job < jobs_.size(); job = take()) {
      std::exception_ptr error;
      try {
        jobs_[job]();
      } catch (...) {
        error = std::current_exception();
      }
      finish(job, error);
    }
  }

  /// After all workers have ended.
  std::size_t result() const {
    for (const std::exception_ptr& error : errors_)
      if (error) std::rethrow_exception(error);
    return done_;
  }

 private:
  /// Number of the next job; that of the jobs where none may be begun.
  std::size_t take() {
    const std::scoped_lock lock(mutex_);
    if (failed_ || !watch_.goes_on()) return jobs_.size();
    return next_ < jobs_.size() ? next_++ : jobs_.size();
  }

  void finish(std::size_t job, const std::exception_ptr& error) {
    const std::scoped_lock lock(mutex_);
    errors_[job] = error;
    failed_ = failed_ || error;
    if (error) return;
    ++done_;
    watch_.tell(done_, jobs_.size());
  }

  const std::vector<std::function<void()>>& jobs_;
  const Watch& watch_;
  std::mutex mutex_;
  std::vector<std::exception_ptr> errors_;
  std::size_t next_ = 0;
  std::size_t done_ = 0;
  bool failed_ = false;
};

}  // namespace

std::size_t run_jobs(const std::vector<std::function<void()>>& jobs, int workers, const Watch& watch) {
  Queue queue(jobs, watch);
  {
    std::vector<std::jthread> threads;
    const int useful = std::min(workers, static_cast<int>(jobs.size()));
    try {
      for (int i = 0; i < useful; ++i) threads.emplace_back([&queue] { queue.work(); });
    } catch (const std::system_error&) {  // the system gives no more of them
      if (threads.empty()) queue.work();
    }
  }
  return queue.result();
}

Workers workers_within_cores(int wanted, const std::string& option) {
  const int cores = core_count();
  if (wanted <= cores) return {wanted, ""};
  return {cores, fmt::format("{} {} is more than there are cores: there {} at a time, one on each", option,
                             wanted, cores == 1 ? "is 1" : fmt::format("are {}", cores))};
}

int core_count() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

}  // namespace app
