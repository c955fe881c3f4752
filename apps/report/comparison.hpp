/// Several runs on one page.
#pragma once

#include <string>
#include <vector>

#include "apps/drawing/chart.hpp"
#include "libmpm/scene/result.hpp"

namespace output {

inline constexpr std::size_t most_compared_runs = 10;  ///< lines that can be told apart in one chart

struct ComparedRun {
  std::string name;  ///< no two alike
  mpm::Result result;
};

/// A setting in which the scenes differ, its values by run.
struct ComparedSetting {
  std::string key;
  std::vector<std::string> values;
};

/// A curve from elsewhere.
struct MeasuredCurve {
  std::string name;
  std::vector<double> strain;  ///< [-]
  std::vector<double> stress;  ///< [Pa]
};

/// The curves over each other, those measured dashed.   @pre 1 to most_compared_runs runs
[[nodiscard]] Chart comparison_chart(const std::vector<ComparedRun>& runs,
                                     const std::vector<MeasuredCurve>& measured = {});

/// The curves over each other, the key figures with their distance from those of the first run, and the
/// settings. Like a report the page needs no network, and all text on it is escaped.   @pre 2 to
/// most_compared_runs runs
[[nodiscard]] std::string comparison_html(const std::vector<ComparedRun>& runs,
                                          const std::vector<ComparedSetting>& settings);

}  // namespace output
