/// A known truth dressed as a photograph, and strokes that a hand might paint over it.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "specimen/body/raster.hpp"
#include "specimen/convert/strokes.hpp"
#include "specimen/picture/picture.hpp"
#include "tests/specimen/known_truth.hpp"
#include "tests/specimen/png_recipe.hpp"

namespace specimen_test {

/// A raster with `times` x `times` pixels for each one.
template <class T>
specimen::Raster<T> enlarged(const specimen::Raster<T>& raster, int times) {
  specimen::Raster<T> large(raster.rows * times, raster.cols * times);
  for (int r = 0; r < large.rows; ++r)
    for (int c = 0; c < large.cols; ++c) large(r, c) = raster(r / times, c / times);
  return large;
}

/// The stones and pores of known_truth() three times as large, so that they have a texture.
inline KnownTruth large_truth() {
  KnownTruth truth = known_truth();
  truth.labels = enlarged(truth.labels, 3);
  truth.instances = enlarged(truth.instances, 3);
  truth.rows *= 3;
  truth.cols *= 3;
  for (auto* discs : {&truth.stones, &truth.pores})
    for (Disc& disc : *discs) disc.row *= 3, disc.col *= 3, disc.radius *= 3;
  return truth;
}

/// Labels 0 void, 1 aggregate, 2 mortar as a photograph: mortar rough with sand, stones smooth and of nearly
/// the same mean colour, voids dark. The light falls off to the right.
/// @param fall  of the light over the width [-].
inline specimen::Raster<specimen::Rgb> dressed(const specimen::Raster<std::uint8_t>& labels,
                                               std::uint64_t seed, double fall = 0) {
  specimen::Random random(seed);
  specimen::Raster<specimen::Rgb> picture(labels.rows, labels.cols);
  for (int r = 0; r < labels.rows; ++r)
    for (int c = 0; c < labels.cols; ++c) {
      const std::uint8_t label = labels(r, c);
      const double spread = label == 2 ? 40 : 8, light = 1 - fall * c / labels.cols;
      const double grain = random.uniform(-spread, spread);
      const auto tone = [&](double mean) {
        return static_cast<std::uint8_t>(std::clamp(std::lround(light * (mean + grain)), 0L, 255L));
      };
      picture(r, c) = label == 0   ? specimen::Rgb{tone(50), tone(45), tone(40)}
                      : label == 1 ? specimen::Rgb{tone(140), tone(145), tone(150)}
                                   : specimen::Rgb{tone(150), tone(145), tone(135)};
    }
  return picture;
}

/// Upright strokes within the phases, two pixels away from their edges, so many of each.
inline specimen::Raster<std::uint8_t> some_strokes(const specimen::Raster<std::uint8_t>& labels,
                                                   int strokes_of_each, int length, int width = 3) {
  constexpr int rim = 2;
  specimen::Raster<std::uint8_t> strokes(labels.rows, labels.cols, specimen::no_stroke);
  specimen::Random random(7);
  for (std::uint8_t label = 0; label < 3; ++label)
    for (int made = 0, tries = 0; made < strokes_of_each && tries < 100'000; ++tries) {
      const int row = static_cast<int>(random.uniform(rim, labels.rows - length - rim));
      const int col = static_cast<int>(random.uniform(rim, labels.cols - width - rim));
      bool fits = true;
      for (int r = row - rim; r < row + length + rim; ++r)
        for (int c = col - rim; c < col + width + rim; ++c)
          fits = fits && labels(r, c) == label && strokes(r, c) == specimen::no_stroke;
      if (!fits) continue;
      ++made;
      for (int r = row; r < row + length; ++r)
        for (int c = col; c < col + width; ++c) strokes(r, c) = label;
    }
  return strokes;
}

/// The file of a layer that is transparent but for strokes.
inline std::vector<std::uint8_t> stroke_layer(const specimen::Raster<std::uint8_t>& strokes) {
  PngRecipe recipe{.cols = strokes.cols, .rows = strokes.rows, .colour_type = PNG_COLOR_TYPE_RGB_ALPHA};
  for (const std::uint8_t label : strokes.data) {
    const bool is_shown = label != specimen::no_stroke;
    const specimen::Rgb colour =
        !is_shown || label == specimen::cut_stroke ? specimen::cut_colour : specimen::phase_colour(label);
    recipe.data.insert(recipe.data.end(),
                       {colour.r, colour.g, colour.b, static_cast<std::uint8_t>(is_shown ? 255 : 0)});
  }
  return make_png(recipe);
}

}  // namespace specimen_test
