/// What there is to say of a run: what it leaves out, what it has to remember, a ledger that does not close.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/report/run_record.hpp"
#include "libmpm/run/explain.hpp"
#include "libmpm/scene/result.hpp"
#include "libmpm/scene/scene.hpp"

namespace app {

/// By how much it is off, why, and what helps; empty for an error below 1 % of the energy put in.
[[nodiscard]] std::string energy_note(const mpm::Result& result, const mpm::Scene& scene);

/// How much of the peak inertia and damping carry, by which figures, and what helps; that the largest
/// reaction of the platens is no peak; that the specimen had broken before. Empty where each share is as
/// usual (a third of the reactions, 5 % of the work as motion, 40 % of it damped), without platens and
/// without inertia.
[[nodiscard]] std::string inertia_note(const mpm::Result& result, const mpm::Scene& scene);

struct RunRemarks {
  std::vector<std::string> notes;   ///< what was guessed before the run began, one sentence each
  bool estimate_error = false;      ///< how wrong the peak may be is to be said in the end
  output::ErrorEstimate tolerated;  ///< that a tolerance led to; without sources when none was asked for
  double checkpoint_every = 0;      ///< wall time between checkpoints [s]; 0: none on the way
};

/// As a checkpoint and a result keep them.
[[nodiscard]] std::string remarks_text(const RunRemarks& remarks);

/// @param path  of that file, for the message.   @throws Rejected (Exit::data) for a text that is none
/// of these.
[[nodiscard]] RunRemarks parse_remarks(const std::string& text, const std::string& path);

/// A table of the features, those that are in first.
[[nodiscard]] std::string explanation_text(const mpm::Explanation& explanation);

[[nodiscard]] nlohmann::ordered_json explanation_json(const mpm::Explanation& explanation);

}  // namespace app
