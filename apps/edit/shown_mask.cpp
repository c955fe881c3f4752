#include "apps/edit/shown_mask.hpp"

#include <algorithm>

#include "specimen/convert/levels.hpp"
#include "specimen/convert/sketch.hpp"

namespace app {
namespace {

/// Every so many pixels of a mask are shown, so that a page has at most four million.
int every_of(const specimen::Raster<std::uint8_t>& labels) {
  constexpr std::size_t most = 4'000'000;
  int every = 1;
  while (labels.size() / static_cast<std::size_t>(every * every) > most) ++every;
  return every;
}

}  // namespace

ShownMask shown_mask(const specimen::Segmented& segmented, const specimen::Raster<std::uint8_t>& uncertain,
                     const specimen::Crop& crop, int cols, double aspect) {
  const auto& labels = segmented.mask.labels;
  const auto& grains = segmented.instances;
  const int every = every_of(labels);
  ShownMask shown;
  shown.rows = (labels.rows + every - 1) / every;
  shown.cols = (labels.cols + every - 1) / every;
  shown.x = crop.x;
  shown.y = crop.y;
  const double step = static_cast<double>(crop.width > 0 ? crop.width : cols) / labels.cols;
  shown.step_x = step * every;
  shown.step_y = step * every / aspect;
  const auto count = static_cast<std::size_t>(shown.rows) * static_cast<std::size_t>(shown.cols);
  shown.bytes.assign(2 * count, '\0');
  const int fine = uncertain.empty() ? 1 : std::max(1, uncertain.cols / labels.cols);
  for (int r = 0; r < shown.rows; ++r)
    for (int c = 0; c < shown.cols; ++c) {
      const int row = r * every, col = c * every;
      const int below = std::min(labels.rows - 1, row + every);
      const int right = std::min(labels.cols - 1, col + every);
      const auto differs = [&](int other_row, int other_col) {
        return labels(row, col) != labels(other_row, other_col) ||
               grains(row, col) != grains(other_row, other_col);
      };
      const auto at =
          static_cast<std::size_t>(r) * static_cast<std::size_t>(shown.cols) + static_cast<std::size_t>(c);
      const bool ends = differs(row, right) || differs(below, col);
      const bool doubtful =
          !uncertain.empty() && uncertain(row * fine + fine / 2, col * fine + fine / 2) != 0;
      shown.bytes[at] = static_cast<char>(labels(row, col));
      shown.bytes[count + at] =
          static_cast<char>((ends ? boundary_flag : 0) | (doubtful ? uncertain_flag : 0));
    }
  return shown;
}

ShownPicture shown_picture(const specimen::Picture& picture, double most_pixels) {
  const specimen::Sketch sketch = specimen::sketch_of(picture, most_pixels);
  const specimen::Raster<specimen::Rgb> colours = specimen::shown_colours(sketch.picture);
  ShownPicture shown{colours.rows, colours.cols, {}};
  shown.bytes.reserve(3 * colours.size());
  for (const specimen::Rgb& colour : colours.data) {
    shown.bytes += static_cast<char>(colour.r);
    shown.bytes += static_cast<char>(colour.g);
    shown.bytes += static_cast<char>(colour.b);
  }
  return shown;
}

}  // namespace app
