/// The report of a run that goes on, as the browser of whoever watches it shows it.
#pragma once

#include <cstdint>
#include <string>

#include "apps/run/run_folder.hpp"

namespace output {

/// How far a run is.
struct Stage {
  std::int64_t number = 0;  ///< of the look at it; the next look has a larger one
  double fraction = 0;      ///< that is done [-]
  std::string words;        ///< "42 %, strain 168e-6 ...", or how the run ended
};

/// The page of a report, but for what only a finished run has; a bar tells how far the run is and stops it.
/// Its script asks "now?have=NUMBER" every half second for a watching_update, and stops the run by a POST to
/// "stop".
[[nodiscard]] std::string watching_html(const RunRecord& record, const Stage& stage);

/// JSON without any of < > &, with the keys number, fraction, words, goes_on, strain, csv, charts (as in
/// report_data, without the sieve), film (film_growth, or null), parts (HTML by name).
[[nodiscard]] std::string watching_update(const RunRecord& record, const Stage& stage);

}  // namespace output
