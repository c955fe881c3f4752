/// Independent jobs on all cores.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace app {

/// Whoever waits for jobs: is told how far they are, and may end them.
template <class... Progress>
struct WatchOf {
  std::function<void(Progress...)> told = {};  ///< after each job, by one thread at a time; may be empty
  std::function<bool()> go_on = {};  ///< asked by all threads; no job is begun, and none that asks goes
                                     ///< on, once it says no; may be empty

  void tell(Progress... progress) const {
    if (told) told(progress...);
  }
  [[nodiscard]] bool goes_on() const { return !go_on || go_on(); }
};

/// Told the number of jobs that are done, and that of all.
using Watch = WatchOf<std::size_t, std::size_t>;

/// Do jobs on as many threads; each is begun in the order of the list and writes where no other one does, so
/// that the outcome does not depend on who did what.
/// @param workers  threads, >= 1.   @return number of jobs that were done.
/// @throws what the first job of the list that failed threw, after all threads have ended; no job is begun
/// after a failure.
std::size_t run_jobs(const std::vector<std::function<void()>>& jobs, int workers, const Watch& watch = {});

/// Jobs at a time that a person asked for, held to the cores: more would wait for each other, and want
/// memory.
struct Workers {
  int count = 1;
  std::string note;  ///< that there are fewer than asked for; empty otherwise
};

/// @param wanted  >= 1.   @param option  that asked for it, "--jobs".
[[nodiscard]] Workers workers_within_cores(int wanted, const std::string& option);

/// Threads that this machine runs at once, >= 1.
[[nodiscard]] int core_count();

}  // namespace app
