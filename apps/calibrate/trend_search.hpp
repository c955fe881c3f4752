/// Search for the parameters of least misfit along the trend of all evaluations.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "apps/calibrate/evaluation.hpp"

namespace app {

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
