#include "specimen/statistics.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace specimen {
namespace {

// Diameters at which a sieve curve is told, rising.
std::vector<double> sieves_of(const std::vector<Inclusion>& inclusions, const Grading& target) {
  std::vector<double> sieves;
  if (!target.empty()) {
    for (const SizeClass& size : target) {
      sieves.push_back(size.d_min);
      sieves.push_back(size.d_max);
    }
    std::sort(sieves.begin(), sieves.end());
    const auto same = [](double d, double e) { return e - d < 1e-9 * e; };
    sieves.erase(std::unique(sieves.begin(), sieves.end(), same), sieves.end());
    return sieves;
  }
  if (inclusions.empty()) return sieves;
  const auto [least, largest] = std::minmax_element(
      inclusions.begin(), inclusions.end(),
      [](const Inclusion& p, const Inclusion& q) { return p.equivalent_diameter < q.equivalent_diameter; });
  constexpr int count = 10;
  const double from = least->equivalent_diameter, to = largest->equivalent_diameter;
  for (int i = 0; i < count; ++i) sieves.push_back(i + 1 < count ? from + (to - from) * i / (count - 1) : to);
  return sieves;
}

double passing(const Grading& grading, double diameter) {
  double sum = 0;
  for (const SizeClass& size : grading) {
    const double width = size.d_max - size.d_min;
    const double part = width > 0 ? (diameter - size.d_min) / width : (diameter >= size.d_max ? 1.0 : 0.0);
    sum += size.share * std::clamp(part, 0.0, 1.0);
  }
  return sum;
}

// One bit a pixel, 64 to a word, every line padded with zeros by a word.
struct BitLines {
  std::size_t words;  // of a line
  std::vector<std::uint64_t> bits;

  BitLines(int lines, int length)
      : words(static_cast<std::size_t>(length) / 64 + 2), bits(static_cast<std::size_t>(lines) * words, 0) {}
  void set(int line, int at) {
    bits[static_cast<std::size_t>(line) * words + static_cast<std::size_t>(at) / 64] |= std::uint64_t{1}
                                                                                        << (at % 64);
  }
};

// Number of pairs of set bits `lag` apart on one line, over all lines.
std::int64_t pairs_at(const BitLines& lines, int lag) {
  const std::size_t skip = static_cast<std::size_t>(lag) / 64;
  const int shift = lag % 64;
  std::int64_t pairs = 0;
  for (std::size_t start = 0; start < lines.bits.size(); start += lines.words) {
    const std::uint64_t* line = lines.bits.data() + start;
    for (std::size_t w = 0; w + skip + 1 < lines.words; ++w) {
      const std::uint64_t low = line[w + skip] >> shift;
      const std::uint64_t high = shift == 0 ? 0 : line[w + skip + 1] << (64 - shift);
      pairs += std::popcount(line[w] & (low | high));
    }
  }
  return pairs;
}

// Edges between a pixel of the label and one of another, per pair of pixels that lie (down, right) apart.
std::int64_t crossings(const LabelledMask& mask, std::uint8_t label, int down, int right) {
  const Raster<std::uint8_t>& labels = mask.labels;
  std::int64_t count = 0;
  for (int row = 0; row + down < labels.rows; ++row) {
    for (int col = std::max(0, -right); col + std::max(0, right) < labels.cols; ++col) {
      count += (labels(row, col) == label) != (labels(row + down, col + right) == label);
    }
  }
  return count;
}

}  // namespace

std::vector<double> fractions(const LabelledMask& mask) {
  std::vector<double> shares;
  for (const std::int64_t n : count_labels(mask))
    shares.push_back(mask.labels.empty() ? 0
                                         : static_cast<double>(n) / static_cast<double>(mask.labels.size()));
  return shares;
}

std::vector<Passing> sieve_curve(const std::vector<Inclusion>& inclusions, const Grading& target) {
  double whole = 0;
  for (const Inclusion& inclusion : inclusions) whole += inclusion.area;
  std::vector<Passing> curve;
  for (const double d : sieves_of(inclusions, target)) {
    double below = 0;
    for (const Inclusion& inclusion : inclusions) {
      // An aggregate of just the size of the sieve passes it, whatever the rounding of its area.
      if (inclusion.equivalent_diameter <= d * (1 + 1e-9)) below += inclusion.area;
    }
    curve.push_back({d, whole > 0 ? below / whole : 0,
                     target.empty() ? std::numeric_limits<double>::quiet_NaN() : passing(target, d)});
  }
  return curve;
}

TwoPoint two_point_correlation(const LabelledMask& mask, std::uint8_t label) {
  const int rows = mask.labels.rows, cols = mask.labels.cols;
  BitLines along_rows(rows, cols), along_cols(cols, rows);
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      if (mask.labels(row, col) != label) continue;
      along_rows.set(row, col);
      along_cols.set(col, row);
    }
  }
  TwoPoint s2;
  for (int lag = 0; lag <= std::min(rows, cols) / 2 && !mask.labels.empty(); ++lag) {
    const double pairs_in_rows = static_cast<double>(rows) * (cols - lag);
    const double pairs_in_cols = static_cast<double>(cols) * (rows - lag);
    s2.distance.push_back(lag * mask.pixel_size);
    s2.probability.push_back((static_cast<double>(pairs_at(along_rows, lag)) / pairs_in_rows +
                              static_cast<double>(pairs_at(along_cols, lag)) / pairs_in_cols) /
                             2);
  }
  return s2;
}

// Cauchy-Crofton: length = 1/2 integral over directions and offsets of the number of crossings of a line.
// Four directions, pi / 4 each; the lines lie a pixel apart along the axes and pixel / sqrt(2) on the
// diagonals.
double perimeter(const LabelledMask& mask, std::uint8_t label) {
  const auto level = crossings(mask, label, 0, 1) + crossings(mask, label, 1, 0);
  const auto diagonal = crossings(mask, label, 1, 1) + crossings(mask, label, 1, -1);
  return std::numbers::pi / 8 * mask.pixel_size *
         (static_cast<double>(level) + static_cast<double>(diagonal) / std::numbers::sqrt2);
}

}  // namespace specimen
