#include "specimen/convert/segment_taught.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "specimen/body/error.hpp"
#include "specimen/body/measure.hpp"
#include "specimen/convert/levels.hpp"
#include "specimen/convert/smoothing.hpp"
#include "specimen/teach/edge_smoothing.hpp"
#include "specimen/teach/even_light.hpp"
#include "specimen/teach/local_colours.hpp"
#include "specimen/teach/model_file.hpp"
#include "specimen/teach/pixel_features.hpp"
#include "specimen/teach/taught.hpp"

namespace specimen {
namespace {

constexpr int all_cores = 0;
constexpr double most_cells = 8e6;  ///< of a picture that teaches: what fits into half a gigabyte
constexpr int doubt = 51;           ///< lead of the likeliest phase, in 255ths, below which it is uncertain
constexpr double ridge = 10;        ///< contrast that is noise where boundaries are smoothed [L]
constexpr double smooth_share = 0.01;  ///< radius of that over the shorter side

void tell(ConvertReport& report, std::string text) { report.notes.push_back(std::move(text)); }

/// Labels brought to the rows and columns of a picture whose pixels were made square.
Raster<std::uint8_t> repeated_to(Raster<std::uint8_t> labels, int rows, int cols) {
  if (labels.rows == rows && labels.cols == cols) return labels;
  Raster<std::uint8_t> fitted(rows, cols);
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < cols; ++c)
      fitted(r, c) =
          labels(static_cast<int>((std::int64_t{2} * r + 1) * labels.rows / (2 * std::int64_t{rows})),
                 static_cast<int>((std::int64_t{2} * c + 1) * labels.cols / (2 * std::int64_t{cols})));
  return fitted;
}

/// Of squares of pixels: the one label that strokes show in it, cut_stroke if one is among them, no_stroke
/// for two phases.
Raster<std::uint8_t> labels_of_squares(const Raster<std::uint8_t>& labels, int factor) {
  if (factor == 1) return labels;
  Raster<std::uint8_t> cells((labels.rows + factor - 1) / factor, (labels.cols + factor - 1) / factor,
                             no_stroke);
  Raster<std::uint8_t> mixed(cells.rows, cells.cols, 0);
  for (int r = 0; r < labels.rows; ++r)
    for (int c = 0; c < labels.cols; ++c) {
      const std::uint8_t label = labels(r, c);
      std::uint8_t& cell = cells(r / factor, c / factor);
      if (label == no_stroke || cell == cut_stroke) continue;
      if (label == cut_stroke || cell == no_stroke)
        cell = label;
      else if (cell != label)
        mixed(r / factor, c / factor) = 1;
    }
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (mixed.data[i] != 0 && cells.data[i] != cut_stroke) cells.data[i] = no_stroke;
  return cells;
}

/// Of squares of pixels: 1 where one of them is marked.
Raster<std::uint8_t> marks_of_squares(const Raster<std::uint8_t>& marks, int factor) {
  Raster<std::uint8_t> cells((marks.rows + factor - 1) / factor, (marks.cols + factor - 1) / factor, 0);
  for (int r = 0; r < marks.rows; ++r)
    for (int c = 0; c < marks.cols; ++c) cells(r / factor, c / factor) |= marks(r, c);
  return cells;
}

std::string size_of(int rows, int cols) { return grouped(cols) + " x " + grouped(rows) + " px"; }

/// The colours of a picture that is not needed any more, averaged.
Raster<Lab> cells_of(Picture picture, int factor, ConvertReport& report) {
  Raster<Rgb> colour =
      picture.colour.empty() ? as_colour(picture.gray, picture.bits) : std::move(picture.colour);
  picture = {};
  if (factor > 1) {
    tell(report,
         "averaged squares of " + std::to_string(factor) + " x " + std::to_string(factor) + " pixels");
    colour = shrunk(colour, factor);
  }
  return to_lab(colour);
}

void tell_light(double ratio, ConvertReport& report) {
  tell(report, "evened out the light, which is " + short_number(ratio) +
                   " times as bright at one place as at another");
}

void tell_teaching(const TeachingReport& teaching, ConvertReport& report) {
  std::string shown, right;
  for (const TeachingReport::OfPhase& one : teaching.phases) {
    shown += (shown.empty() ? "" : ", ") + one.phase + " by " + counted(one.strokes, "stroke") + " of " +
             counted(one.cells, "pixel");
    if (!std::isnan(one.right))
      right += (right.empty() ? "" : ", ") + one.phase + " " + share_text(one.right, 1);
  }
  tell(report, "taught " + shown);
  if (!right.empty())
    tell(report,
         "pixels of strokes that were hidden from the trees that sort them are told rightly: " + right);
}

void check_scale(const TaughtModel& model, double pixel_size, ConvertReport& report) {
  const double ratio = pixel_size / model.pixel_size;
  if (!(ratio > 0.8 && ratio < 1.25))
    tell(report, "the model was taught with pixels of " + length_text(model.pixel_size) +
                     ", this picture has " + length_text(pixel_size) +
                     ": textures look different, so look at the overlay");
}

/// The likeliest class of each cell.
Raster<std::uint8_t> likeliest(const ClassShares& shares) {
  Raster<std::uint8_t> classes(shares.rows, shares.cols);
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const std::uint8_t* share = shares.data.data() + i * static_cast<std::size_t>(shares.classes);
    classes.data[i] = static_cast<std::uint8_t>(std::max_element(share, share + shares.classes) - share);
  }
  return classes;
}

