#include "specimen/body/measure.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "specimen/body/mask.hpp"

namespace specimen {
namespace {

/// Sums over the pixels of a grain; x and y are the centres of the pixels [px], y upwards.
struct Moments {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  void add(double px, double py) {
    n += 1, x += px, y += py;
    xx += px * px, xy += px * py, yy += py * py;
  }
};

struct Pixel {
  int row = -1, col = -1;
};

/// Walk along the pixel edges with the grain on the left, from the top edge of a pixel, whose number in
/// `walked` tells that this edge has been walked.
/// @return middles of the edges [px], y upwards; counter-clockwise round a grain, clockwise round a hole.
std::vector<Point> walk_round(const Raster<std::int32_t>& instances, Pixel start,
                              Raster<std::uint8_t>& walked) {
  const std::int32_t id = instances(start.row, start.col);
  const auto inside = [&](int row, int col) {
    return instances.contains(row, col) && instances(row, col) == id;
  };
  // Directions right, up, left, down; a turn to the left is the next one. Corner (r, c) is the top left one
  // of pixel (r, c); the pixels ahead of it on the left and on the right, by direction:
  constexpr std::array<std::array<int, 2>, 4> step{{{0, 1}, {-1, 0}, {0, -1}, {1, 0}}};
  constexpr std::array<std::array<int, 2>, 4> left{{{-1, 0}, {-1, -1}, {0, -1}, {0, 0}}};
  constexpr std::array<std::array<int, 2>, 4> right{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
  int r = start.row, c = start.col + 1;
  std::size_t d = 2;
  std::vector<Point> middles;
  do {
    middles.push_back({c + step[d][1] / 2.0, instances.rows - (r + step[d][0] / 2.0)});
    if (d == 2) walked(r, c - 1) = 1;
    r += step[d][0];
    c += step[d][1];
    if (!inside(r + left[d][0], c + left[d][1]))
      d = (d + 1) % 4;
    else if (inside(r + right[d][0], c + right[d][1]))
      d = (d + 3) % 4;
  } while (r != start.row || c != start.col + 1 || d != 2);
  return middles;
}

double length_round(const std::vector<Point>& polygon) {
  double length = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    length += std::hypot(b.x - a.x, b.y - a.y);
  }
  return length;
}

double area_in(const std::vector<Point>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return twice / 2;
}

using Loops = std::vector<std::vector<Point>>;

/// The lines round every piece and every hole of each grain, the largest piece first [px].
std::vector<Loops> boundaries(const Raster<std::int32_t>& instances, std::size_t grains) {
  std::vector<Loops> loops(grains);
  Raster<std::uint8_t> walked(instances.rows, instances.cols, 0);
  for (int r = 0; r < instances.rows; ++r)
    for (int c = 0; c < instances.cols; ++c) {
      const std::int32_t id = instances(r, c);
      if (id == 0 || walked(r, c) != 0 || (r > 0 && instances(r - 1, c) == id)) continue;
      Loops& own = loops[static_cast<std::size_t>(id - 1)];
      own.push_back(walk_round(instances, {r, c}, walked));
      if (own.size() > 1 && area_in(own.back()) > area_in(own.front())) std::swap(own.front(), own.back());
    }
  return loops;
}

Ellipse ellipse_of(const Moments& m) {
  const double x = m.x / m.n, y = m.y / m.n;
  const double own = 1.0 / 12;  // second moment of a pixel about its own centre
  const double xx = m.xx / m.n - x * x + own, yy = m.yy / m.n - y * y + own, xy = m.xy / m.n - x * y;
  const double mean = (xx + yy) / 2, half = std::hypot((xx - yy) / 2, xy);
  const double aspect = std::sqrt((mean + half) / (mean - half));
  const double area = m.n;
  Ellipse e{x, y, std::sqrt(area * aspect / std::numbers::pi), std::sqrt(area / aspect / std::numbers::pi),
            0};
  if (half > 1e-9 * mean) e.angle = 0.5 * std::atan2(2 * xy, xx - yy);
  if (e.angle < 0) e.angle += std::numbers::pi;
  if (e.angle >= std::numbers::pi) e.angle = 0;  // a tiny negative angle rounds up to pi
  return e;
}

}  // namespace

std::vector<Inclusion> measure_inclusions(const Raster<std::int32_t>& instances, double pixel_size) {
  const std::int32_t grains =
      instances.empty() ? 0 : *std::max_element(instances.data.begin(), instances.data.end());
  std::vector<Moments> moments(static_cast<std::size_t>(grains));
  for (int r = 0; r < instances.rows; ++r)
    for (int c = 0; c < instances.cols; ++c)
      if (const std::int32_t id = instances(r, c); id > 0)
        moments[static_cast<std::size_t>(id - 1)].add(c + 0.5, instances.rows - r - 0.5);
  const std::vector<Loops> loops = boundaries(instances, moments.size());

  const double d = pixel_size;
  const double staircase = std::numbers::pi / (8 * (std::numbers::sqrt2 - 1));
  std::vector<Inclusion> inclusions;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    Inclusion inclusion;
    inclusion.id = static_cast<int>(i) + 1;
    const Ellipse e = ellipse_of(moments[i]);
    inclusion.ellipse = {e.x * d, e.y * d, e.a * d, e.b * d, e.angle};
    inclusion.orientation = e.angle;
    inclusion.contour = contour_of(loops[i]);
    double around = 0;
    for (const std::vector<Point>& loop : loops[i]) around += length_round(loop);
    inclusion.perimeter = around * staircase * d;
    for (Point& p : inclusion.contour) p = {p.x * d, p.y * d};
    inclusion.area = moments[i].n * d * d;
    inclusion.equivalent_diameter = 2 * std::sqrt(inclusion.area / std::numbers::pi);
    inclusions.push_back(std::move(inclusion));
  }
  return inclusions;
}

namespace {

std::string text_of(double value, std::chars_format format, int digits) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, format, digits);
  return {text.data(), end.ptr};
}

}  // namespace

std::string grouped(std::int64_t count) {
  const std::string digits = std::to_string(count);
  std::string text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const std::size_t left = digits.size() - i;
    if (left % 3 == 0 && !text.empty() && text.back() != '-') text += ',';
    text += digits[i];
  }
  return text;
}

std::string counted(std::int64_t count, const std::string& noun) {
  return grouped(count) + " " + noun + (count == 1 ? "" : noun.ends_with('s') ? "es" : "s");
}

std::string share_text(double part, double whole) {
  const double percent = whole > 0 ? 100 * part / whole : 0;
  if (percent == 0) return "0 %";
  if (percent < 0.1) return text_of(percent, std::chars_format::general, 1) + " %";
  return text_of(percent, std::chars_format::fixed, 1) + " %";
}

std::string length_text(double metres) { return short_number(metres * 1e3) + " mm"; }
std::string area_text(double square_metres) {
  return text_of(square_metres * 1e6, std::chars_format::general, 3) + " mm2";
}
std::string short_number(double value) { return text_of(value, std::chars_format::general, 4); }

}  // namespace specimen
