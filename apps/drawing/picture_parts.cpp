#include "apps/drawing/picture_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
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

constexpr double letters = 8;  // width of one of the usual size, generously

double width_of(const Drawing& drawing, const std::string& words) {
  const auto is_letter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };  // of UTF-8
  return letters * drawing.text * static_cast<double>(std::count_if(words.begin(), words.end(), is_letter));
}

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

double add_scale_bar(Drawing& drawing, double px_per_metre, double y, const std::string& words) {
  const double length = round_length(0.25 * picture_width / px_per_metre);
  const double size = 14 * drawing.text, bar = length * px_per_metre;
  const std::string what = concise(1e3 * length) + " mm";
  drawing.shapes.push_back(Stroke{{{0, y}, {bar, y}}, Ink::text, 3});
  drawing.shapes.push_back(Words{{bar + 8, y + 5 * drawing.text}, what, size});
  const double usual = 7.0 / letters;  // of words of the usual kind, which may come close to the bar
  const bool beside = bar + 8 + usual * (width_of(drawing, what) + width_of(drawing, words)) <= picture_width;
  if (!beside) return add_words(drawing, words, y + (text_line + 5) * drawing.text, size) - 5 * drawing.text;
  drawing.shapes.push_back(Words{{picture_width, y + 5 * drawing.text}, words, size, Anchor::end});
  return y;
}

double add_words(Drawing& drawing, const std::string& words, double y, double size, Ink ink) {
  const auto put = [&](const std::string& line) {
    drawing.shapes.push_back(Words{{0, y}, line, size, Anchor::start, ink});
  };
  std::string line, word;
  std::istringstream rest(words);
  while (rest >> word) {
    const std::string longer = line.empty() ? word : line + " " + word;
    if (line.empty() || 0.95 * width_of(drawing, longer) <= picture_width) {
      line = longer;
      continue;
    }
    put(line);
    y += 1.4 * size;
    line = word;
  }
  put(line);
  return y;
}

double add_legend(Drawing& drawing, const std::vector<LegendEntry>& entries, double y) {
  double x = 0;
  for (const LegendEntry& entry : entries) {
    const double width = (22 + letters * static_cast<double>(entry.name.size()) + 12) * drawing.text;
    if (x > 0 && x + width > picture_width) {
      x = 0;
      y += text_line * drawing.text;
    }
    const double side = 14 * drawing.text;
    drawing.shapes.push_back(Block{{x, y - side + 3}, side, side, entry.colour, true});
    drawing.shapes.push_back(Words{{x + side + 8, y + 1}, entry.name, side});
    x += width;
  }
  return y;
}

}  // namespace output
