/// What the members of a study say together, written into its folder and told.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/study/study_results.hpp"
#include "apps/study/study_run.hpp"
#include "apps/system/terminal.hpp"

namespace app {

/// Write tables and report of what has a result, and say the means.   @return the doubts of the specimens,
/// and of runs that are no slow tests.
/// @throws mpm::FileError, specimen::Error (Fault::write) when the disk fails.
std::vector<std::string> close_study(const StudyFolder& folder, const Study& study,
                                     const std::vector<Member>& members, const StudyResults& results,
                                     Console& console);

/// How many of the members are done, have failed or are open, and in which folder.
[[nodiscard]] nlohmann::ordered_json count_json(const StudyFolder& folder,
                                                const std::vector<Member>& members);

/// The same with the doubts of close_study(), the mean peak stress, where no value varies, and the files.
[[nodiscard]] nlohmann::ordered_json study_json(const StudyFolder& folder, const Study& study,
                                                const std::vector<Member>& members,
                                                const StudyResults& results,
                                                const std::vector<std::string>& doubts);

/// Each of the first failed members with its reason, and where the others are told.
/// @throws Rejected (Exit::data) when any has failed.
void refuse_failures(const Study& study, const StudyFolder& folder, const std::vector<Member>& members);

/// "12 of 100 members   1 failed   35 s left".
/// @param elapsed  since the first of them was begun [s].
[[nodiscard]] std::string study_text(const StudyTally& tally, double elapsed);

}  // namespace app
