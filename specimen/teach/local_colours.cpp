#include "specimen/teach/local_colours.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <vector>

#include "specimen/teach/parallel.hpp"

namespace specimen {
namespace {

using Index = std::ptrdiff_t;

constexpr int reach = 3;            ///< cells on each side of one that its statistics are taken over
constexpr float most_strange = 20;  ///< lead in log likelihood beyond which a colour tells no more
constexpr int band_rows = 64;       ///< that are one piece of work

/// exp(x) for x <= 0: the same bits on every machine, and fast. Relative error below 1e-6.
inline float exp_of(float x) {
  const float t = std::max(x, -80.0F) * 1.44269504F;
  const auto whole = static_cast<std::int32_t>(t) - 1;
  const float f = (t - static_cast<float>(whole)) * 0.693147181F;  // from 0 to ln 2 and a little more
  const float p =
      1 + f * (1 + f * (0.5F +
                        f * (1.0F / 6 + f * (1.0F / 24 + f * (1.0F / 120 + f * (1.0F / 720 + f / 5040))))));
  return p * std::bit_cast<float>((whole + 127) << 23);
}

/// Sums over pixels, each with the weight of its class: weight, then value and square of L, a and b.
using Moments = std::array<float, 7>;

/// A normal distribution of colours, its channels apart: mean, half the inverse of the variance, and half the
/// sum of the logarithms of the variances.
struct Normal {
  std::array<float, 3> mean{}, half_inverse{};
  float offset = 0;
};
constexpr Index normal_floats = 7;
static_assert(sizeof(Normal) == normal_floats * sizeof(float));

/// Statistics of the classes on a grid of square cells.
class Surroundings {
 public:
  Surroundings(const ClassShares& shares, const Raster<Lab>& picture, const LocalColoursOptions& options,
               int threads)
      : edge_(std::max(1, options.window / reach)),
        rows_((shares.rows + edge_ - 1) / edge_),
        cols_((shares.cols + edge_ - 1) / edge_),
        classes_(shares.classes) {
    std::vector<Moments> sums(static_cast<std::size_t>(Index{rows_} * cols_ * classes_));
    share_out(rows_, threads, [&](int row) { add_up(shares, picture, row, sums); });
    const std::vector<Moments> all = of_all(sums);
    std::vector<Moments> across(sums.size());
    share_out(rows_, threads, [&](int row) {
      for (int col = 0; col < cols_; ++col) gather(sums, across, row, col, 0, 1);
    });
    normals_.resize(sums.size());
    share_out(rows_, threads, [&](int row) {
      std::vector<Moments> near(static_cast<std::size_t>(cols_ * classes_));
      for (int col = 0; col < cols_; ++col) gather(across, near, row, col, row, cols_);
      for (int i = 0; i < cols_ * classes_; ++i)
        normals_[static_cast<std::size_t>(Index{row} * cols_ * classes_ + i)] = normal_of(
            near[static_cast<std::size_t>(i)], all[static_cast<std::size_t>(i % classes_)], options);
    });
  }

  /// The distributions of a row of pixels, between those of the cells above and below.
  /// @param[out] row_of_cells  shape (cells in a row, classes).
  void read_row(int row, std::vector<Normal>& row_of_cells) const {
    const float at = std::max(0.0F, (static_cast<float>(row) + 0.5F) / static_cast<float>(edge_) - 0.5F);
    const int top = std::min(static_cast<int>(at), rows_ - 1), low = std::min(top + 1, rows_ - 1);
    const float down = at - static_cast<float>(top);
    const Index length = Index{cols_} * classes_;
    row_of_cells.resize(static_cast<std::size_t>(length));
    const float* a = &normals_[static_cast<std::size_t>(top * length)].mean[0];
    const float* b = &normals_[static_cast<std::size_t>(low * length)].mean[0];
    float* out = &row_of_cells.front().mean[0];
    for (Index i = 0; i < length * normal_floats; ++i) out[i] = a[i] + down * (b[i] - a[i]);
  }

