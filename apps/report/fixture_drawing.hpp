/// The set-up of a test: a specimen with what supports, loads and measures it.
#pragma once

#include "apps/drawing/drawing.hpp"
#include "libmpm/scene/scene.hpp"
#include "specimen/body/mask.hpp"

namespace output {

/// Triangles stand where it is held, arrows where it is moved, evenly along each stretch; dots at the ends of
/// gauges. All as they are on the grid of the run.
/// @pre the scene is valid, and has the shape of the mask.   @throws mpm::Error as its plan.
[[nodiscard]] Drawing fixture_drawing(const specimen::LabelledMask& mask, const mpm::Scene& scene);

}  // namespace output
