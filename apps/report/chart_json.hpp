/// What the script of a page draws charts from.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/drawing/chart.hpp"

namespace output {

/// {title, x, y, series, markers, references}: axes {label, logarithmic}, series {name, ink, dashed, x, y}.
/// Numbers have seven digits; one that is not finite is null, and leaves a gap.
/// @param references  curves to switch on.
[[nodiscard]] nlohmann::ordered_json chart_json(const Chart& chart,
                                                const std::vector<Series>& references = {});

/// JSON without any of < > &, so that it cannot end the element of a page that holds it; bytes that are no
/// UTF-8 become U+FFFD.
[[nodiscard]] std::string inert_text(const nlohmann::ordered_json& json);

}  // namespace output
