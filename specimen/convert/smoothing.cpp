#include "specimen/convert/smoothing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace specimen {
namespace {

constexpr std::size_t most_levels = 65'536;

/// Call `sum(row, col, r, c)` for each pixel (r, c) and the pixel (row, col) of the small picture it is part
/// of.
template <class Small, class Add>
void for_each_square(const Raster<Small>& small, int rows, int cols, int factor, Add add) {
  for (int row = 0; row < small.rows; ++row)
    for (int r = row * factor; r < std::min(rows, (row + 1) * factor); ++r)
      for (int c = 0; c < cols; ++c) add(row, c / factor, r, c);
}

/// Pixels in the square that becomes (row, col).
int square_size(int row, int col, int rows, int cols, int factor) {
  return (std::min(rows, (row + 1) * factor) - row * factor) *
         (std::min(cols, (col + 1) * factor) - col * factor);
}

/// The levels of a picture in rising order, and the place of each pixel among them.
struct Ranked {
  std::vector<double> levels;
  Raster<std::uint16_t> rank;
};

Ranked rank_levels(const Raster<double>& picture) {
  Ranked ranked{picture.data, Raster<std::uint16_t>(picture.rows, picture.cols)};
  std::vector<double>& levels = ranked.levels;
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  if (levels.size() > most_levels) {
    const double low = levels.front(), step = (levels.back() - low) / (most_levels - 1);
    levels.resize(most_levels);
    for (std::size_t i = 0; i < most_levels; ++i) levels[i] = low + static_cast<double>(i) * step;
    std::transform(picture.data.begin(), picture.data.end(), ranked.rank.data.begin(),
                   [&](double v) { return static_cast<std::uint16_t>(std::lround((v - low) / step)); });
  } else {
    std::transform(picture.data.begin(), picture.data.end(), ranked.rank.data.begin(), [&](double v) {
      return static_cast<std::uint16_t>(std::lower_bound(levels.begin(), levels.end(), v) - levels.begin());
    });
  }
  return ranked;
}

/// Ranks in a window that slides: counts in 256 groups of 256, so that the median is found in two short
/// walks.
class Window {
 public:
  void add(std::uint16_t rank, int times) {
    group_[rank >> 8] += times;
    each_[rank] += times;
    total_ += times;
  }
  [[nodiscard]] std::uint16_t median() const {
    int left = total_ / 2;
    std::size_t group = 0;
    while (left >= group_[group]) left -= group_[group++];
    std::size_t rank = group << 8;
    while (left >= each_[rank]) left -= each_[rank++];
    return static_cast<std::uint16_t>(rank);
  }

 private:
  std::array<int, 256> group_{};
  std::vector<int> each_ = std::vector<int>(most_levels, 0);
  int total_ = 0;
};

/// Sums over any rectangle at once; exact as long as the values are whole numbers.
class Sums {
 public:
  explicit Sums(const Raster<double>& values) : corner_(values.rows + 1, values.cols + 1, 0.0) {
    for (int r = 0; r < values.rows; ++r)
      for (int c = 0; c < values.cols; ++c)
        corner_(r + 1, c + 1) = values(r, c) + corner_(r, c + 1) + corner_(r + 1, c) - corner_(r, c);
  }
  /// Mean over rows top ... bottom and columns left ... right, cut off at the borders.
  [[nodiscard]] double mean(int top, int bottom, int left, int right) const {
    top = std::max(top, 0), bottom = std::min(bottom + 1, corner_.rows - 1);
    left = std::max(left, 0), right = std::min(right + 1, corner_.cols - 1);
    const double sum =
        corner_(bottom, right) - corner_(top, right) - corner_(bottom, left) + corner_(top, left);
    return sum / ((bottom - top) * static_cast<double>(right - left));
  }

 private:
  Raster<double> corner_;
};

}  // namespace

Raster<double> local_mean(const Raster<double>& values, int edge) {
  const Sums sums(values);
  const int reach = edge / 2;
  Raster<double> mean(values.rows, values.cols);
  for (int r = 0; r < values.rows; ++r)
    for (int c = 0; c < values.cols; ++c) mean(r, c) = sums.mean(r - reach, r + reach, c - reach, c + reach);
  return mean;
}

Raster<double> roughness(const Raster<double>& values, int edge) {
  Raster<double> squares = values;
  for (double& v : squares.data) v *= v;
  const Sums first(values), second(squares);
  const int reach = edge - 1;
  Raster<double> rough(values.rows, values.cols);
  for (int r = 0; r < values.rows; ++r)
    for (int c = 0; c < values.cols; ++c) {
      double least = std::numeric_limits<double>::infinity();
      for (const int top : {r - reach, r})
        for (const int left : {c - reach, c}) {
          const double mean = first.mean(top, top + reach, left, left + reach);
          least = std::min(least, second.mean(top, top + reach, left, left + reach) - mean * mean);
        }
      rough(r, c) = std::sqrt(std::max(0.0, least));
    }
  return rough;
}

Raster<double> shrunk(const Raster<double>& picture, int factor) {
  Raster<double> small((picture.rows + factor - 1) / factor, (picture.cols + factor - 1) / factor, 0.0);
  for_each_square(small, picture.rows, picture.cols, factor,
                  [&](int row, int col, int r, int c) { small(row, col) += picture(r, c); });
  for (int row = 0; row < small.rows; ++row)
    for (int col = 0; col < small.cols; ++col)
      small(row, col) /= square_size(row, col, picture.rows, picture.cols, factor);
  return small;
}

Raster<Rgb> shrunk(const Raster<Rgb>& picture, int factor) {
  using Sum = std::array<int, 3>;
  Raster<Sum> sums((picture.rows + factor - 1) / factor, (picture.cols + factor - 1) / factor, Sum{});
  for_each_square(sums, picture.rows, picture.cols, factor, [&](int row, int col, int r, int c) {
    const Rgb& p = picture(r, c);
    Sum& s = sums(row, col);
    s[0] += p.r, s[1] += p.g, s[2] += p.b;
  });
  Raster<Rgb> small(sums.rows, sums.cols);
  for (int row = 0; row < small.rows; ++row)
    for (int col = 0; col < small.cols; ++col) {
      const int n = square_size(row, col, picture.rows, picture.cols, factor);
      const auto mean = [&](int sum) { return static_cast<std::uint8_t>((sum + n / 2) / n); };
      small(row, col) = {mean(sums(row, col)[0]), mean(sums(row, col)[1]), mean(sums(row, col)[2])};
    }
  return small;
}

Raster<double> median_of(const Raster<double>& picture, int edge) {
  const Ranked ranked = rank_levels(picture);
  const int reach = edge / 2;
  Raster<double> smooth(picture.rows, picture.cols);
  for (int row = 0; row < picture.rows; ++row) {
    const int top = std::max(0, row - reach), bottom = std::min(picture.rows - 1, row + reach);
    Window window;
    const auto column = [&](int col, int times) {
      if (col >= 0 && col < picture.cols)
        for (int r = top; r <= bottom; ++r) window.add(ranked.rank(r, col), times);
    };
    for (int col = 0; col < reach; ++col) column(col, 1);
    for (int col = 0; col < picture.cols; ++col) {
      column(col + reach, 1);
      smooth(row, col) = ranked.levels[window.median()];
      column(col - reach, -1);
    }
  }
  return smooth;
}

}  // namespace specimen
