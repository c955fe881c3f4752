/// The trend of figures over parameters, without the noise of single evaluations.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "apps/calibrate/evaluation.hpp"

namespace app {

/// Figures as linear functions of the logarithms of the factors. Strengths and moduli act on peaks as powers,
/// and breaking is so abrupt that a single peak jumps by some per cent from one set of parameters to the
/// next.
struct Trend {
  Eigen::VectorXd centre;     ///< logarithms of factors
  Eigen::VectorXd at_centre;  ///< figures there
  Eigen::MatrixXd slope;      ///< of the figures, shape (figures, parameters)

  [[nodiscard]] Eigen::VectorXd at(const Eigen::VectorXd& logarithms) const {
    return at_centre + slope * (logarithms - centre);
  }
};

/// Least squares, in which evaluations close to the centre weigh most: a tenth is as close as on the spot.
/// Parameters that the evaluations do not tell apart share a slope, one that was not changed has slope 0.
/// @pre at least one evaluation has figures, and all that have them have as many.
[[nodiscard]] Trend fit_trend(const std::vector<Evaluation>& history, const Eigen::VectorXd& centre);

[[nodiscard]] Eigen::VectorXd logarithms_of(const std::vector<double>& factors);

}  // namespace app
