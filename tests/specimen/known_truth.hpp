/// A specimen of which every pixel is known: round stones apart from each other and small pores in a matrix.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "specimen/body/raster.hpp"
#include "specimen/picture/picture.hpp"

namespace specimen_test {

struct Disc {
  double row, col, radius;  ///< [px]
};

struct KnownTruth {
  int rows = 120, cols = 160;
  std::vector<Disc> stones, pores;
  specimen::Raster<std::uint8_t> labels;     ///< 0 void, 1 aggregate, 2 mortar
  specimen::Raster<std::int32_t> instances;  ///< 0, or the number of the stone
};

/// The same on every machine.
inline KnownTruth known_truth() {
  KnownTruth truth;
  specimen::Random random(5);
  const auto is_free = [&](const Disc& d, double gap) {
    for (const auto* list : {&truth.stones, &truth.pores})
      for (const Disc& o : *list) {
        const double dr = d.row - o.row, dc = d.col - o.col, far = d.radius + o.radius + gap;
        if (dr * dr + dc * dc < far * far) return false;
      }
    return true;
  };
  for (int i = 0; i < 4000 && truth.stones.size() < 20; ++i) {
    const double r = random.uniform(5, 14);
    const Disc d{random.uniform(r + 2, truth.rows - r - 2), random.uniform(r + 2, truth.cols - r - 2), r};
    if (is_free(d, 3)) truth.stones.push_back(d);
  }
  for (int i = 0; i < 4000 && truth.pores.size() < 6; ++i) {
    const Disc d{random.uniform(6, truth.rows - 6), random.uniform(6, truth.cols - 6), 2.6};
    if (is_free(d, 2)) truth.pores.push_back(d);
  }
  truth.labels = {truth.rows, truth.cols, 2};
  truth.instances = {truth.rows, truth.cols, 0};
  for (int r = 0; r < truth.rows; ++r)
    for (int c = 0; c < truth.cols; ++c) {
      const auto inside = [&](const Disc& d) {
        const double dr = r + 0.5 - d.row, dc = c + 0.5 - d.col;
        return dr * dr + dc * dc < d.radius * d.radius;
      };
      for (std::size_t k = 0; k < truth.stones.size(); ++k)
        if (inside(truth.stones[k])) {
          truth.labels(r, c) = 1;
          truth.instances(r, c) = static_cast<std::int32_t>(k) + 1;
        }
      for (const Disc& pore : truth.pores)
        if (inside(pore)) truth.labels(r, c) = 0;
    }
  return truth;
}

/// The truth in other numbers, by label.
template <std::size_t n>
specimen::Raster<double> coded(const specimen::Raster<std::uint8_t>& labels,
                               const std::array<double, n>& codes) {
  specimen::Raster<double> gray(labels.rows, labels.cols);
  for (std::size_t i = 0; i < gray.size(); ++i) gray.data[i] = codes[labels.data[i]];
  return gray;
}

/// The same truth drawn with edges of partly covered pixels: each pixel is the mean of 4 x 4 points.
inline specimen::Raster<double> drawn_softly(const KnownTruth& truth, std::array<double, 3> codes) {
  constexpr int fine = 4;
  specimen::Raster<double> gray(truth.rows, truth.cols, 0.0);
  for (int r = 0; r < truth.rows; ++r)
    for (int c = 0; c < truth.cols; ++c) {
      double sum = 0;
      for (int i = 0; i < fine * fine; ++i) {
        const double row = r + (i / fine + 0.5) / fine, col = c + (i % fine + 0.5) / fine;
        const auto inside = [&](const Disc& d) {
          return (row - d.row) * (row - d.row) + (col - d.col) * (col - d.col) < d.radius * d.radius;
        };
        std::size_t label = 2;
        for (const Disc& d : truth.stones)
          if (inside(d)) label = 1;
        for (const Disc& d : truth.pores)
          if (inside(d)) label = 0;
        sum += codes[label];
      }
      gray(r, c) = static_cast<int>(sum / (fine * fine) + 0.5);
    }
  return gray;
}

/// Share of the pixels that differ [-].
inline double share_wrong(const specimen::Raster<std::uint8_t>& found,
                          const specimen::Raster<std::uint8_t>& truth) {
  if (found.rows != truth.rows || found.cols != truth.cols) return 1;
  double wrong = 0;
  for (std::size_t i = 0; i < found.size(); ++i) wrong += found.data[i] != truth.data[i];
  return wrong / static_cast<double>(found.size());
}

inline specimen::Picture picture_of(specimen::Raster<double> gray) {
  specimen::Picture picture;
  picture.gray = std::move(gray);
  return picture;
}

}  // namespace specimen_test
