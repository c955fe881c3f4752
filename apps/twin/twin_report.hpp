/// The page about an original and its twins.
#pragma once

#include <string>
#include <vector>

#include "apps/drawing/chart.hpp"
#include "apps/twin/twinning.hpp"

namespace app {

/// Each has the original, the mean of the twins, and the least and largest twin at every abscissa.
[[nodiscard]] output::Chart size_chart(const TwinTask& task, const std::vector<TwinRecord>& twins);
[[nodiscard]] output::Chart aspect_chart(const TwinTask& task, const std::vector<TwinRecord>& twins);
[[nodiscard]] output::Chart direction_chart(const TwinTask& task, const std::vector<TwinRecord>& twins);
[[nodiscard]] output::Chart gap_chart(const TwinTask& task, const std::vector<TwinRecord>& twins);
[[nodiscard]] output::Chart s2_chart(const TwinTask& task, const std::vector<TwinRecord>& twins);

/// S2 along x and y, of the original and in the mean of the twins.
[[nodiscard]] output::Chart s2_along_axes_chart(const TwinTask& task, const std::vector<TwinRecord>& twins);

/// One HTML page that needs no network.   @param notes  of the conversion and of the twins.
[[nodiscard]] std::string twin_html(const TwinTask& task, const std::vector<TwinRecord>& twins,
                                    const specimen::Misfit& misfit, const std::vector<std::string>& notes);

}  // namespace app