  /// How much a colour speaks against each class.
  void weigh(const std::vector<Normal>& row_of_cells, int col, const std::array<float, 3>& lab,
             float* against) const {
    const float at = std::max(0.0F, (static_cast<float>(col) + 0.5F) / static_cast<float>(edge_) - 0.5F);
    const int left = std::min(static_cast<int>(at), cols_ - 1), right = std::min(left + 1, cols_ - 1);
    const float part = at - static_cast<float>(left);
    const Normal* a = row_of_cells.data() + Index{left} * classes_;
    const Normal* b = row_of_cells.data() + Index{right} * classes_;
    for (Index k = 0; k < classes_; ++k) {
      float sum = a[k].offset + part * (b[k].offset - a[k].offset);
      for (std::size_t j = 0; j < 3; ++j) {
        const float away = lab[j] - (a[k].mean[j] + part * (b[k].mean[j] - a[k].mean[j]));
        sum += away * away * (a[k].half_inverse[j] + part * (b[k].half_inverse[j] - a[k].half_inverse[j]));
      }
      against[k] = sum;
    }
  }

 private:
  [[nodiscard]] std::size_t place(int row, int col) const {
    return static_cast<std::size_t>((Index{row} * cols_ + col) * classes_);
  }

  /// The moments of a row of cells. Only a class that is more likely than all others together counts.
  void add_up(const ClassShares& shares, const Raster<Lab>& picture, int row,
              std::vector<Moments>& sums) const {
    for (int r = row * edge_; r < std::min(shares.rows, (row + 1) * edge_); ++r)
      for (int c = 0; c < shares.cols; ++c) {
        const std::uint8_t* share = shares.at(r, c);
        const auto likeliest = std::max_element(share, share + classes_) - share;
        if (share[likeliest] < 128) continue;
        const float weight = static_cast<float>(share[likeliest]) / 127.5F - 1;
        const Lab lab = picture(r, c);
        Moments& sum = sums[place(row, c / edge_) + static_cast<std::size_t>(likeliest)];
        const std::array<float, 3> values{static_cast<float>(lab.l()), static_cast<float>(lab.a()),
                                          static_cast<float>(lab.b())};
        sum[0] += weight;
        for (std::size_t j = 0; j < 3; ++j) {
          sum[1 + j] += weight * values[j];
          sum[4 + j] += weight * values[j] * values[j];
        }
      }
  }

  /// Means over the whole picture, a pixel each.
  [[nodiscard]] std::vector<Moments> of_all(const std::vector<Moments>& sums) const {
    std::vector<std::array<double, 7>> total(static_cast<std::size_t>(classes_));
    for (std::size_t i = 0; i < sums.size(); ++i)
      for (std::size_t j = 0; j < 7; ++j)
        total[i % static_cast<std::size_t>(classes_)][j] += static_cast<double>(sums[i][j]);
    std::vector<Moments> means(total.size());
    for (std::size_t k = 0; k < total.size(); ++k)
      for (std::size_t j = 0; j < 7; ++j)
        means[k][j] = static_cast<float>(total[k][j] / std::max(1.0, total[k][0]));
    return means;
  }

  /// Sums over the cells of a row, or of a column, that are within reach of one.
  void gather(const std::vector<Moments>& from, std::vector<Moments>& to, int row, int col, int first_row,
              int step) const {
    const int here = step == 1 ? col : row, count = step == 1 ? cols_ : rows_;
    for (Index k = 0; k < classes_; ++k) {
      Moments sum{};
      for (int i = std::max(0, here - reach); i <= std::min(count - 1, here + reach); ++i) {
        const Moments& one = from[(step == 1 ? place(row, i) : place(i, col)) + static_cast<std::size_t>(k)];
        for (std::size_t j = 0; j < 7; ++j) sum[j] += one[j];
      }
      to[place(row - first_row, col) + static_cast<std::size_t>(k)] = sum;
    }
  }

