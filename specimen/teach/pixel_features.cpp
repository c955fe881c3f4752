#include "specimen/teach/pixel_features.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "specimen/teach/parallel.hpp"

namespace specimen {
namespace {

/// What is averaged from scale to scale.
enum Channel { channel_l, channel_a, channel_b, channel_ll, channel_tt, channel_xx, channel_xy, channel_yy };
constexpr int channels = 8;

/// The channels of a scale, shape (rows, cols, channels).
struct Layers {
  int rows = 0, cols = 0;
  std::vector<float> data;
  Layers(int n_rows, int n_cols)
      : rows(n_rows), cols(n_cols), data(static_cast<std::size_t>(n_rows) * n_cols * channels) {}
  [[nodiscard]] const float* at(int row, int col) const {
    return data.data() + (static_cast<std::size_t>(row) * cols + col) * channels;
  }
  float* row(int r) { return data.data() + static_cast<std::size_t>(r) * cols * channels; }
};

/// Place beyond a border, mirrored at the outermost pixel.
int within(int at, int count) {
  if (at < 0) at = -at;
  if (at >= count) at = 2 * (count - 1) - at;
  return std::clamp(at, 0, count - 1);
}

/// Of a field v round a pixel: first and second differences over 3 x 3 pixels. Source: the first ones are
/// Sobel's.
struct Slopes {
  float x, y, xx, xy, yy;
};

/// @param v  nine values, row by row.
Slopes slopes_of(const std::array<float, 9>& v) {
  const float left = v[0] + 2 * v[3] + v[6], middle = v[1] + 2 * v[4] + v[7], right = v[2] + 2 * v[5] + v[8];
  const float top = v[0] + 2 * v[1] + v[2], waist = v[3] + 2 * v[4] + v[5], low = v[6] + 2 * v[7] + v[8];
  return {(right - left) / 8, (low - top) / 8, (left - 2 * middle + right) / 4,
          (v[0] - v[2] - v[6] + v[8]) / 4, (top - 2 * waist + low) / 4};
}

/// The larger and the smaller eigenvalue of a symmetric matrix.
struct Eigen2 {
  float large, small;
};

Eigen2 eigenvalues(float xx, float xy, float yy) {
  const float mean = (xx + yy) / 2, half = (xx - yy) / 2;
  const float radius = std::sqrt(half * half + xy * xy);
  return {mean + radius, mean - radius};
}

float root(float value) { return std::sqrt(std::max(0.0F, value)); }

/// L, a and b of the pixels col_begin - 1 to col_end of a row, mirrored at the borders.
void read_lab(const Raster<Lab>& picture, int row, int col_begin, int col_end, float* values) {
  const int r = within(row, picture.rows);
  for (int c = col_begin - 1; c <= col_end; ++c) {
    const Lab lab = picture(r, within(c, picture.cols));
    *values++ = static_cast<float>(lab.l());
    *values++ = static_cast<float>(lab.a());
    *values++ = static_cast<float>(lab.b());
  }
}

/// Three rows of Lab round one; the middle one begins a pixel before the first.
struct ThreeRows {
  std::array<std::vector<float>, 3> rows;
  ThreeRows(const Raster<Lab>& picture, int row, int col_begin, int col_end) {
    for (int i = 0; i < 3; ++i) {
      rows[static_cast<std::size_t>(i)].resize(static_cast<std::size_t>(col_end - col_begin + 2) * 3);
      read_lab(picture, row + i - 1, col_begin, col_end, rows[static_cast<std::size_t>(i)].data());
    }
  }
  /// Nine values of L, a or b round the pixel `col` of the part.
  [[nodiscard]] std::array<float, 9> round(int col, int which) const {
    std::array<float, 9> v{};
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c)
        v[3 * r + c] = rows[r][(static_cast<std::size_t>(col) + c) * 3 + static_cast<std::size_t>(which)];
    return v;
  }
};

/// The channels of a row of the picture itself.
void first_channels(const Raster<Lab>& picture, int row, float* out) {
  const ThreeRows three(picture, row, 0, picture.cols);
  for (int c = 0; c < picture.cols; ++c, out += channels) {
    const auto l = three.round(c, 0), a = three.round(c, 1), b = three.round(c, 2);
    const Slopes sl = slopes_of(l), sa = slopes_of(a), sb = slopes_of(b);
    out[channel_l] = l[4];
    out[channel_a] = a[4];
    out[channel_b] = b[4];
    out[channel_ll] = l[4] * l[4];
    out[channel_tt] = a[4] * a[4] + b[4] * b[4];
    out[channel_xx] = sl.x * sl.x + sa.x * sa.x + sb.x * sb.x;
    out[channel_xy] = sl.x * sl.y + sa.x * sa.y + sb.x * sb.y;
    out[channel_yy] = sl.y * sl.y + sa.y * sa.y + sb.y * sb.y;
  }
}

constexpr std::array<float, 5> binomial{1.0F / 16, 4.0F / 16, 6.0F / 16, 4.0F / 16, 1.0F / 16};

/// Every second pixel of a row, averaged by the binomial weights.
void halve_row(const float* in, int cols, float* out) {
  const int half = (cols + 1) / 2;
  for (int c = 0; c < half; ++c, out += channels) {
    std::fill(out, out + channels, 0.0F);
    for (int k = 0; k < 5; ++k) {
      const float* from = in + static_cast<std::ptrdiff_t>(within(2 * c + k - 2, cols)) * channels;
      const float weight = binomial[static_cast<std::size_t>(k)];
      for (int i = 0; i < channels; ++i) out[i] += weight * from[i];
    }
  }
}

constexpr int band = 16;  ///< rows of a coarser scale that are one piece of work

/// The next coarser scale.   @param read  writes a row of this one.
template <class Read>
Layers halved(int rows, int cols, int threads, const Read& read) {
  Layers half((rows + 1) / 2, (cols + 1) / 2);
  const std::size_t width = static_cast<std::size_t>(half.cols) * channels;
  share_out((half.rows + band - 1) / band, threads, [&](int part) {
    const int begin = part * band, end = std::min(half.rows, begin + band);
    std::vector<float> row(static_cast<std::size_t>(cols) * channels);
    std::vector<float> narrow(static_cast<std::size_t>(2 * (end - begin) + 3) * width);
    for (int i = 0; i < 2 * (end - begin) + 3; ++i) {
      read(within(2 * begin + i - 2, rows), row.data());
      halve_row(row.data(), cols, narrow.data() + static_cast<std::size_t>(i) * width);
    }
    for (int r = begin; r < end; ++r) {
      float* out = half.row(r);
      std::fill(out, out + width, 0.0F);
      for (int k = 0; k < 5; ++k) {
        const float* from = narrow.data() + static_cast<std::size_t>(2 * (r - begin) + k) * width;
        const float weight = binomial[static_cast<std::size_t>(k)];
        for (std::size_t i = 0; i < width; ++i) out[i] += weight * from[i];
      }
    }
  });
  return half;
}

/// The two eigenvalues of the Hessian.
void write_curvature(const Slopes& l, float* out) {
  const Eigen2 bent = eigenvalues(l.xx, l.xy, l.yy);
  out[0] = bent.large;
  out[1] = bent.small;
}

/// Of lightness and tint inside the window of a pixel.
float variance(const float* at) {
  return at[channel_ll] - at[channel_l] * at[channel_l] + at[channel_tt] - at[channel_a] * at[channel_a] -
         at[channel_b] * at[channel_b];
}

/// The calmest of the nine windows round a pixel.
const float* calmest(const Layers& layers, int row, int col) {
  const float* calm = layers.at(row, col);
  float least = variance(calm);
  for (int r = row - 1; r <= row + 1; ++r)
    for (int c = col - 1; c <= col + 1; ++c) {
      const float* there = layers.at(within(r, layers.rows), within(c, layers.cols));
      const float spread = variance(there);
      if (spread < least) least = spread, calm = there;
    }
  return calm;
}

void write_coarse(const Layers& layers, int row, int col, float* out) {
  std::array<float, 9> round{};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c)
      round[static_cast<std::size_t>(3 * r + c)] =
          layers.at(within(row + r - 1, layers.rows), within(col + c - 1, layers.cols))[channel_l];
  const float *at = layers.at(row, col), *calm = calmest(layers, row, col);
  out[0] = at[channel_l];
  out[1] = at[channel_a];
  out[2] = at[channel_b];
  write_curvature(slopes_of(round), out + 3);
  out[5] = calm[channel_l];
  out[6] = calm[channel_a];
  out[7] = calm[channel_b];
  out[8] = root(calm[channel_ll] - calm[channel_l] * calm[channel_l]);
  out[9] = root(calm[channel_tt] - calm[channel_a] * calm[channel_a] - calm[channel_b] * calm[channel_b]);
  const Eigen2 edges = eigenvalues(calm[channel_xx], calm[channel_xy], calm[channel_yy]);
  out[10] = root(edges.large);
  out[11] = root(edges.small);
}

}  // namespace

