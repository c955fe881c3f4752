/// Twins: random specimens whose aggregates have the same statistics as those of a picture.
#pragma once

#include <cstdint>

#include "specimen/describe/descriptors.hpp"

namespace specimen {

/// The border of a twin.
enum class Border {
  automatic,  ///< as in the original: cut if its border cuts aggregates
  cut,        ///< a saw cut: it cuts aggregates
  whole,      ///< a wall: aggregates lie inside, at least the gap away
};

/// Options of twins.
struct TwinOptions {
  double width = 0;       ///< of a twin [m]; 0 = as the original
  double height = 0;      ///< of a twin [m]; 0 = as the original
  double pixel_size = 0;  ///< of a twin [m]; 0 = as the original
  double gap = -1;        ///< smallest distance of aggregates [m]; -1 = as the original, see plan_twins()
  Border border = Border::automatic;
};

/// The distance to the nearest neighbour that 95 % of the aggregates of the original exceed [m].
[[nodiscard]] double usual_gap(const Descriptors& original);

/// The data that twins are made from.
struct TwinPlan {
  double width = 0, height = 0, pixel_size = 0;  ///< [m]
  double fraction = 0;                           ///< area fraction of aggregate [-]
  double gap = 0;                                ///< smallest distance of aggregates [m]
  bool cut = false;                              ///< the border cuts aggregates
  bool oriented = false;                         ///< aggregates keep the directions of the original
  AggregateSample sample;                        ///< sizes and shapes
};

/// If the Rayleigh test gives more than this probability [-], the directions of the original count as random.
inline constexpr double significant = 0.05;

/// Plan twins of an original. Without another request the gap is usual_gap(): with it S2 and the distances of
/// neighbours agree better with the original than without a gap. If randomly placed aggregates cannot keep
/// this gap (those of the original may be ordered), it is halved until they can.
/// @throws Error if the original has no aggregate or almost nothing else, for a size that is not a whole
/// number of pixels, and if the largest aggregate does not fit.
[[nodiscard]] TwinPlan plan_twins(const Descriptors& original, const TwinOptions& options);

/// A twin.
struct Twin {
  Segmented segmented;
  bool relaxed = false;  ///< random placement was not enough and overlaps were relaxed
  int lost = 0;          ///< number of aggregates too small to contain a pixel centre
};

/// Draw one twin. Aggregates are drawn from the sample of the original, each with its size, aspect ratio and
/// direction: a stratified bootstrap. Each of ten strata of equal area, largest aggregates first, gets its
/// area to within half an aggregate; the remainder is carried over to the next stratum. At the end all sizes
/// are scaled by one factor close to 1 to meet the fraction. A twin with a cut border is one period of a
/// periodic packing, so that no wall keeps aggregates away. Same plan and seed, same bits on any machine.
/// @throws Error if the aggregates cannot be packed, or the twin is too small for a single one; with what to
/// try.
[[nodiscard]] Twin draw_twin(const TwinPlan& plan, std::uint64_t seed);

}  // namespace specimen