  /// The distribution of what is near and, for a little part, of the whole picture.
  [[nodiscard]] Normal normal_of(const Moments& near, const Moments& all,
                                 const LocalColoursOptions& o) const {
    const float pixels =
        static_cast<float>((2 * reach + 1) * edge_) * static_cast<float>((2 * reach + 1) * edge_);
    const float own = o.common * pixels, total = near[0] + own;
    Normal normal;
    for (std::size_t j = 0; j < 3; ++j) {
      const float mean = (near[1 + j] + own * all[1 + j]) / total;
      const float square = (near[4 + j] + own * all[4 + j]) / total;
      const float variance = std::max(0.0F, square - mean * mean) + o.noise * o.noise;
      normal.mean[j] = mean;
      normal.half_inverse[j] = 0.5F / variance;
      normal.offset += 0.5F * static_cast<float>(std::log(static_cast<double>(variance)));
    }
    return normal;
  }

  int edge_, rows_, cols_, classes_;
  std::vector<Normal> normals_;  ///< shape (rows, cols, classes)
};

/// A number for each pixel of a band, with a rim of zeros.
class Field {
 public:
  Field(int rows, int cols)
      : width_(cols + 2), data_(static_cast<std::size_t>((rows + 2) * (Index{cols} + 2))) {}
  /// Of a row from -1 to rows; at [0] is the first pixel, at [-1] the rim.
  [[nodiscard]] float* row(int r) { return data_.data() + (r + 1) * width_ + 1; }
  [[nodiscard]] const float* row(int r) const { return data_.data() + (r + 1) * width_ + 1; }

 private:
  Index width_;
  std::vector<float> data_;
};

/// The rows of a picture that are worked on at a time, and as many beyond as reach into them.
class BandOfShares {
 public:
  BandOfShares(const ClassShares& shares, const Raster<Lab>& picture, const Surroundings& surroundings,
               const LocalColoursOptions& options, int begin, int end)
      : options_(options),
        first_(std::max(0, begin - options.steps)),
        rows_(std::min(shares.rows, end + options.steps) - first_),
        cols_(shares.cols),
        bonds_(4, Field(rows_, cols_)),
        alone_(static_cast<std::size_t>(shares.classes), Field(rows_, cols_)),
        now_(alone_),
        next_(alone_) {
    bind(picture);
    weigh(shares, picture, surroundings);
    for (int r = 0; r < rows_; ++r) normalise(alone_, r, now_);
  }

  void exchange() {
    for (int r = 0; r < rows_; ++r) {
      for (std::size_t k = 0; k < now_.size(); ++k) hear_neighbours(k, r);
      normalise(next_, r, next_);
    }
    std::swap(now_, next_);
  }

  void write(int begin, int end, ClassShares& result) const {
    for (int r = begin; r < end; ++r)
      for (std::size_t k = 0; k < now_.size(); ++k) {
        const float* row = now_[k].row(r - first_);
        std::uint8_t* out = result.at(r, 0) + k;
        for (int c = 0; c < cols_; ++c, out += now_.size())
          *out = static_cast<std::uint8_t>(row[c] * 255 + 0.5F);
      }
  }

 private:
  /// Bonds to the neighbours on the right, below, below on the right and below on the left.
  void bind(const Raster<Lab>& picture) {
    const float scale = 1 / (2 * options_.contrast * options_.contrast);
    constexpr std::array<std::pair<int, int>, 4> steps{{{0, 1}, {1, 0}, {1, 1}, {1, -1}}};
    for (std::size_t d = 0; d < steps.size(); ++d) {
      const auto [down, right] = steps[d];
      const float bond = options_.bond * (d < 2 ? 1 : 0.707107F);
      for (int r = 0; r + down < rows_; ++r) {
        float* out = bonds_[d].row(r);
        const Lab *a = &picture(first_ + r, 0), *b = &picture(first_ + r + down, 0);
        for (int c = std::max(0, -right); c < std::min(cols_, cols_ - right); ++c) {
          const auto l = static_cast<float>(a[c].l() - b[c + right].l());
          const auto s = static_cast<float>(a[c].a() - b[c + right].a());
          const auto t = static_cast<float>(a[c].b() - b[c + right].b());
          out[c] = bond * exp_of(-scale * (l * l + s * s + t * t));
        }
      }
    }
  }

