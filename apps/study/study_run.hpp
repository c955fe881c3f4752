/// Members of a study, run side by side.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "apps/study/study_folder.hpp"

namespace app {

/// How far the runs are.
struct StudyTally {
  std::size_t all = 0;     ///< members that were asked for
  std::size_t before = 0;  ///< that were done, or had failed, before
  std::size_t done = 0;    ///< that have a result now
  std::size_t failed = 0;  ///< that have failed now

  [[nodiscard]] std::size_t open() const { return all - before - done - failed; }
};

struct StudyWatch {
  std::function<void(const StudyTally&)> looked = {};  ///< after each member, by one thread at a time
  std::function<bool()> go_on = {};  ///< asked by all threads; once it says no, all runs end unfinished
};

/// Whether every member's settings go with a specimen: phases, edges, solver. Specimens from files are all
/// looked at, of random ones the first; one that cannot be made is left to its run.
/// @throws Rejected (Exit::data) naming the first member that is not valid, and its values.
void check_scenes(const Study& study, const std::vector<Member>& members);

/// Run the members that have neither a result nor a failure, each on one thread; write the result of each
/// into the folder, or why it has failed. One that is interrupted goes on from its checkpoint the next time.
/// What a member gives depends on nothing but itself. No more than `workers` + 1 specimens and `workers`
/// results are held at a time.
/// @param workers  threads, >= 1.   @throws mpm::FileError, specimen::Error (Fault::write) when the disk
/// fails; no member is begun after that.
[[nodiscard]] StudyTally run_members(const Study& study, const StudyFolder& folder,
                                     const std::vector<Member>& members, int workers,
                                     const StudyWatch& watch);

}  // namespace app