/// Where another class is nearly as likely as the likeliest one.
Raster<std::uint8_t> uncertain(const ClassShares& shares) {
  Raster<std::uint8_t> cells(shares.rows, shares.cols);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::uint8_t* share = shares.data.data() + i * static_cast<std::size_t>(shares.classes);
    int best = share[0], second = 0;
    for (int k = 1; k < shares.classes; ++k) {
      second = std::max(second, std::min<int>(best, share[k]));
      best = std::max<int>(best, share[k]);
    }
    cells.data[i] = best - second < doubt ? 1 : 0;
  }
  return cells;
}

/// What became of the pixels under the strokes.
void tell_agreement(const Raster<Cell>& cells, const Raster<std::uint8_t>& strokes, ConvertReport& report) {
  double all = 0, kept = 0;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (strokes.data[i] < cut_stroke) ++all, kept += phase_of(cells.data[i]) == strokes.data[i] ? 1 : 0;
  tell(report, share_text(kept, all) + " of the pixels under the strokes have the phase of their stroke");
}

}  // namespace

Strokes strokes_for(const Picture& whole, const ConvertOptions& options) {
  if (!options.model.empty()) return {};
  if (!options.stroke_lines.empty()) return strokes_along(options.stroke_lines, whole.rows(), whole.cols());
  const Picture drawn = read_picture(options.strokes, options.max_pixels);
  if (drawn.rows() != whole.rows() || drawn.cols() != whole.cols())
    throw Error(options.strokes, size_of(drawn.rows(), drawn.cols()),
                "strokes must have the size of the whole picture, " + size_of(whole.rows(), whole.cols()),
                "paint them on a layer over the picture itself, and save this layer without trimming it");
  return painted_strokes(drawn, options.strokes, options.label_phases);
}

