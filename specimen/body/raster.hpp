/// A raster of pixels, and random numbers that are the same on every machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace specimen {

/// Values per pixel, shape (rows, cols), row-major, top row first; (0, 0) is the top left pixel.
template <class T>
struct Raster {
  int rows = 0;         ///< number of pixel rows [-]
  int cols = 0;         ///< number of pixel columns [-]
  std::vector<T> data;  ///< values, rows * cols of them

  Raster() = default;
  Raster(int n_rows, int n_cols, T value = T{})
      : rows(n_rows), cols(n_cols), data(static_cast<std::size_t>(n_rows) * n_cols, value) {}

  [[nodiscard]] std::size_t size() const { return data.size(); }
  [[nodiscard]] bool empty() const { return data.empty(); }
  [[nodiscard]] bool contains(int row, int col) const {
    return row >= 0 && row < rows && col >= 0 && col < cols;
  }
  T& operator()(int row, int col) { return data[static_cast<std::size_t>(row) * cols + col]; }
  const T& operator()(int row, int col) const { return data[static_cast<std::size_t>(row) * cols + col]; }
  friend bool operator==(const Raster&, const Raster&) = default;
};

/// Uniform random numbers from a 64-bit Mersenne twister. The C++ standard defines its raw output but not
/// that of the distributions, so the conversion to double is done here.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// Uniform in [low, high].
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

 private:
  std::mt19937_64 engine_;
};

}  // namespace specimen
