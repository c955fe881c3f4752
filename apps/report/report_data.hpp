/// What the script of a report reads.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "apps/run/run_folder.hpp"

namespace output {

/// JSON without any of < > &, so that it cannot end the element that holds it. Keys: strain {name,
/// per_strain}, csv (curve.csv, deflated, as base64), charts by id, each {title, x, y, series, markers,
/// references}, film (see film_data; null for none). A run that goes on has no csv yet: null.
[[nodiscard]] std::string report_data(const RunRecord& record);

[[nodiscard]] nlohmann::ordered_json strain_json(const RunRecord& record);    ///< its key "strain"
[[nodiscard]] nlohmann::ordered_json charts_of_run(const RunRecord& record);  ///< charts without the sieve

}  // namespace output
