/// The page and the numbers that a reproduction leaves.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "apps/reproduce/campaign.hpp"

namespace app::reproduce {

/// report.html: claims and verdicts, then each figure; one page that needs no network.
[[nodiscard]] std::string report_html(const Reproduction& reproduction);

/// reproduction.json: claims, the numbers of each figure, every run with its command.
[[nodiscard]] nlohmann::json report_json(const Reproduction& reproduction);

/// "6 agree with this run, 2 disagree and 1 depend on a choice or on chance".
[[nodiscard]] std::string verdict_counts(const std::vector<Claim>& claims);

}  // namespace app::reproduce
