/// A whole study: all its members, and as many seeds more as a confidence interval calls for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "apps/statistics/statistics.hpp"
#include "apps/study/study_results.hpp"
#include "apps/study/study_run.hpp"

namespace app {

inline constexpr std::size_t least_seeds = 10;     ///< before anything can be told
inline constexpr std::size_t most_seeds = 10'000;  ///< at which growth ends

/// Peak stress at each point of a study, over its seeds.
[[nodiscard]] std::vector<MeanEstimate> peak_estimates(const std::vector<Member>& members,
                                                       const StudyResults& results);

/// Number of seeds to go on with until the confidence interval of the mean peak stress is at most
/// mean * (1 +- share) at every point: what the scatter so far calls for, at least one more, at most twice as
/// many. It follows from all members of the seeds so far, so that it does not depend on who ended first.
/// @return `seeds` when they are enough, or as many as may be.
[[nodiscard]] std::size_t seeds_to_go_on_with(const std::vector<MeanEstimate>& estimates, std::size_t seeds,
                                              double share);

/// The seeds, and after them those that follow the largest one.   @pre at least one seed.
[[nodiscard]] std::vector<std::uint64_t> grown_seeds(std::vector<std::uint64_t> seeds, std::size_t count);

/// Largest half width of the intervals over their means [-]; NaN where one is not known.
[[nodiscard]] double largest_half_width(const std::vector<MeanEstimate>& estimates);

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
