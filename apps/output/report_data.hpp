/// What the script of a report reads.
#pragma once

#include <string>

#include "apps/run_folder.hpp"

namespace output {

/// JSON without any of < > &, so that it cannot end the element that holds it. Keys: strain {name,
/// per_strain}, csv (curve.csv, deflated, as base64), charts by id, each {title, x, y, series, markers,
/// references}, film (see film_data; null for none).
[[nodiscard]] std::string report_data(const RunRecord& record);

}  // namespace output
