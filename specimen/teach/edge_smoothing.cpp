#include "specimen/teach/edge_smoothing.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "specimen/teach/box_mean.hpp"
#include "specimen/teach/parallel.hpp"

namespace specimen {
namespace {

/// The inverse of a symmetric matrix, in the order xx, xy, xz, yy, yz, zz.
std::array<float, 6> inverse(const std::array<float, 6>& m) {
  const float a = m[3] * m[5] - m[4] * m[4], b = m[2] * m[4] - m[1] * m[5], c = m[1] * m[4] - m[2] * m[3];
  const float one_over = 1 / (m[0] * a + m[1] * b + m[2] * c);
  return {a * one_over,
          b * one_over,
          c * one_over,
          (m[0] * m[5] - m[2] * m[2]) * one_over,
          (m[1] * m[2] - m[0] * m[4]) * one_over,
          (m[0] * m[3] - m[1] * m[1]) * one_over};
}

constexpr std::array<std::pair<std::size_t, std::size_t>, 6> pairs{
    {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};

/// The filter of a band; the guide is the same for all classes.
class GuidedBand {
 public:
  GuidedBand(const Raster<Lab>& picture, const Band& band, int radius, double ridge)
      : band_(band), box_(band, radius) {
    for (Plane& plane : guide_) plane.resize(band.size());
    std::size_t i = 0;
    for (int r = band.first; r < band.last; ++r)
      for (int c = 0; c < band.cols; ++c, ++i) {
        const Lab lab = picture(r, c);
        guide_[0][i] = static_cast<float>(lab.l());
        guide_[1][i] = static_cast<float>(lab.a());
        guide_[2][i] = static_cast<float>(lab.b());
      }
    mean_ = guide_;
    for (Plane& plane : mean_) box_.apply(plane);
    std::array<Plane, 6> products;
    for (std::size_t k = 0; k < pairs.size(); ++k)
      products[k] = mean_of_product(guide_[pairs[k].first], guide_[pairs[k].second]);
    inverse_.resize(band.size());
    const auto least = static_cast<float>(ridge * ridge);
    for (i = 0; i < band.size(); ++i) {
      std::array<float, 6> covariance;
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        const auto [x, y] = pairs[k];
        covariance[k] = products[k][i] - mean_[x][i] * mean_[y][i] + (x == y ? least : 0.0F);
      }
      inverse_[i] = inverse(covariance);
    }
  }

  void apply(Plane& share) {
    std::array<Plane, 3> slope;
    for (std::size_t k = 0; k < 3; ++k) slope[k] = mean_of_product(guide_[k], share);
    Plane offset = share;
    box_.apply(offset);
    for (std::size_t i = 0; i < share.size(); ++i) {
      std::array<float, 3> v;
      for (std::size_t k = 0; k < 3; ++k) v[k] = slope[k][i] - mean_[k][i] * offset[i];
      const std::array<float, 6>& m = inverse_[i];
      slope[0][i] = m[0] * v[0] + m[1] * v[1] + m[2] * v[2];
      slope[1][i] = m[1] * v[0] + m[3] * v[1] + m[4] * v[2];
      slope[2][i] = m[2] * v[0] + m[4] * v[1] + m[5] * v[2];
      for (std::size_t k = 0; k < 3; ++k) offset[i] -= slope[k][i] * mean_[k][i];
    }
    for (Plane& plane : slope) box_.apply(plane);
    box_.apply(offset);
    for (std::size_t i = 0; i < share.size(); ++i)
      share[i] =
          slope[0][i] * guide_[0][i] + slope[1][i] * guide_[1][i] + slope[2][i] * guide_[2][i] + offset[i];
  }

 private:
  Plane mean_of_product(const Plane& a, const Plane& b) {
    Plane product(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) product[i] = a[i] * b[i];
    box_.apply(product);
    return product;
  }

  Band band_;
  BoxMean box_;
  std::array<Plane, 3> guide_, mean_;
  std::vector<std::array<float, 6>> inverse_;
};

/// Rows begin to end - 1 of the result. The last class gets what the others leave, for they sum up to one
/// before and after.
void smooth_rows(const ClassShares& shares, const Raster<Lab>& picture, int radius, double ridge, int begin,
                 int end, ClassShares& result) {
  const Band band{std::max(0, begin - 2 * radius), std::min(shares.rows, end + 2 * radius), shares.cols};
  GuidedBand guided(picture, band, radius, ridge);
  std::vector<Plane> planes(static_cast<std::size_t>(shares.classes - 1), Plane(band.size()));
  for (std::size_t k = 0; k < planes.size(); ++k) {
    std::size_t i = 0;
    for (int r = band.first; r < band.last; ++r)
      for (int c = 0; c < band.cols; ++c) planes[k][i++] = static_cast<float>(shares.at(r, c)[k]) / 255;
    guided.apply(planes[k]);
  }
  std::size_t i = static_cast<std::size_t>(begin - band.first) * static_cast<std::size_t>(band.cols);
  for (int r = begin; r < end; ++r)
    for (int c = 0; c < band.cols; ++c, ++i) {
      float left = 1;
      std::uint8_t* out = result.at(r, c);
      for (std::size_t k = 0; k < planes.size(); ++k) {
        const float share = std::clamp(planes[k][i], 0.0F, std::max(0.0F, left));
        out[k] = static_cast<std::uint8_t>(std::lround(share * 255));
        left -= share;
      }
      out[planes.size()] = static_cast<std::uint8_t>(std::lround(std::max(0.0F, left) * 255));
    }
}

}  // namespace

ClassShares smoothed_along_edges(const ClassShares& shares, const Raster<Lab>& picture, int radius,
                                 double ridge, int threads) {
  if (radius <= 0 || shares.classes < 2) return shares;
  ClassShares result(shares.rows, shares.cols, shares.classes);
  const int height = std::max(64, 4 * radius);
  share_out((shares.rows + height - 1) / height, threads, [&](int part) {
    smooth_rows(shares, picture, radius, ridge, part * height, std::min(shares.rows, (part + 1) * height),
                result);
  });
  return result;
}

}  // namespace specimen
