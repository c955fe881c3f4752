/// Small pictures that the conversion tests draw themselves.
#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "specimen/convert/grains.hpp"
#include "specimen/picture/picture.hpp"

namespace specimen_test {

/// Cells of a picture of characters: '.' mortar, ' ' void, 'a' aggregate without a number, '1' to '9' grains.
inline specimen::Raster<specimen::Cell> cells_of(const std::vector<std::string>& rows) {
  specimen::Raster<specimen::Cell> cells(static_cast<int>(rows.size()),
                                         static_cast<int>(rows.front().size()));
  for (int r = 0; r < cells.rows; ++r)
    for (int c = 0; c < cells.cols; ++c) {
      const char character = rows[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)];
      cells(r, c) = character == '.'   ? specimen::phase::mortar
                    : character == ' ' ? specimen::phase::void_
                    : character == 'a' ? specimen::phase::aggregate
                                       : specimen::grain(character - '0');
    }
  return cells;
}

/// The other way round, so that a failure can be looked at.
inline std::vector<std::string> text_of(const specimen::Raster<specimen::Cell>& cells) {
  std::vector<std::string> rows;
  for (int r = 0; r < cells.rows; ++r) {
    rows.emplace_back();
    for (int c = 0; c < cells.cols; ++c) {
      const specimen::Cell cell = cells(r, c);
      rows.back() += cell == specimen::phase::mortar  ? '.'
                     : cell == specimen::phase::void_ ? ' '
                     : cell == specimen::phase::aggregate
                         ? 'a'
                         : static_cast<char>('0' + cell - specimen::first_grain);
    }
  }
  return rows;
}

/// Set every pixel whose centre lies within `radius` of (row, col) [px].
template <class T>
void draw_disc(specimen::Raster<T>& picture, double row, double col, double radius, T value) {
  for (int r = 0; r < picture.rows; ++r)
    for (int c = 0; c < picture.cols; ++c)
      if ((r - row) * (r - row) + (c - col) * (c - col) <= radius * radius) picture(r, c) = value;
}

/// Add up to +-amplitude to each channel of each pixel.
inline void add_noise(specimen::Raster<specimen::Rgb>& picture, int amplitude, std::uint64_t seed = 1) {
  std::mt19937_64 random(seed);
  const auto shift = [&](std::uint8_t& channel) {
    const int change = static_cast<int>(random() % static_cast<unsigned>(2 * amplitude + 1)) - amplitude;
    channel = static_cast<std::uint8_t>(std::min(255, std::max(0, channel + change)));
  };
  for (specimen::Rgb& p : picture.data) {
    shift(p.r);
    shift(p.g);
    shift(p.b);
  }
}

inline specimen::Rgb grey(int level) {
  const auto byte = static_cast<std::uint8_t>(level);
  return {byte, byte, byte};
}

/// Three stones and two rows of pores in mortar, with edges as blurred as a lens makes them, in greys; 240 x
/// 240.
inline specimen::Raster<specimen::Rgb> cut_with_pores(specimen::Rgb pore, specimen::Rgb stone,
                                                      specimen::Rgb mortar, int pores, int noise) {
  specimen::Raster<specimen::Rgb> picture(240, 240, mortar);
  draw_disc(picture, 60, 70, 30, stone);
  draw_disc(picture, 150, 160, 30, stone);
  draw_disc(picture, 60, 180, 30, stone);
  for (int i = 0; i < pores; ++i) draw_disc(picture, 220 - 8 * (i % 2), 15 + 216 / pores * i, 3.2, pore);
  specimen::Raster<specimen::Rgb> blurred = picture;
  for (int r = 1; r + 1 < picture.rows; ++r)
    for (int c = 1; c + 1 < picture.cols; ++c) {
      int sum = 0;
      for (int k = 0; k < 9; ++k)
        sum += (k % 2 == 0 ? k == 4 ? 4 : 1 : 2) * picture(r + k / 3 - 1, c + k % 3 - 1).r;
      blurred(r, c) = grey(sum / 16);
    }
  add_noise(blurred, noise);
  return blurred;
}

}  // namespace specimen_test
