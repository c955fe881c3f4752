/// How well a segmentation agrees with a reference: phases, their boundaries, and single aggregates.
#pragma once

#include <cstdint>
#include <vector>

#include "specimen/body/specimen.hpp"

namespace specimen {

/// Measures from 0 = nothing in common to 1 = the same.
struct Agreement {
  struct OfPhase {
    /// Pixels that both give to the phase, over those that either does [-]; NaN for a phase in neither.
    double intersection_over_union = 0;
    /// Harmonic mean of the shares of the boundary of each that lie near that of the other [-]; NaN for a
    /// phase without a boundary in both.
    double boundary = 0;
  };
  std::vector<OfPhase> phases;  ///< by label, as many as the larger of the two has names

  std::int64_t matched = 0;  ///< aggregates of both that share more than half of their union
  std::int64_t missed = 0;   ///< of the reference, without a match
  std::int64_t extra = 0;    ///< of the segmentation, without a match
  /// Sum of intersection over union of the matched ones over matched + missed / 2 + extra / 2 [-]; NaN
  /// without aggregates.
  double panoptic_quality = 0;
};

/// Compare a segmentation with a reference of the same pixels, before rings of ITZ are drawn.
/// @param tolerance  distance up to which boundaries are near each other [px].
/// @throws Error if the shapes differ.
/// Sources: boundaries, Csurka, Larlus, Perronnin (2013); aggregates, Kirillov, He, Girshick, Rother, Dollar
/// (2019).
[[nodiscard]] Agreement agreement_of(const Segmented& found, const Segmented& reference, int tolerance = 2);

}  // namespace specimen
