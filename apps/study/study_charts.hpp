/// Charts of what the members of a study came to.
#pragma once

#include <string>
#include <vector>

#include "apps/drawing/chart.hpp"
#include "apps/drawing/drawing.hpp"
#include "apps/statistics/influences.hpp"
#include "apps/statistics/statistics.hpp"
#include "apps/statistics/weibull_fit.hpp"
#include "apps/study/study_results.hpp"
#include "specimen/body/mask.hpp"

namespace app {

/// Density of values in bins of equal width.   @param name, unit  of the value.   @pre at least one value.
[[nodiscard]] output::Chart histogram_chart(const std::vector<double>& values, const std::string& name,
                                            const std::string& unit);

/// Values on Weibull paper, where the distribution is a straight line, with the line that fits best and its
/// 95 % confidence band. The i-th of n values stands at the share (i - 0.5) / n.
/// Source of the band: WeibullFit::log_error().   @pre a fit that came out; positive values.
[[nodiscard]] output::Chart weibull_chart(const std::vector<double>& values, const WeibullFit& fit,
                                          const std::string& name, const std::string& unit);

/// Mean of the first members with its 95 % confidence interval, against their number.
/// @pre at least two finite values.
[[nodiscard]] output::Chart convergence_chart(const std::vector<double>& values, const std::string& name,
                                              const std::string& unit);

/// All curves, faint, and of each group their mean and the band that holds the middle 80 %.
/// @param names  of the groups.   @param groups  curves by group; empty curves are left out. With one group
/// the band is drawn too.
[[nodiscard]] output::Chart curves_chart(const std::vector<std::string>& names,
                                         const std::vector<std::vector<Curve>>& groups,
                                         const std::string& stress_name, const std::string& strain_name);

/// Strength against size on logarithmic axes: members, and the law that fits.
[[nodiscard]] output::Chart size_chart(const std::vector<double>& sizes, const std::vector<double>& strengths,
                                       const SizeEffect& fit);

/// A figure of the members against a parameter.
[[nodiscard]] output::Chart influence_chart(const std::vector<double>& x, const std::vector<double>& y,
                                            const output::Axis& x_axis, const output::Axis& y_axis);

/// How often each pixel has failed, with a scale bar and a colour bar in %.
/// @pre the count has the shape of the mask.
[[nodiscard]] output::Drawing crack_drawing(const CrackCount& cracks, const specimen::LabelledMask& mask);

}  // namespace app
