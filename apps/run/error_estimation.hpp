/// How wrong a run may be, found by running its scene otherwise; and the cheapest run that is right enough.
#pragma once

#include <functional>

#include "apps/report/run_record.hpp"
#include "libmpm/scene/result.hpp"
#include "libmpm/scene/scene.hpp"

namespace app {

/// Solves a scene.   @throws what the caller wants to end the estimation with, e.g. when interrupted.
using Solve = std::function<mpm::Result(const mpm::Scene&)>;

/// Error of the peak of `base`, the result of a scene with platens, from runs that end soon after the peak:
/// without inertia, with half the step, in the other precision, with pixel cells, and with pixels twice as
/// large. The error of the rate is the difference from equilibrium. Where there is none (points move, cracks
/// close) it comes from runs at a half and a quarter of the rate: the distance to the line
/// through the three rates at rest, and the standard error of that line there, or by how much they differ if
/// that is more; and where points can fail, a known bias of explicit runs comes to that, which no rate shows.
/// The step is taken to be of first order, so that the error is twice what halving it changes; pixels too, so
/// that it is what doubling them changes; of precision and cell it is the difference. All have a margin of a
/// quarter. Source: Roache, Verification and Validation in Computational Science and Engineering (1998): the
/// grid convergence index.
[[nodiscard]] output::ErrorEstimate estimate_error(const mpm::Scene& scene, const mpm::Result& base,
                                                   const Solve& solve);

/// Pixels twice as large, as specimen::resampled() makes them: an ITZ stays a ring of one pixel. Rows and
/// columns that fill no cell of such pixels are cut off. Extra points stay where they are.
[[nodiscard]] mpm::Scene coarsened(const mpm::Scene& scene);

/// What a tolerance asks for.
struct Tolerated {
  mpm::Scene scene;                ///< with its rate, step and precision, or without inertia
  output::ErrorEstimate estimate;  ///< of those, or of failures that happen at once
  double wall_time = 0;            ///< of all runs that led there [s]
  bool met = false;                ///< else the estimate is as small as was reached
};

/// From a fast run in single precision with a step of 0.9 of the critical one, halve the loading rate until
/// the peak is within half the tolerance of equilibrium, or where there is none until a line through the
/// peaks of the last three is within it of its end at rest; then the step and the precision where the rest
/// needs it. Where no rate is slow enough, the method without inertia takes its place.
/// @pre the scene is explicit.   @param tolerance  of the peak stress [-], > 0.
[[nodiscard]] Tolerated meet_tolerance(const mpm::Scene& scene, double tolerance, const Solve& solve);

}  // namespace app
