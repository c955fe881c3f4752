#include "specimen/describe/descriptors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "specimen/body/mask.hpp"
#include "specimen/body/ring.hpp"

namespace specimen {
namespace {

double rayleigh_probability(double strength, double count) {
  const double z = count * strength * strength;
  const double first = (2 * z - z * z) / (4 * count);
  const double second = (24 * z - 132 * z * z + 76 * z * z * z - 9 * z * z * z * z) / (288 * count * count);
  return std::clamp(std::exp(-z) * (1 + first - second), 0.0, 1.0);
}

}  // namespace

Orientation mean_orientation(const std::vector<WeightedAxis>& axes) {
  double along = 0, across = 0, sum = 0, squares = 0;
  for (const WeightedAxis& axis : axes) {
    along += axis.weight * std::cos(2 * axis.angle);
    across += axis.weight * std::sin(2 * axis.angle);
    sum += axis.weight;
    squares += axis.weight * axis.weight;
  }
  if (!(sum > 0)) return {};
  Orientation result;
  result.strength = std::hypot(along, across) / sum;
  result.direction = std::atan2(across, along) / 2;
  if (result.direction < 0) result.direction += std::numbers::pi;
  if (result.direction >= std::numbers::pi) result.direction = 0;  // a tiny negative angle rounds up to pi
  result.probability = rayleigh_probability(result.strength, sum * sum / squares);
  return result;
}

namespace {

struct OutlinePoint {
  Point at;
  int owner;  // index of the inclusion
};

std::vector<OutlinePoint> outline_points(const Specimen& specimen) {
  constexpr int least_segments = 36;
  std::vector<OutlinePoint> points;
  for (std::size_t i = 0; i < specimen.inclusions.size(); ++i) {
    const Inclusion& inclusion = specimen.inclusions[i];
    const int pixels = static_cast<int>(std::min(1e5, inclusion.perimeter / specimen.mask.pixel_size));
    for (const Ring& ring : make_rings(inclusion, std::max(least_segments, pixels)))
      for (const Point p : ring.vertices) points.push_back({p, static_cast<int>(i)});
  }
  return points;
}

// Points in the cells of a grid.
class PointGrid {
 public:
  PointGrid(const std::vector<OutlinePoint>& points, double width, double height)
      : points_(points),
        cell_(std::sqrt(width * height / static_cast<double>(points.size() + 1))),
        rows_(static_cast<int>(height / cell_) + 1),
        cols_(static_cast<int>(width / cell_) + 1),
        cells_(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(cols_)) {
    for (std::size_t i = 0; i < points.size(); ++i)
      cells_[index(row_of(points[i].at), col_of(points[i].at))].push_back(static_cast<int>(i));
  }

  // Distance to the nearest point of another owner, if it is below `best`; else `best`.
  [[nodiscard]] double nearest_other(const OutlinePoint& from, double best) const {
    const int row = row_of(from.at), col = col_of(from.at);
    const int farthest = std::max(rows_, cols_);
    for (int ring = 0; ring <= farthest && (ring - 1) * cell_ < best; ++ring) {
      for (int r = row - ring; r <= row + ring; ++r) {
        const bool is_end = r == row - ring || r == row + ring;
        for (int c = col - ring; c <= col + ring; c += is_end ? 1 : std::max(1, 2 * ring))
          best = std::min(best, nearest_in(r, c, from));
      }
    }
    return best;
  }

 private:
  [[nodiscard]] double nearest_in(int row, int col, const OutlinePoint& from) const {
    if (row < 0 || row >= rows_ || col < 0 || col >= cols_) return infinite;
    double best = infinite;
    for (const int i : cells_[index(row, col)]) {
      const OutlinePoint& other = points_[static_cast<std::size_t>(i)];
      if (other.owner != from.owner) best = std::min(best, length(other.at - from.at));
    }
    return best;
  }
  [[nodiscard]] int row_of(Point p) const { return std::clamp(static_cast<int>(p.y / cell_), 0, rows_ - 1); }
  [[nodiscard]] int col_of(Point p) const { return std::clamp(static_cast<int>(p.x / cell_), 0, cols_ - 1); }
  [[nodiscard]] std::size_t index(int row, int col) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cols_) + static_cast<std::size_t>(col);
  }

  const std::vector<OutlinePoint>& points_;
  double cell_;
  int rows_, cols_;
  std::vector<std::vector<int>> cells_;
};

// Andrew's monotone chain.
std::vector<Point> convex_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end(),
            [](Point p, Point q) { return p.x < q.x || (p.x == q.x && p.y < q.y); });
  std::vector<Point> hull;
  const auto add = [&hull](Point p, std::size_t least) {
    while (hull.size() >= least && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
      hull.pop_back();
    hull.push_back(p);
  };
  for (const Point p : points) add(p, 2);
  const std::size_t lower = hull.size() + 1;
  for (auto p = points.rbegin() + 1; p < points.rend(); ++p) add(*p, lower);
  return hull;
}

double area_of(const std::vector<Point>& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return twice / 2;
}

}  // namespace

std::vector<double> nearest_gaps(const Specimen& specimen) {
  if (specimen.inclusions.size() < 2) return {};
  const std::vector<OutlinePoint> points = outline_points(specimen);
  const PointGrid grid(points, specimen.mask.width(), specimen.mask.height());
  std::vector<double> gaps(specimen.inclusions.size(), infinite);
  for (const OutlinePoint& point : points) {
    double& gap = gaps[static_cast<std::size_t>(point.owner)];
    gap = grid.nearest_other(point, gap);
  }
  return gaps;
}

double solidity(const Inclusion& inclusion) {
  if (inclusion.contour.empty()) return 1;
  return inclusion.area / area_of(convex_hull(inclusion.contour));
}

namespace {

double mean_aspect(const AggregateSample& sample) {
  double sum = 0, area = 0;
  for (const SampledAggregate& one : sample.aggregates) {
    sum += one.aspect * one.weighted_area();
    area += one.weighted_area();
  }
  return area > 0 ? sum / area : not_known;
}

Orientation orientation_of(const AggregateSample& sample) {
  std::vector<WeightedAxis> axes;
  for (const SampledAggregate& one : sample.aggregates) axes.push_back({one.angle, one.weighted_area()});
  return mean_orientation(axes);
}

double mean(const std::vector<double>& values) {
  if (values.empty()) return not_known;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace

Descriptors describe(const Specimen& specimen) {
  const LabelledMask& mask = specimen.mask;
  const std::vector<double> shares = fractions(mask);
  Descriptors d;
  d.width = mask.width();
  d.height = mask.height();
  d.pixel_size = mask.pixel_size;
  d.fraction = shares[phase::aggregate];
  d.void_fraction = shares[phase::void_];
  d.specific_perimeter = perimeter(mask, phase::aggregate) / (d.width * d.height);
  d.sample = sample_aggregates(specimen);
  d.median_diameter = quantile(distribution_of(sizes_by_area(d.sample)), 0.5);
  d.mean_aspect = mean_aspect(d.sample);
  d.orientation = orientation_of(d.sample);
  d.gaps = nearest_gaps(specimen);
  std::sort(d.gaps.begin(), d.gaps.end());
  d.mean_gap = mean(d.gaps);
  d.merged = static_cast<int>(
      std::count_if(specimen.inclusions.begin(), specimen.inclusions.end(),
                    [](const Inclusion& inclusion) { return solidity(inclusion) < least_solidity; }));
  d.s2 = two_point_correlation(mask, phase::aggregate);
  return d;
}

}  // namespace specimen
