/// What the bench of errors found, as a page, as a table and in a few lines.
#pragma once

#include <string>
#include <vector>

#include "apps/bench/error_study.hpp"

namespace app::bench {

/// One chart a problem, error against wall time, and the cheapest way to 5 %, 1 % and 0.1 %.
[[nodiscard]] std::string error_html(const std::vector<ProblemResult>& results);

/// The chart of a problem as PNG, twice its size on the page.
[[nodiscard]] std::string error_png(const ProblemResult& result);

/// A line a run: problem, method, what is refined, its size, error, wall time, point-updates, order, front.
[[nodiscard]] std::string error_csv(const std::vector<ProblemResult>& results);

/// For the console: the cheapest ways, a line a problem and tolerance.
[[nodiscard]] std::string error_text(const std::vector<ProblemResult>& results);

}  // namespace app::bench
