#include "specimen/describe/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

#include "specimen/picture/image_libraries.hpp"

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

// Pairs that were found and pairs that there are, per distance.
struct PairCount {
  std::vector<double> found, all;
  explicit PairCount(int lags) : found(lags, 0), all(lags, 0) {}
  void add(std::size_t lag, double pairs, double possible) {
    found[lag] += pairs;
    all[lag] += possible;
  }
  [[nodiscard]] std::vector<double> shares() const {
    std::vector<double> result(found.size());
    for (std::size_t lag = 0; lag < found.size(); ++lag) result[lag] = found[lag] / all[lag];
    return result;
  }
};

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
  if (mask.labels.empty()) return {};
  const int rows = mask.labels.rows, cols = mask.labels.cols, most = std::min(rows, cols) / 2;
  Raster<std::uint8_t> set(rows, cols);
  std::transform(mask.labels.data.begin(), mask.labels.data.end(), set.data.begin(),
                 [label](std::uint8_t one) { return static_cast<std::uint8_t>(one == label); });
  const Raster<std::int64_t> pairs = count_pairs(set, most);
  PairCount radial(most + 1), along_x(most + 1), along_y(most + 1);
  for (int down = 0; down <= most; ++down) {
    for (int right = down == 0 ? 0 : -most; right <= most; ++right) {
      const long lag = std::lround(std::hypot(down, right));
      if (lag > most) continue;
      const auto found = static_cast<double>(pairs(down, most + right));
      const double possible = static_cast<double>(rows - down) * (cols - std::abs(right));
      radial.add(lag, found, possible);
      if (down == 0) along_x.add(lag, found, possible);
      if (right == 0) along_y.add(lag, found, possible);
    }
  }
  TwoPoint s2{{}, radial.shares(), along_x.shares(), along_y.shares()};
  for (int lag = 0; lag <= most; ++lag) s2.distance.push_back(lag * mask.pixel_size);
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
