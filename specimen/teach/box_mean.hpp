/// Means over square windows.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace specimen {

/// A field over the rows of a band and of its margins.
using Plane = std::vector<float>;

/// Rows first to last - 1 of a picture.
struct Band {
  int first = 0, last = 0, cols = 0;
  [[nodiscard]] int rows() const { return last - first; }
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(rows()) * static_cast<std::size_t>(cols);
  }
};

/// Means over square windows of 2 radius + 1 pixels, cut off at the borders of the band.
class BoxMean {
 public:
  BoxMean(const Band& band, int radius) : band_(band), radius_(radius), across_(band.size()) {}

  void apply(Plane& plane) {
    const auto cols = static_cast<std::size_t>(band_.cols);
    for (int r = 0; r < band_.rows(); ++r)
      sum_row(plane.data() + static_cast<std::size_t>(r) * cols,
              across_.data() + static_cast<std::size_t>(r) * cols);
    std::vector<double> sum(cols, 0);
    const auto add = [&](int row, double sign) {
      const float* from = across_.data() + static_cast<std::size_t>(row) * cols;
      for (std::size_t c = 0; c < cols; ++c) sum[c] += sign * static_cast<double>(from[c]);
    };
    for (int r = 0; r < std::min(radius_, band_.rows()); ++r) add(r, 1);
    for (int r = 0; r < band_.rows(); ++r) {
      if (r + radius_ < band_.rows()) add(r + radius_, 1);
      if (r - radius_ - 1 >= 0) add(r - radius_ - 1, -1);
      const int count = std::min(r + radius_, band_.rows() - 1) - std::max(r - radius_, 0) + 1;
      float* to = plane.data() + static_cast<std::size_t>(r) * cols;
      for (std::size_t c = 0; c < cols; ++c) to[c] = static_cast<float>(sum[c] / count);
    }
  }

 private:
  void sum_row(const float* from, float* to) const {
    double sum = 0;
    for (int c = 0; c < std::min(radius_, band_.cols); ++c) sum += static_cast<double>(from[c]);
    for (int c = 0; c < band_.cols; ++c) {
      if (c + radius_ < band_.cols) sum += static_cast<double>(from[c + radius_]);
      if (c - radius_ - 1 >= 0) sum -= static_cast<double>(from[c - radius_ - 1]);
      const int count = std::min(c + radius_, band_.cols - 1) - std::max(c - radius_, 0) + 1;
      to[c] = static_cast<float>(sum / count);
    }
  }

  Band band_;
  int radius_;
  Plane across_;
};

}  // namespace specimen
