/// What the values of a label map mean, read from how they lie in the picture.
#pragma once

#include <string>
#include <vector>

#include "specimen/convert/convert.hpp"
#include "specimen/convert/guess.hpp"
#include "specimen/convert/shapes.hpp"

namespace specimen {

/// Phases of the values of a map; and the second best reading, where it is nearly as likely.
struct Reading {
  std::vector<std::string> phases;  ///< one per value
  std::vector<std::string> other;   ///< the same; empty: nothing else comes close
  std::string doubt;                ///< what the two differ in, where there are two
};

/// Which values are thin bands that keep two others apart, which hardly touch each other without it.
[[nodiscard]] std::vector<bool> bands_of(const Shapes& shapes);

/// Read a map by its geometry alone, so that the numbers of any program will do:
/// - a thin band that keeps two other values apart is ITZ;
/// - the matrix (mortar) is the value whose largest piece takes part in most of the boundaries and runs along
///   most of the border of the picture;
/// - of the others, one is void where its pieces are much smaller than those of another and few, or it is
///   black as well; a single other value is aggregate, unless it is a few dots, which may be either;
/// - the rest is aggregate.
/// Pixels of code -1 (outside of the specimen) take no part.
[[nodiscard]] Reading read_map(const ValueMap& map);

/// The refusal of a map that can be read in two ways.
[[nodiscard]] TwoReadings refusal_of(const ValueMap& map, const Reading& reading);

}  // namespace specimen
