/// Independent jobs on all cores.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace app {

struct Watch {
  std::function<void(std::size_t done)>
      job_done;                 ///< called after each job, by one thread at a time; may be empty
  std::function<bool()> go_on;  ///< no further job is begun once it says no; may be empty
};

/// Do jobs on as many threads; each is begun in the order of the list and writes where no other one does, so
/// that the outcome does not depend on who did what.
/// @param workers  threads, >= 1.   @return number of jobs that were done.
/// @throws what the first job of the list that failed threw, after all threads have ended; no job is begun
/// after a failure.
std::size_t run_jobs(const std::vector<std::function<void()>>& jobs, int workers, const Watch& watch = {});

/// Threads that this machine runs at once, >= 1.
[[nodiscard]] int core_count();

}  // namespace app
