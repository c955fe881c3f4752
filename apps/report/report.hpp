/// report.html: a run on one page that needs no network; its script only adds to what it shows.
#pragma once

#include <string>

#include "apps/report/run_record.hpp"

namespace output {

/// The whole page: curve, damage, specimen, key figures, energies, failures, scene, provenance. It is
/// well-formed XML too, and everything from outside is escaped.
[[nodiscard]] std::string report_html(const RunRecord& record);

}  // namespace output
