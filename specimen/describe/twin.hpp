/// Statistical twins: random specimens whose aggregates are like those of a picture.
#pragma once

#include <cstdint>

#include "specimen/describe/descriptors.hpp"

namespace specimen {

/// What the border of a twin is.
enum class Border {
  automatic,  ///< as in the original: cut if the border cuts aggregates there
  cut,        ///< that of a saw cut: it cuts aggregates
  whole,      ///< a wall: aggregates lie whole inside, at the gap
};

struct TwinOptions {
  double width = 0;       ///< [m]; 0 = as the original
  double height = 0;      ///< [m]; 0 = as the original
  double pixel_size = 0;  ///< [m]; 0 = as the original
  double gap = -1;        ///< least distance of aggregates [m]; -1 = as the original, see plan_twins()
  Border border = Border::automatic;
};

/// The gap that all but one in twenty aggregates of the original keep to their nearest neighbour [m].
[[nodiscard]] double usual_gap(const Descriptors& original);

/// Everything that twins are made from.
struct TwinPlan {
  double width = 0, height = 0, pixel_size = 0;  ///< [m]
  double fraction = 0;                           ///< [-]
  double gap = 0;                                ///< [m]
  bool cut = false;                              ///< the border cuts aggregates
  bool oriented = false;                         ///< aggregates keep the directions of the original
  AggregateSample sample;
};

/// Beyond that probability of the Rayleigh test, the directions of the original are taken for random.
inline constexpr double significant = 0.05;

/// The gap is the usual one of the original unless another is asked for: it brings S2 and the distances of
/// neighbours nearer to those of the original than none does. Where aggregates of random places cannot keep
/// it (those of the original lie in order), it is halved until they can.
/// @throws Error when there is no aggregate or hardly anything else in the original, for a size that is no
/// whole number of pixels, and when the largest aggregate does not fit.
[[nodiscard]] TwinPlan plan_twins(const Descriptors& original, const TwinOptions& options);

struct Twin {
  Segmented segmented;
  bool relaxed = false;  ///< plain placement was not enough and overlaps were pushed apart
  int lost = 0;          ///< aggregates so small that they hold no pixel centre
};

/// One twin. Aggregates are drawn whole, with size, aspect and direction together, from the sample of the
/// original: a stratified bootstrap. Ten strata of equal area, largest aggregates first, each get their area
/// to within half an aggregate, what is short or over is handed on to the next, and at the end all sizes are
/// scaled by one factor near 1, so that the fraction is met. A twin with a cut border is one period of a
/// periodic packing, which has no wall that would keep aggregates off.
/// The same plan and seed give the same bits on any machine.
/// @throws Error when so many aggregates cannot be packed, or when so small a twin has no room for a single
/// one, with what to try.
[[nodiscard]] Twin draw_twin(const TwinPlan& plan, std::uint64_t seed);

}  // namespace specimen
