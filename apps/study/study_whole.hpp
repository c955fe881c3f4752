/// A whole study: all its members, and as many seeds more as a confidence interval calls for.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "apps/study/study_results.hpp"
#include "apps/study/study_run.hpp"

namespace app {

/// What there is when it ends.
struct WholeStudy {
  Study study;                          ///< with the seeds that it has grown to
  std::vector<Member> members;          ///< of it
  StudyTally tally;                     ///< of the last round
  std::optional<StudyResults> results;  ///< none when it was interrupted

  /// Largest half width of the confidence intervals of the mean peak stress over that mean [-]; NaN where one
  /// is not known.   @pre it has results.
  [[nodiscard]] double half_width() const;
};

/// Runs the members that are open, and tells how many are done.
using RunMembers = std::function<StudyTally(const Study& study, const std::vector<Member>& members)>;

/// Run the members, and more seeds until the 95 % confidence interval of the mean peak stress is within +-
/// share of it at every point, or there are as many as may be.
/// @param share  [-]; 0 = the seeds that the study has.   @throws what `run` and read_results() throw.
[[nodiscard]] WholeStudy run_whole_study(Study study, std::vector<Member> members, const StudyFolder& folder,
                                         double share, const RunMembers& run);

}  // namespace app
