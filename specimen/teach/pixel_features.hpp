/// What a pixel and its surroundings look like, as numbers from which phases can be learnt.
#pragma once

#include <string>
#include <vector>

#include "specimen/body/raster.hpp"
#include "specimen/picture/image_colour.hpp"

namespace specimen {

/// The features of every pixel of a picture, at up to seven scales: the pixel itself, then scales of which
/// each is twice as coarse as the one before (Gaussian windows of standard deviation 1, 2.2, 4.6, 9.2, 18.5
/// and 37 px). The features of a pixel, in the order of feature_names():
/// - lightness L and tints a, b of CIE Lab, averaged over the window;
/// - the two eigenvalues of the Hessian of the lightness (their sum is its Laplacian);
/// - of the first scale: gradient magnitude of the lightness, and of the tints;
/// - of the others, in the calmest of the nine windows round the pixel: L, a, b, the standard deviations of
///   lightness and tint, and the roots of the two eigenvalues of the structure tensor of the colour, i.e. the
///   strength of edges across and along their main direction. So a texture is that of one phase up to the
///   very edge between two; what a window over the edge would tell is like neither.
/// Units: those of Lab, for derivatives per pixel of the scale. Computed once, they are read for any pixels.
/// The same picture gives the same bits on every machine and any number of threads.
/// Sources: the pyramid, Burt, Adelson (1983); the tensor, Di Zenzo (1986); the calmest window, Kuwahara,
/// Hachimura, Eiho, Kinoshita (1976); such features for forests that are taught by strokes, Sommer, Straehle,
/// Koethe, Hamprecht (2011).
class PixelFeatures {
 public:
  static constexpr int at_first = 7, at_others = 12;  ///< features of the first scale and of each other one
  static constexpr int most_scales = 7;

  /// @param scales  2 to most_scales.
  PixelFeatures(Raster<Lab> picture, int scales, int threads);

  [[nodiscard]] int rows() const { return picture_.rows; }
  [[nodiscard]] int cols() const { return picture_.cols; }
  [[nodiscard]] const Raster<Lab>& picture() const { return picture_; }
  [[nodiscard]] int scales() const { return static_cast<int>(coarse_.size()) + 1; }
  /// Features of a pixel.
  [[nodiscard]] int count() const { return count_of(scales()); }
  [[nodiscard]] static constexpr int count_of(int scales) { return at_first + (scales - 1) * at_others; }

  /// Features of the pixels col_begin to col_end - 1 of a row.
  /// @param[out] features  shape (col_end - col_begin, count()).
  void read(int row, int col_begin, int col_end, float* features) const;

 private:
  struct Scale {
    int rows = 0, cols = 0;
    std::vector<float> features;  ///< shape (rows, cols, at_others)
  };
  void read_first(int row, int col_begin, int col_end, float* features) const;

  Raster<Lab> picture_;
  std::vector<Scale> coarse_;
};

/// So many scales that the coarsest window, twice its deviation wide, has about 2.5 % of the shorter side;
/// three at least.
[[nodiscard]] int scales_for(int rows, int cols);

/// "L at scale 1" ..., one for each feature.
[[nodiscard]] std::vector<std::string> feature_names(int scales);

}  // namespace specimen
