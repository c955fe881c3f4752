#include "apps/export/roi.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace exchange {
namespace {

constexpr std::size_t header_size = 64;   ///< [bytes]
constexpr int version = 228;              ///< from which on a polygon may have more than 65535 corners
constexpr int subpixel_resolution = 128;  ///< of the options: coordinates with fractions follow
constexpr std::size_t most_corners_in_header = 65535;

/// Bytes of a file at known places.
class Layout {
 public:
  explicit Layout(std::size_t size) : bytes_(size, '\0') {}
  void text(std::size_t at, std::string_view value) { bytes_.replace(at, value.size(), value); }
  void put16(std::size_t at, std::uint32_t value) { put(at, value, 2); }
  void put32(std::size_t at, std::uint32_t value) { put(at, value, 4); }
  void real(std::size_t at, double value) {
    put32(at, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
  }
  [[nodiscard]] std::string bytes() && { return std::move(bytes_); }

 private:
  void put(std::size_t at, std::uint32_t value, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      bytes_[at + i] = static_cast<char>(value >> 8 * (count - 1 - i) & 0xFF);
  }
  std::string bytes_;
};

/// A whole number of pixels as a field of 16 bits; what is beyond it is told by the fractions alone.
std::uint32_t clamped(double pixels) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(pixels, 0.0, 32767.0)));
}

specimen::Point in_picture(specimen::Point corner, const specimen::LabelledMask& mask) {
  return {corner.x / mask.pixel_size, mask.labels.rows - corner.y / mask.pixel_size};
}

/// Polygon inscribed in an ellipse: n equal steps leave it by a (1 - cos(pi / n)) at most.
std::vector<specimen::Point> polygon_of(const specimen::Ellipse& ellipse, double deviation) {
  const double cosine = std::clamp(1 - deviation / ellipse.a, -0.5, 1 - 1e-8);
  const int count = std::max(12, static_cast<int>(std::ceil(std::numbers::pi / std::acos(cosine))));
  const double c = std::cos(ellipse.angle);
  const double s = std::sin(ellipse.angle);
  std::vector<specimen::Point> corners;
  for (int k = 0; k < count; ++k) {
    const double t = 2 * std::numbers::pi * k / count;
    const double u = ellipse.a * std::cos(t);
    const double v = ellipse.b * std::sin(t);
    corners.push_back({ellipse.x + c * u - s * v, ellipse.y + s * u + c * v});
  }
  return corners;
}

}  // namespace

std::string polygon_roi(const std::vector<specimen::Point>& corners, const specimen::LabelledMask& mask) {
  std::vector<double> x, y;
  for (const specimen::Point& corner : corners) {
    const specimen::Point place = in_picture(corner, mask);
    x.push_back(place.x);
    y.push_back(place.y);
  }
  const double left = std::floor(*std::min_element(x.begin(), x.end()));
  const double top = std::floor(*std::min_element(y.begin(), y.end()));
  const std::size_t n = corners.size();
  Layout roi(header_size + 12 * n);
  roi.text(0, "Iout");
  roi.put16(4, version);
  roi.put16(6, 0);  // a polygon
  roi.put16(8, clamped(top));
  roi.put16(10, clamped(left));
  roi.put16(12, clamped(std::ceil(*std::max_element(y.begin(), y.end()))));
  roi.put16(14, clamped(std::ceil(*std::max_element(x.begin(), x.end()))));
  if (n <= most_corners_in_header)
    roi.put16(16, static_cast<std::uint32_t>(n));
  else
    roi.put32(18, static_cast<std::uint32_t>(n));
  roi.put16(50, subpixel_resolution);
  const std::size_t fractions = header_size + 4 * n;
  for (std::size_t k = 0; k < n; ++k) {
    roi.put16(header_size + 2 * k, clamped(x[k] - left));
    roi.put16(header_size + 2 * (n + k), clamped(y[k] - top));
    roi.real(fractions + 4 * k, x[k]);
    roi.real(fractions + 4 * (n + k), y[k]);
  }
  return std::move(roi).bytes();
}

std::vector<NamedBytes> inclusion_rois(const std::vector<specimen::Inclusion>& inclusions,
                                       const specimen::LabelledMask& mask) {
  constexpr double deviation = 0.05;  // [pixels]
  std::vector<NamedBytes> rois;
  for (const specimen::Inclusion& inclusion : inclusions) {
    const bool exact = inclusion.contour.empty();
    rois.push_back(
        {fmt::format("inclusion_{:04}.roi", inclusion.id),
         polygon_roi(exact ? polygon_of(inclusion.ellipse, deviation * mask.pixel_size) : inclusion.contour,
                     mask)});
  }
  return rois;
}

}  // namespace exchange
