#include "apps/reproduce/crack_place.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace app::reproduce {
namespace {

constexpr double latest = 1.5;  ///< of the strain at the peak

/// @param strain  at which a point failed, of single precision, so that the ends are too.
bool is_late(float strain, double peak_strain) {
  return strain > static_cast<float>(peak_strain) &&
         strain <= static_cast<float>(latest * peak_strain);  // NaN: neither
}

/// Late failures of each row, in the columns between two places [m].
std::vector<int> late_by_row(const specimen::LabelledMask& mask, const mpm::Result& result, double left,
                             double right) {
  std::vector<int> late(static_cast<std::size_t>(mask.labels.rows), 0);
  const double peak_strain = peak_of(result, &mpm::Result::peak_strain);
  for (int row = 0; row < mask.labels.rows; ++row)
    for (int col = 0; col < mask.labels.cols; ++col) {
      const double x = mask.centre(row, col).x;
      late[static_cast<std::size_t>(row)] +=
          x >= left && x <= right && is_late(result.failure_strain(row, col), peak_strain);
    }
  return late;
}

}  // namespace

CrackPlace crack_between(const specimen::LabelledMask& mask, const mpm::Result& result, double left,
                         double right) {
  const std::vector<int> late = late_by_row(mask, result, left, right);
  const int all = std::accumulate(late.begin(), late.end(), 0);
  if (all == 0) return {std::numeric_limits<double>::quiet_NaN(), 0};
  const int rows = mask.labels.rows;
  const int thick = std::max(1, static_cast<int>(std::lround(crack_band / mask.pixel_size)));
  int most = 0;
  CrackPlace place;
  for (int first = 0; first + thick <= rows; ++first) {
    int count = 0;
    double heights = 0;
    for (int row = first; row < first + thick; ++row) {
      count += late[static_cast<std::size_t>(row)];
      heights += late[static_cast<std::size_t>(row)] * mask.centre(row, 0).y;
    }
    if (count <= most) continue;
    most = count;
    place = {heights / count, static_cast<double>(count) / all};
  }
  return place;
}

CrackBeside crack_beside(const specimen::LabelledMask& mask, const mpm::Result& result,
                         const specimen::Ellipse& aggregate) {
  const specimen::Point half = specimen::half_extent(aggregate);
  const double height = crack_between(mask, result, aggregate.x - half.x, aggregate.x + half.x).height;
  const auto is_near = [height](double end) { return std::abs(height - end) <= crack_band; };
  const CrackSide side = is_near(aggregate.y + half.y)   ? CrackSide::top
                         : is_near(aggregate.y - half.y) ? CrackSide::bottom
                                                         : CrackSide::elsewhere;
  return {side, height};
}

}  // namespace app::reproduce