PixelFeatures::PixelFeatures(Raster<Lab> picture, int scales, int threads)
    : picture_(std::move(picture)), coarse_(static_cast<std::size_t>(scales - 1)) {
  assert(scales >= 2 && scales <= most_scales);
  Layers layers =
      halved(rows(), cols(), threads, [&](int row, float* out) { first_channels(picture_, row, out); });
  for (Scale& scale : coarse_) {
    scale.rows = layers.rows;
    scale.cols = layers.cols;
    scale.features.resize(static_cast<std::size_t>(layers.rows) * layers.cols * at_others);
    share_out(layers.rows, threads, [&](int row) {
      float* out = scale.features.data() + static_cast<std::size_t>(row) * scale.cols * at_others;
      for (int col = 0; col < scale.cols; ++col, out += at_others) write_coarse(layers, row, col, out);
    });
    if (&scale != &coarse_.back())
      layers = halved(layers.rows, layers.cols, threads, [&](int row, float* out) {
        std::copy_n(layers.at(row, 0), static_cast<std::size_t>(layers.cols) * channels, out);
      });
  }
}

void PixelFeatures::read_first(int row, int col_begin, int col_end, float* features) const {
  const ThreeRows three(picture_, row, col_begin, col_end);
  for (int c = 0; c < col_end - col_begin; ++c, features += count()) {
    const auto l = three.round(c, 0), a = three.round(c, 1), b = three.round(c, 2);
    features[0] = l[4];
    features[1] = a[4];
    features[2] = b[4];
    const Slopes sl = slopes_of(l), sa = slopes_of(a), sb = slopes_of(b);
    features[3] = std::sqrt(sl.x * sl.x + sl.y * sl.y);
    features[4] = std::sqrt(sa.x * sa.x + sa.y * sa.y + sb.x * sb.x + sb.y * sb.y);
    write_curvature(sl, features + 5);
  }
}