  /// What each pixel is by itself: logarithms of its share and of the likelihood of its colour.
  void weigh(const ClassShares& shares, const Raster<Lab>& picture, const Surroundings& surroundings) {
    std::array<float, 256> log_of{};
    for (std::size_t i = 0; i < log_of.size(); ++i)
      log_of[i] = static_cast<float>(std::log(std::max(1.0, static_cast<double>(i)) / 255));
    const std::size_t classes = alone_.size();
    std::vector<Normal> cells;
    std::vector<float> against(classes);
    for (int r = 0; r < rows_; ++r) {
      surroundings.read_row(first_ + r, cells);
      for (int c = 0; c < cols_; ++c) {
        const Lab lab = picture(first_ + r, c);
        surroundings.weigh(
            cells, c, {static_cast<float>(lab.l()), static_cast<float>(lab.a()), static_cast<float>(lab.b())},
            against.data());
        const float least = *std::min_element(against.begin(), against.end());
        const std::uint8_t* share = shares.at(first_ + r, c);
        for (std::size_t k = 0; k < classes; ++k)
          alone_[k].row(r)[c] =
              log_of[share[k]] - options_.trust * std::min(most_strange, against[k] - least);
      }
    }
  }

  void hear_neighbours(std::size_t k, int r) {
    const float *here = now_[k].row(r), *above = now_[k].row(r - 1), *below = now_[k].row(r + 1);
    const float *right = bonds_[0].row(r), *down = bonds_[1].row(r), *up = bonds_[1].row(r - 1);
    const float *low_right = bonds_[2].row(r), *high_left = bonds_[2].row(r - 1);
    const float *low_left = bonds_[3].row(r), *high_right = bonds_[3].row(r - 1);
    const float* alone = alone_[k].row(r);
    float* out = next_[k].row(r);
    for (int c = 0; c < cols_; ++c)
      out[c] = alone[c] + right[c] * here[c + 1] + right[c - 1] * here[c - 1] + down[c] * below[c] +
               up[c] * above[c] + low_right[c] * below[c + 1] + high_left[c - 1] * above[c - 1] +
               low_left[c] * below[c - 1] + high_right[c + 1] * above[c + 1];
  }

  /// Shares of the classes from their logarithms, up to a constant.
  void normalise(const std::vector<Field>& logs, int r, std::vector<Field>& to) {
    std::vector<float> top(logs.front().row(r), logs.front().row(r) + cols_);
    for (std::size_t k = 1; k < logs.size(); ++k) {
      const float* one = logs[k].row(r);
      for (int c = 0; c < cols_; ++c)
        top[static_cast<std::size_t>(c)] = std::max(top[static_cast<std::size_t>(c)], one[c]);
    }
    std::vector<float> sum(static_cast<std::size_t>(cols_), 0);
    for (std::size_t k = 0; k < logs.size(); ++k) {
      const float* one = logs[k].row(r);
      float* out = to[k].row(r);
      for (int c = 0; c < cols_; ++c) {
        out[c] = exp_of(one[c] - top[static_cast<std::size_t>(c)]);
        sum[static_cast<std::size_t>(c)] += out[c];
      }
    }
    for (Field& field : to) {
      float* out = field.row(r);
      for (int c = 0; c < cols_; ++c) out[c] /= sum[static_cast<std::size_t>(c)];
    }
  }

  const LocalColoursOptions& options_;
  int first_, rows_, cols_;
  std::vector<Field> bonds_;
  std::vector<Field> alone_, now_, next_;  ///< one for each class
};

}  // namespace

ClassShares sharpened_by_colours(const ClassShares& shares, const Raster<Lab>& picture,
                                 const LocalColoursOptions& options, int threads) {
  assert(options.window >= reach && picture.rows == shares.rows && picture.cols == shares.cols);
  const Surroundings surroundings(shares, picture, options, threads);
  ClassShares result(shares.rows, shares.cols, shares.classes);
  share_out((shares.rows + band_rows - 1) / band_rows, threads, [&](int part) {
    const int begin = part * band_rows, end = std::min(shares.rows, begin + band_rows);
    BandOfShares band(shares, picture, surroundings, options, begin, end);
    for (int step = 0; step < options.steps; ++step) band.exchange();
    band.write(begin, end, result);
  });
  return result;
}

}  // namespace specimen
