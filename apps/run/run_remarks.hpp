/// What a run has to remember beside its state, so that it ends as it was asked to after it was stopped.
#pragma once

#include <string>
#include <vector>

#include "apps/report/error_estimate.hpp"

namespace app {

struct RunRemarks {
  std::vector<std::string> notes;   ///< what was guessed before the run began, one sentence each
  bool estimate_error = false;      ///< how wrong the peak may be is to be said in the end
  output::ErrorEstimate tolerated;  ///< that a tolerance led to; without sources when none was asked for
  double checkpoint_every = 0;      ///< wall time between checkpoints [s]; 0: none on the way
};

/// As a checkpoint keeps them.
[[nodiscard]] std::string remarks_text(const RunRemarks& remarks);

/// @param path  of the checkpoint, for the message.   @throws Rejected (Exit::data) for a text that is none
/// of these.
[[nodiscard]] RunRemarks parse_remarks(const std::string& text, const std::string& path);

}  // namespace app
