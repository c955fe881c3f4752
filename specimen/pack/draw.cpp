// Ellipses drawn as pixels; declared in specimen/body/specimen.hpp.
#include <algorithm>
#include <cmath>
#include <string>

#include "specimen/body/ellipse.hpp"
#include "specimen/body/ellipse_gap.hpp"
#include "specimen/body/error.hpp"
#include "specimen/body/measure.hpp"
#include "specimen/body/specimen.hpp"
#include "specimen/pack/canvas.hpp"
#include "specimen/pack/placement.hpp"

namespace specimen {
namespace {

// A millionth of an ellipse: what is lost by writing numbers in decimals is no user's mistake.
constexpr double overlap_tolerance = 1e-6;

std::string name_of(std::size_t i, const Ellipse& e) {
  return "number " + std::to_string(i + 1) + " at (" + number(e.x * 1e3) + ", " + number(e.y * 1e3) + ") mm";
}

void check_alone(std::size_t i, const Ellipse& e, double width, double height) {
  const bool finite =
      std::isfinite(e.x) && std::isfinite(e.y) && std::isfinite(e.angle) && std::isfinite(e.a);
  if (!finite || !(e.b > 0) || !(e.a >= e.b)) {
    throw Error("ellipses",
                name_of(i, e) + " with semi-axes " + millimetres(e.a) + " and " + millimetres(e.b),
                "must be finite with a >= b > 0", "the long semi-axis comes first");
  }
  const Point half = half_extent(e);
  const double beyond = std::max({half.x - e.x, e.x + half.x - width, half.y - e.y, e.y + half.y - height});
  if (beyond > overlap_tolerance * e.a) {
    throw Error("ellipses", name_of(i, e),
                "leaves the specimen of " + number(width * 1e3) + " x " + millimetres(height) + " by " +
                    millimetres(beyond),
                "move it inside");
  }
}

void check_pair(std::size_t i, std::size_t j, const Ellipse& first, const Ellipse& second, const Body& one,
                const Body& two) {
  if (test_gap(one, two, 0).separated) return;
  const double overlap = -exact_gap(one, two);
  if (overlap <= overlap_tolerance * std::min(first.b, second.b)) return;
  throw Error("ellipses", name_of(i, first) + " and " + name_of(j, second),
              "overlap by " + millimetres(overlap), "move them apart");
}

void check(const std::vector<Ellipse>& ellipses, double width, double height) {
  if (ellipses.empty()) return;
  SpatialGrid grid(width, height, std::sqrt(width * height / static_cast<double>(ellipses.size())));
  std::vector<Body> bodies;
  for (std::size_t i = 0; i < ellipses.size(); ++i) {
    check_alone(i, ellipses[i], width, height);
    bodies.push_back(body_of(ellipses[i]));
    const Box box = box_round(bodies[i], 0);
    grid.visit_near(box, [&](int other) {
      const auto j = static_cast<std::size_t>(other);
      check_pair(j, i, ellipses[j], ellipses[i], bodies[j], bodies[i]);
      return true;
    });
    grid.add(box);
  }
}

// An ellipse cuts a row of pixel centres in an interval: with dy from its centre,
//   A dx^2 + 2 B dx dy + C dy^2 <= 1  where  A C - B^2 = 1 / (a b)^2.
class Scanline {
 public:
  Scanline(const Ellipse& e, const LabelledMask& mask) : e_(e), mask_(mask) {
    const Rotation axis = rotation_by(e.angle);
    const double c = axis.cos / e.a, s = axis.sin / e.a, p = axis.cos / e.b, q = axis.sin / e.b;
    xx_ = c * c + q * q;
    xy_ = c * s - p * q;
  }

  // First and last column whose centre is inside; first > last: none.
  std::pair<int, int> columns(int row) const {
    const double dy = mask_.centre(row, 0).y - e_.y, ab = e_.a * e_.b;
    const double middle = e_.x - xy_ * dy / xx_;
    const double half = std::sqrt(std::max(0.0, xx_ - dy * dy / (ab * ab))) / xx_;
    int first = column((middle - half) / mask_.pixel_size - 0.5);
    int last = column((middle + half) / mask_.pixel_size - 0.5);
    // Rounding may be off by a pixel at the ends: there the inside test itself decides.
    first = std::max(0, first - 1);
    last = std::min(mask_.labels.cols - 1, last + 1);
    while (first <= last && !contains(e_, mask_.centre(row, first))) ++first;
    while (first <= last && !contains(e_, mask_.centre(row, last))) --last;
    return {first, last};
  }

 private:
  // May lie outside by one, so that an interval beyond the mask stays empty.
  int column(double at) const {
    return static_cast<int>(std::clamp(std::round(at), -1.0, static_cast<double>(mask_.labels.cols)));
  }
  const Ellipse& e_;
  const LabelledMask& mask_;
  double xx_, xy_;
};

Segmented blank(const Canvas& canvas, double pixel_size) {
  return {{{canvas.rows, canvas.cols, phase::mortar}, pixel_size, standard_phases()},
          {canvas.rows, canvas.cols, 0},
          {}};
}

std::int64_t fill(const Ellipse& e, std::int32_t id, LabelledMask& mask, Raster<std::int32_t>& instances) {
  const int rows = mask.labels.rows;
  const double reach = half_extent(e).y, d = mask.pixel_size;
  const int top = std::max(0, rows - 1 - static_cast<int>(std::floor((e.y + reach) / d + 0.5)));
  const int bottom = std::min(rows - 1, rows - static_cast<int>(std::floor((e.y - reach) / d + 0.5)));
  const Scanline line(e, mask);
  std::int64_t filled = 0;
  for (int row = top; row <= bottom; ++row) {
    const auto [first, last] = line.columns(row);
    for (int col = first; col <= last; ++col) {
      mask.labels(row, col) = phase::aggregate;
      instances(row, col) = id;
    }
    filled += std::max(0, last - first + 1);
  }
  return filled;
}

}  // namespace

Segmented draw_ellipses(const std::vector<Ellipse>& ellipses, double width, double height,
                        double pixel_size) {
  const Canvas canvas = canvas_of(width, height, pixel_size, "generate");
  check(ellipses, width, height);
  Segmented drawn = blank(canvas, pixel_size);
  drawn.inclusions.reserve(ellipses.size());
  for (std::size_t i = 0; i < ellipses.size(); ++i) {
    const int id = static_cast<int>(i) + 1;
    if (fill(ellipses[i], id, drawn.mask, drawn.instances) == 0) {
      throw Error("ellipses", name_of(i, ellipses[i]),
                  "holds no pixel centre: it is smaller than a pixel of " + millimetres(pixel_size),
                  "lower the pixel size or omit such small aggregates");
    }
    drawn.inclusions.push_back(make_inclusion(id, ellipses[i]));
  }
  return drawn;
}

Segmented draw_window(const std::vector<Ellipse>& ellipses, double width, double height, double pixel_size) {
  Segmented drawn = blank(canvas_of(width, height, pixel_size, "generate"), pixel_size);
  std::vector<const Ellipse*> seen;
  for (const Ellipse& e : ellipses)
    if (fill(e, static_cast<int>(seen.size()) + 1, drawn.mask, drawn.instances) > 0) seen.push_back(&e);
  drawn.inclusions = measure_inclusions(drawn.instances, pixel_size);
  for (std::size_t i = 0; i < seen.size(); ++i)
    if (clear_of_walls(*seen[i], {width, height, 0}))
      drawn.inclusions[i] = make_inclusion(static_cast<int>(i) + 1, *seen[i]);
  return drawn;
}

}  // namespace specimen
