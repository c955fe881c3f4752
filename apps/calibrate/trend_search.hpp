/// Search for the parameters of least misfit along the trend of all evaluations, without their noise.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/calibrate/calibration_target.hpp"

namespace app {

struct Box {
  std::vector<double> start;
  std::vector<double> low, high;  ///< same length; start lies within
};

/// Where a smooth function is least, to 1e-7, without its derivatives, by BOBYQA: quadratic models in a trust
/// region.
/// @throws what the function throws.
/// Source: Powell (2009), as NLopt has it.
[[nodiscard]] std::vector<double> bounded_minimum(
    const Box& box, const std::function<double(const std::vector<double>&)>& function);

/// "BOBYQA (NLopt 2.7.1)".
[[nodiscard]] std::string name_of_minimizer();

/// Moore and Penrose's inverse: what it gives is the least-squares solution, the smallest where there are
/// many. Singular values below 1e-6 of the largest count as zero.
[[nodiscard]] Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& matrix);

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

/// Where a search begins and what ends it. Variables are the logarithms of the factors.
struct TrendPlan {
  std::vector<double> start;
  std::vector<double> low, high;  ///< bounds, same length; start lies within
  double step = 0.25;             ///< first change of a variable, > 0; four times as much at most in one go
  double tolerance = 0.005;       ///< misfit that is good enough, > 0
  int evaluations = 100;          ///< at most, >= 1
};

enum class SearchEnd {
  goal,         ///< the misfit is good enough
  no_progress,  ///< many evaluations without a better one
  evaluations,  ///< as many as there may be
  stopped,
};

/// Runs a set of parameters, given as logarithms of the factors; nullopt stops the search.
using Evaluate = std::function<std::optional<Evaluation>(const std::vector<double>& logarithms)>;

/// Evaluate the start and a step from it along each parameter, then again and again where the trend of all
/// evaluations so far has its least misfit within the bounds, found by BOBYQA. Other than a search on the
/// misfit itself, this is not caught by the jumps from one evaluation to the next. Where the trend leads to a
/// place that is known, one close by is taken.
/// @param wanted  figures that are aimed at.
SearchEnd search_along_trend(const TrendPlan& plan, const Figures& wanted, const Evaluate& evaluate);

}  // namespace app
