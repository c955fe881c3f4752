#include "apps/drawing/picture_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "apps/text/figures.hpp"

namespace output {
namespace {

using specimen::Raster;
using specimen::Rgb;

Rgb mean_of(const Raster<Rgb>& picture, int top, int left, int side) {
  std::array<int, 3> sum{};
  int count = 0;
  for (int row = top; row < std::min(top + side, picture.rows); ++row)
    for (int col = left; col < std::min(left + side, picture.cols); ++col, ++count) {
      const Rgb& pixel = picture(row, col);
      sum[0] += pixel.r;
      sum[1] += pixel.g;
      sum[2] += pixel.b;
    }
  const auto mean = [count](int total) { return static_cast<std::uint8_t>((total + count / 2) / count); };
  return {mean(sum[0]), mean(sum[1]), mean(sum[2])};
}

}  // namespace

Raster<Rgb> magnified(const Raster<Rgb>& picture, int factor) {
  Raster<Rgb> large(picture.rows * factor, picture.cols * factor);
  for (int row = 0; row < large.rows; ++row)
    for (int col = 0; col < large.cols; ++col) large(row, col) = picture(row / factor, col / factor);
  return large;
}

Raster<Rgb> shrunk(const Raster<Rgb>& picture, int factor) {
  if (factor == 1) return picture;
  Raster<Rgb> small((picture.rows + factor - 1) / factor, (picture.cols + factor - 1) / factor);
  for (int row = 0; row < small.rows; ++row)
    for (int col = 0; col < small.cols; ++col)
      small(row, col) = mean_of(picture, row * factor, col * factor, factor);
  return small;
}

int file_magnification(int rows, int cols) {
  const int wanted = (600 + cols - 1) / cols;
  return std::clamp(4000 / rows, 1, wanted);
}

int shrink_factor(int rows, int cols, int most) { return (std::max(rows, cols) + most - 1) / most; }

namespace {

constexpr double letters = 8;  // width of one, generously

/// Largest length of 1, 2 or 5 times a power of ten [m] that is at most `most`.
double round_length(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0})
    if (step * power <= most) return step * power;
  return power;
}

}  // namespace

int crisp_factor(int rows, int cols) {
  const int wanted = std::max(1, static_cast<int>(std::ceil(2 * picture_width / cols)));
  return std::clamp(8000 / rows, 1, wanted);
}

double add_picture(Drawing& drawing, specimen::Raster<specimen::Rgb> picture) {
  const double height = picture_width * picture.rows / picture.cols;
  drawing.shapes.push_back(Pixels{{0, 0}, picture_width, height, std::move(picture)});
  drawing.shapes.push_back(
      Stroke{{{0, 0}, {picture_width, 0}, {picture_width, height}, {0, height}, {0, 0}}, Ink::axis, 0.75});
  return height;
}

void add_scale_bar(Drawing& drawing, double px_per_metre, double y, const std::string& words) {
  const double length = round_length(0.25 * picture_width / px_per_metre);
  drawing.shapes.push_back(Stroke{{{0, y}, {length * px_per_metre, y}}, Ink::text, 3});
  drawing.shapes.push_back(Words{{length * px_per_metre + 8, y + 5}, concise(1e3 * length) + " mm", 14});
  drawing.shapes.push_back(Words{{picture_width, y + 5}, words, 14, Anchor::end});
}

double add_legend(Drawing& drawing, const std::vector<LegendEntry>& entries, double y) {
  double x = 0;
  for (const LegendEntry& entry : entries) {
    const double width = 22 + letters * static_cast<double>(entry.name.size()) + 12;
    if (x > 0 && x + width > picture_width) {
      x = 0;
      y += text_line;
    }
    drawing.shapes.push_back(Block{{x, y - 11}, 14, 14, entry.colour, true});
    drawing.shapes.push_back(Words{{x + 22, y + 1}, entry.name, 14});
    x += width;
  }
  return y;
}

}  // namespace output