void PixelFeatures::read(int row, int col_begin, int col_end, float* features) const {
  read_first(row, col_begin, col_end, features);
  std::vector<float> mixed;
  for (std::size_t k = 0; k < coarse_.size(); ++k) {
    const Scale& scale = coarse_[k];
    const int step = 2 << k;
    const auto weight = [step](int at) { return static_cast<float>(at % step) / static_cast<float>(step); };
    const int top = std::min(row / step, scale.rows - 1), low = std::min(top + 1, scale.rows - 1);
    const int first = std::min(col_begin / step, scale.cols - 1);
    const int last = std::min((col_end - 1) / step + 1, scale.cols - 1);
    const std::size_t length = static_cast<std::size_t>(last - first + 1) * at_others;
    const auto at = [&](int r) {
      return scale.features.data() + (static_cast<std::size_t>(r) * scale.cols + first) * at_others;
    };
    mixed.resize(length);
    const float *above = at(top), *below = at(low), down = weight(row);
    for (std::size_t i = 0; i < length; ++i) mixed[i] = above[i] + down * (below[i] - above[i]);
    float* out = features + at_first + k * at_others;
    for (int c = col_begin; c < col_end; ++c, out += count()) {
      const int left = std::min(c / step, scale.cols - 1);
      const float* a = mixed.data() + static_cast<std::ptrdiff_t>(left - first) * at_others;
      const float* b =
          mixed.data() + static_cast<std::ptrdiff_t>(std::min(left + 1, last) - first) * at_others;
      const float right = weight(c);
      for (int i = 0; i < at_others; ++i) out[i] = a[i] + right * (b[i] - a[i]);
    }
  }
}

int scales_for(int rows, int cols) {
  constexpr double share = 0.0125;  // of the shorter side, that a standard deviation may have
  int scales = 3;
  for (double square = 5; scales < PixelFeatures::most_scales; ++scales) {
    square = 4 * square + 1;
    if (std::sqrt(square) > share * std::min(rows, cols)) break;
  }
  return scales;
}

std::vector<std::string> feature_names(int scales) {
  const std::vector<std::string> first{"L",
                                       "a",
                                       "b",
                                       "gradient of L",
                                       "gradient of tint",
                                       "curvature of L, larger",
                                       "curvature of L, smaller"};
  const std::vector<std::string> others{"L",
                                        "a",
                                        "b",
                                        "curvature of L, larger",
                                        "curvature of L, smaller",
                                        "L of the calmest",
                                        "a of the calmest",
                                        "b of the calmest",
                                        "deviation of L",
                                        "deviation of tint",
                                        "edges across",
                                        "edges along"};
  std::vector<std::string> names;
  for (int k = 0; k < scales; ++k)
    for (const std::string& name : k == 0 ? first : others)
      names.push_back(name + " at scale " + std::to_string(1 << k));
  return names;
}

}  // namespace specimen
