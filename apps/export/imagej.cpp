#include "apps/export/imagej.hpp"

#include <fmt/format.h>
#include <zip.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>

#include "specimen/body/error.hpp"

namespace exchange {

std::string inclusion_table(const std::vector<specimen::Inclusion>& inclusions) {
  constexpr double mm = 1e3;
  constexpr double mm2 = 1e6;
  constexpr double deg = 180 / std::numbers::pi;
  std::string table =
      "id,x_mm,y_mm,a_mm,b_mm,angle_deg,area_mm2,perimeter_mm,equivalent_diameter_mm,orientation_deg\n";
  for (const specimen::Inclusion& inclusion : inclusions) {
    const specimen::Ellipse& ellipse = inclusion.ellipse;
    table += fmt::format("{},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g},{:.10g}\n",
                         inclusion.id, mm * ellipse.x, mm * ellipse.y, mm * ellipse.a, mm * ellipse.b,
                         deg * ellipse.angle, mm2 * inclusion.area, mm * inclusion.perimeter,
                         mm * inclusion.equivalent_diameter, deg * inclusion.orientation);
  }
  return table;
}

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

namespace {

constexpr zip_uint16_t first_day = 1 << 5 | 1;  ///< 1 January 1980 as ZIP writes days

struct Discard {
  void operator()(zip_t* archive) const { zip_discard(archive); }
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
using Archive = std::unique_ptr<zip_t, Discard>;
using Source = std::unique_ptr<zip_source_t, Discard>;

[[noreturn]] void fail(const std::string& path, const char* reason) {
  throw specimen::Error(path, std::string("cannot be written as ZIP: ") + reason, "", "",
                        specimen::Fault::write);
}

void add(const std::string& path, zip_t* archive, const NamedBytes& file) {
  Source source(zip_source_buffer(archive, file.bytes.data(), file.bytes.size(), 0));
  const zip_int64_t index =
      source ? zip_file_add(archive, file.name.c_str(), source.get(), ZIP_FL_ENC_UTF_8) : -1;
  if (index < 0) fail(path, zip_strerror(archive));
  (void)source.release();  // belongs to the archive now
  if (zip_file_set_dostime(archive, static_cast<zip_uint64_t>(index), 0, first_day, 0) != 0)
    fail(path, zip_strerror(archive));
}

std::string read_all(const std::string& path, zip_source_t* source) {
  zip_stat_t size;
  if (zip_source_stat(source, &size) != 0 || zip_source_open(source) != 0)
    fail(path, zip_error_strerror(zip_source_error(source)));
  std::string bytes(size.size, '\0');
  const zip_int64_t count = zip_source_read(source, bytes.data(), bytes.size());
  zip_source_close(source);
  if (count != static_cast<zip_int64_t>(bytes.size())) fail(path, "it is cut off");
  return bytes;
}

}  // namespace

std::string zipped(const std::string& path, const std::vector<NamedBytes>& files) {
  zip_error_t error;
  zip_error_init(&error);
  const Source memory(zip_source_buffer_create(nullptr, 0, 0, &error));
  if (!memory) fail(path, zip_error_strerror(&error));
  Archive archive(zip_open_from_source(memory.get(), ZIP_TRUNCATE, &error));
  if (!archive) fail(path, zip_error_strerror(&error));
  zip_source_keep(memory.get());  // the archive takes it, and it is read afterwards
  for (const NamedBytes& file : files) add(path, archive.get(), file);
  if (zip_close(archive.get()) != 0) fail(path, zip_strerror(archive.get()));
  (void)archive.release();  // closed
  return read_all(path, memory.get());
}

}  // namespace exchange
