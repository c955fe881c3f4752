#include "specimen/teach/even_light.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace specimen {
namespace {

constexpr std::size_t terms = 6;
using Terms = std::array<double, terms>;

/// Of second order, at a place from -1 to 1.
Terms terms_at(double x, double y) { return {1, x, y, x * x, x * y, y * y}; }

double sum_of(const Terms& factors, const Terms& values) {
  double sum = 0;
  for (std::size_t i = 0; i < terms; ++i) sum += factors[i] * values[i];
  return sum;
}

/// A block of the picture.
struct Block {
  Terms at{};
  double lightness = 0;  ///< L + 16, the median
};

double place(double at, int count) { return count > 1 ? 2 * at / (count - 1) - 1 : 0; }

double middle_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<Block> blocks_of(const Raster<Lab>& picture) {
  constexpr int across = 32;
  const int edge = std::max(1, std::min(picture.rows, picture.cols) / across);
  std::vector<Block> blocks;
  for (int row = 0; row + edge <= picture.rows; row += edge)
    for (int col = 0; col + edge <= picture.cols; col += edge) {
      std::vector<double> values;
      for (int r = row; r < row + edge; ++r)
        for (int c = col; c < col + edge; ++c) values.push_back(picture(r, c).l() + 16);
      blocks.push_back(
          {terms_at(place(col + (edge - 1) / 2.0, picture.cols), place(row + (edge - 1) / 2.0, picture.rows)),
           middle_of(std::move(values))});
    }
  return blocks;
}

/// The factors with the least weighted squares, by elimination; a term that the blocks do not tell is 0.
Terms fitted(const std::vector<Block>& blocks, const std::vector<double>& weights) {
  std::array<std::array<double, terms + 1>, terms> m{};
  for (std::size_t k = 0; k < blocks.size(); ++k)
    for (std::size_t i = 0; i < terms; ++i) {
      for (std::size_t j = 0; j < terms; ++j) m[i][j] += weights[k] * blocks[k].at[i] * blocks[k].at[j];
      m[i][terms] += weights[k] * blocks[k].at[i] * blocks[k].lightness;
    }
  Terms factors{};
  std::array<bool, terms> known{};
  for (std::size_t i = 0; i < terms; ++i) {
    known[i] = m[i][i] > 1e-9 * std::max(1.0, m[0][0]);
    if (!known[i]) continue;
    for (std::size_t row = 0; row < terms; ++row) {
      if (row == i) continue;
      const double times = m[row][i] / m[i][i];
      for (std::size_t j = i; j <= terms; ++j) m[row][j] -= times * m[i][j];
    }
  }
  for (std::size_t i = 0; i < terms; ++i)
    if (known[i]) factors[i] = m[i][terms] / m[i][i];
  return factors;
}

Terms robust_surface(const std::vector<Block>& blocks) {
  constexpr int rounds = 30;
  constexpr double tuning = 4.685, to_deviation = 1.4826;  // of a normal distribution
  std::vector<double> weights(blocks.size(), 1), away(blocks.size());
  Terms surface = fitted(blocks, weights);
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t k = 0; k < blocks.size(); ++k)
      away[k] = std::abs(blocks[k].lightness - sum_of(surface, blocks[k].at));
    const double reach = std::max(0.5, tuning * to_deviation * middle_of(away));
    for (std::size_t k = 0; k < blocks.size(); ++k) {
      const double part = away[k] / reach;
      weights[k] = part < 1 ? (1 - part * part) * (1 - part * part) : 0;
    }
    surface = fitted(blocks, weights);
  }
  return surface;
}

std::uint8_t byte_of(double value) {
  return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
}

}  // namespace

double even_light(Raster<Lab>& picture) {
  const std::vector<Block> blocks = blocks_of(picture);
  const Terms surface = robust_surface(blocks);
  double mean = 0, brightest = 0, darkest = 1e9;
  for (const Block& block : blocks) {
    const double light = std::max(1.0, sum_of(surface, block.at));
    mean += light / static_cast<double>(blocks.size());
    brightest = std::max(brightest, light);
    darkest = std::min(darkest, light);
  }
  for (int r = 0; r < picture.rows; ++r)
    for (int c = 0; c < picture.cols; ++c) {
      const double light = sum_of(surface, terms_at(place(c, picture.cols), place(r, picture.rows)));
      const double gain = std::clamp(mean / std::max(1.0, light), 0.5, 2.0);
      Lab& lab = picture(r, c);
      lab = {byte_of(((lab.l() + 16) * gain - 16) * 2.55), byte_of(lab.a() * gain + 128),
             byte_of(lab.b() * gain + 128)};
    }
  return std::pow(brightest / darkest, 3);
}

}  // namespace specimen