namespace {

/// The model of the options, or an empty one that says how the picture is to be looked at.
TaughtModel model_to_begin_with(int rows, int cols, const ConvertOptions& options, ConvertReport& report) {
  if (!options.model.empty()) {
    TaughtModel model = read_model(options.model);
    check_scale(model, report.source_pixel_size, report);
    return model;
  }
  TaughtModel model;
  const double parts = std::sqrt(static_cast<double>(rows) * cols / most_cells);
  model.factor = std::max(1, static_cast<int>(std::ceil(parts)));
  model.scales =
      scales_for((rows + model.factor - 1) / model.factor, (cols + model.factor - 1) / model.factor);
  model.evens_light = options.even_light;
  return model;
}

/// Fill in what the strokes teach.
void learn(TaughtModel& model, const PixelFeatures& features, const Raster<std::uint8_t>& strokes,
           const std::vector<std::string>& names, ConvertReport& report) {
  TeachingReport teaching;
  TaughtModel taught = teach(features, strokes, names, all_cores, teaching);
  model.phases = std::move(taught.phases);
  model.forest = std::move(taught.forest);
  model.pixel_size = report.source_pixel_size;
  tell_teaching(teaching, report);
}

int smoothing_radius(const ConvertOptions& options, const PixelFeatures& features, int factor) {
  if (options.smooth >= 0) return static_cast<int>(std::lround(static_cast<double>(options.smooth) / factor));
  return std::max(2,
                  static_cast<int>(std::lround(smooth_share * std::min(features.rows(), features.cols()))));
}

/// What the model makes of the picture.
void sort_cells(const TaughtModel& model, const PixelFeatures& features, const ConvertOptions& options,
                Sorted& sorted, ConvertReport& report) {
  const int radius = smoothing_radius(options, features, model.factor);
  if (radius > 0)
    tell(report, "smoothed along the edges of the picture over " + std::to_string(2 * radius + 1) + " x " +
                     std::to_string(2 * radius + 1) + " pixels" + (model.factor > 1 ? " of these" : "") +
                     ", and drew the boundaries where the colours near by part");
  ClassShares shares =
      smoothed_along_edges(ask(model, features, all_cores), features.picture(), radius, ridge, all_cores);
  sorted.uncertain = uncertain(shares);  // of what the strokes taught: what follows only draws the boundaries
  if (radius > 0) {
    LocalColoursOptions colours;
    colours.window = std::max(colours.window, 2 * radius);
    shares = sharpened_by_colours(shares, features.picture(), colours, all_cores);
  }
  const Raster<std::uint8_t> classes = likeliest(shares);
  std::array<std::uint8_t, 256> label{};
  for (std::size_t k = 0; k < model.phases.size(); ++k) label[k] = label_of(sorted.phases, model.phases[k]);
  sorted.cells = Raster<Cell>(features.rows(), features.cols());
  for (std::size_t i = 0; i < sorted.cells.size(); ++i) sorted.cells.data[i] = label[classes.data[i]];
  const auto doubts =
      static_cast<double>(std::count(sorted.uncertain.data.begin(), sorted.uncertain.data.end(), 1));
  report.uncertain = doubts / static_cast<double>(sorted.uncertain.size());
  tell(report, share_text(report.uncertain, 1) +
                   " of the area is uncertain: the likeliest phase leads by less than 20 % there");
}

/// Where strokes part aggregates; empty = nowhere.
Raster<std::uint8_t> cuts_of(Raster<std::uint8_t> strokes) {
  if (std::find(strokes.data.begin(), strokes.data.end(), cut_stroke) == strokes.data.end()) return {};
  for (std::uint8_t& cell : strokes.data) cell = cell == cut_stroke ? 1 : 0;
  return strokes;
}

}  // namespace

Sorted segment_taught(Picture picture, Strokes strokes, const ConvertOptions& options,
                      ConvertReport& report) {
  const int rows = picture.rows(), cols = picture.cols();
  TaughtModel model = model_to_begin_with(rows, cols, options, report);
  Raster<Lab> lab = cells_of(std::move(picture), model.factor, report);
  if (model.evens_light) tell_light(even_light(lab), report);
  const PixelFeatures features(std::move(lab), model.scales, all_cores);
  Sorted sorted;
  Raster<std::uint8_t> shown;
  if (options.model.empty()) {
    shown = labels_of_squares(repeated_to(std::move(strokes.labels), rows, cols), model.factor);
    learn(model, features, shown, strokes.phases, report);
    sorted.model = encode_model(model);
  }
  sorted.factor = model.factor;
  sorted.photograph = true;
  sorted.is_taught = true;
  sort_cells(model, features, options, sorted, report);
  if (shown.empty()) return sorted;
  tell_agreement(sorted.cells, shown, report);
  sorted.cuts = cuts_of(std::move(shown));
  if (!strokes.joins.empty())
    sorted.joins = marks_of_squares(repeated_to(std::move(strokes.joins), rows, cols), model.factor);
  return sorted;
}

}  // namespace specimen
