#include "specimen/convert/convert.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "specimen/body/error.hpp"
#include "specimen/body/measure.hpp"
#include "specimen/convert/clean.hpp"
#include "specimen/convert/convert_options.hpp"
#include "specimen/convert/grains.hpp"
#include "specimen/convert/levels.hpp"
#include "specimen/convert/resample.hpp"
#include "specimen/convert/segment.hpp"
#include "specimen/convert/segment_taught.hpp"
#include "specimen/picture/picture.hpp"

namespace specimen {
namespace {

/// What cleaning will do, in pixels of the raster that is cleaned; 0 = not at all.
struct CleaningPlan {
  double open = 0, close = 0;  ///< radii [px]
  bool open_voids = false;     ///< with the same radius as the aggregates
  LeastArea least{};           ///< [px]
  bool settle_minerals =
      false;  ///< dark spots of aggregates are no voids, light spots of voids no aggregates
  bool fill_holes = false;
};

/// Automatic cleaning of a photograph: radii of 0.5 % of the shorter side; islands of aggregate and mortar
/// below 1 % of the largest aggregate (a tenth of its diameter: that is sand, and belongs to the mortar) or
/// 0.3 % of the picture, voids below 0.05 % of the picture. A drawing loses specks below 0.02 % of the
/// picture. What was taught by strokes loses islands below a square of 1 % of the shorter side, and nothing
/// else.
CleaningPlan plan_cleaning(const Sorted& sorted, const ConvertOptions& o, double cell_size) {
  CleaningPlan plan;
  const double side = std::min(sorted.cells.rows, sorted.cells.cols);
  const auto area = static_cast<double>(sorted.cells.size());
  const bool is_guessed = sorted.photograph && !sorted.is_taught;
  const double automatic_radius = is_guessed ? 0.005 * side : 0;
  plan.open = o.open < 0 ? automatic_radius : static_cast<double>(o.open) / sorted.factor;
  plan.close = o.close < 0 ? automatic_radius : static_cast<double>(o.close) / sorted.factor;
  plan.open_voids = o.open < 0 && plan.open > 0;
  plan.settle_minerals = o.drop_islands < 0 && is_guessed;
  if (o.drop_islands >= 0) {
    plan.least.fill(o.drop_islands / (cell_size * cell_size));
  } else if (sorted.is_taught) {
    plan.least.fill(0.0001 * side * side);
  } else if (sorted.photograph) {
    const auto largest = static_cast<double>(largest_aggregate(sorted.cells));
    plan.least.fill(std::min(0.01 * largest, 0.003 * area));
    plan.least[phase::void_] = std::min(plan.least[phase::mortar], 0.0005 * area);
  } else if (sorted.drawing) {
    plan.least.fill(0.0002 * area);
  }
  plan.fill_holes = o.fill_holes;
  return plan;
}

void note_change(ConvertReport& report, const std::string& what, std::int64_t pixels, std::size_t all) {
  report.notes.push_back(what + ", " + share_text(static_cast<double>(pixels), static_cast<double>(all)) +
                         " of the area");
}

void clean(Raster<Cell>& cells, const CleaningPlan& plan, double cell_size, ConvertReport& report) {
  const auto radius_text = [&](double radius) { return length_text(radius * cell_size); };
  if (plan.open_voids) {
    const Changed c = open_phase(cells, phase::void_, plan.open);
    note_change(report, "opened voids by " + radius_text(plan.open), c.pixels, cells.size());
  }
  if (plan.close > 0) {
    const Changed c = close_aggregates(cells, plan.close);
    note_change(report, "closed aggregates by " + radius_text(plan.close), c.pixels, cells.size());
  }
  if (plan.open > 0) {
    const Changed c = open_phase(cells, phase::aggregate, plan.open);
    note_change(report, "opened aggregates by " + radius_text(plan.open), c.pixels, cells.size());
  }
  if (plan.settle_minerals) {
    constexpr double mostly = 0.6;
    const Changed minerals = absorb(cells, phase::void_, phase::aggregate, mostly);
    note_change(report, "treated " + counted(minerals.pieces, "void") + " inside aggregates as dark minerals",
                minerals.pixels, cells.size());
    const Changed walls = absorb(cells, phase::aggregate, phase::void_, mostly);
    note_change(report, "treated " + counted(walls.pieces, "aggregate") + " inside voids as their walls",
                walls.pixels, cells.size());
  }
  if (plan.least[phase::mortar] > 0) {
    const Changed c = drop_islands(cells, plan.least);
    const double pixel_area = cell_size * cell_size;
    const bool one = plan.least[phase::void_] == plan.least[phase::mortar];
    note_change(report,
                "dropped " + counted(c.pieces, "island") + " below " +
                    area_text(plan.least[phase::mortar] * pixel_area) +
                    (one ? "" : " (voids: " + area_text(plan.least[phase::void_] * pixel_area) + ")"),
                c.pixels, cells.size());
  }
  if (plan.fill_holes) {
    const Changed c = fill_holes(cells);
    note_change(report, "filled " + counted(c.pieces, "hole") + " of aggregates", c.pixels, cells.size());
  }
}

/// What lies outside of the specimen is void, whatever the cleaning made of it.
void clear_outside(Sorted& sorted) {
  if (sorted.outside.empty()) return;
  for (int r = 0; r < sorted.cells.rows; ++r)
    for (int c = 0; c < sorted.cells.cols; ++c) {
      const int row = std::min(sorted.outside.rows - 1, r * sorted.factor + sorted.factor / 2);
      const int col = std::min(sorted.outside.cols - 1, c * sorted.factor + sorted.factor / 2);
      if (sorted.outside(row, col) == 0) continue;
      sorted.cells(r, c) = phase::void_;
      if (!sorted.uncertain.empty()) sorted.uncertain(r, c) = 0;
    }
}

/// Repeat rows or columns until pixels that the file calls oblong are square.
Picture squared(Picture picture, const ConvertOptions& o, ConvertReport& report) {
  if (picture.pixel_aspect == 1) return picture;
  const double aspect = picture.pixel_aspect;
  const std::string how = short_number(std::max(aspect, 1 / aspect)) + " times as " +
                          (aspect > 1 ? "high as wide" : "wide as high");
  if (o.source_pixel_size > 0)
    throw Error("convert.pixel_size", length_text(o.source_pixel_size) + " for pixels that are " + how,
                "one edge is not enough, as the resolution tag of the file says",
                "give the width of the picture instead");
  const int rows = aspect > 1 ? static_cast<int>(std::lround(picture.rows() * aspect)) : picture.rows();
  const int cols = aspect < 1 ? static_cast<int>(std::lround(picture.cols() / aspect)) : picture.cols();
  if (std::int64_t{rows} * cols > o.max_pixels)
    throw Error("convert.max_pixels", grouped(cols) + " x " + grouped(rows) + " pixels",
                "at most " + grouped(o.max_pixels) + " are allowed once they are square",
                "make the picture smaller, or raise convert.max_pixels");
  report.notes.push_back("the pixels are " + how + ", as the file says: repeated " +
                         (aspect > 1 ? "rows" : "columns") + " to make " + grouped(cols) + " x " +
                         grouped(rows) + " square ones of " + grouped(picture.cols()) + " x " +
                         grouped(picture.rows()));
  picture.pixel_size *= static_cast<double>(picture.cols()) / cols;
  const auto repeated = [&](const auto& raster) {
    std::decay_t<decltype(raster)> larger;
    if (raster.empty()) return larger;
    larger.rows = rows;
    larger.cols = cols;
    larger.data.resize(static_cast<std::size_t>(rows) * static_cast<std::size_t>(cols));
    for (int r = 0; r < rows; ++r)
      for (int c = 0; c < cols; ++c)
        larger(r, c) = raster(static_cast<int>((std::int64_t{2} * r + 1) * raster.rows / (2 * rows)),
                              static_cast<int>((std::int64_t{2} * c + 1) * raster.cols / (2 * cols)));
    return larger;
  };
  picture.gray = picture.gray.with(repeated);
  picture.colour = repeated(picture.colour);
  picture.indices = repeated(picture.indices);
  picture.opacity = repeated(picture.opacity);
  picture.pixel_aspect = 1;
  return picture;
}

/// Transparent pixels over white, for those who want them as part of the specimen.
void lay_over_white(Picture& picture) {
  if (picture.opacity.empty()) return;
  const bool is_grey = !picture.gray.empty() && picture.bits <= 16;
  const bool are_bytes = picture.gray.data.visit([](const auto& values) {
    return std::all_of(values.begin(), values.end(), [](auto v) { return v <= 255; });
  });
  const double white = std::ldexp(1.0, are_bytes ? std::min(8, picture.bits) : picture.bits) - 1;
  picture.indices = {};  // which have no names for what comes of it
  picture.names.clear();
  for (std::size_t i = 0; i < picture.opacity.size(); ++i) {
    const double opaque = picture.opacity.data[i] / 255.0;
    if (is_grey) picture.gray.data[i] = std::round(picture.gray.data[i] * opaque + white * (1 - opaque));
    const auto mix = [&](int c) {
      return static_cast<std::uint8_t>(
          (c * picture.opacity.data[i] + 255 * (255 - picture.opacity.data[i]) + 127) / 255);
    };
    if (!picture.colour.empty()) {
      Rgb& c = picture.colour.data[i];
      c = {mix(c.r), mix(c.g), mix(c.b)};
    }
  }
  picture.opacity = {};
}

void separate_grains(Sorted& sorted, const ConvertOptions& o, ConvertReport& report) {
  if (sorted.keeps_grains) {
    if (o.split_touching)
      report.notes.emplace_back("split nothing: the picture already separates the grains");
    return;
  }
  int count = number_grains(sorted.cells);
  const auto note = [&](const std::string& what, const std::string& how, int after) {
    report.notes.push_back(what + " " + counted(count, "aggregate") + " " + how + " into " + grouped(after));
    count = after;
  };
  if (!sorted.cuts.empty()) note("cut", "along strokes", cut_grains(sorted.cells, sorted.cuts));
  if (o.split_touching) note("split", "at their necks", split_grains(sorted.cells, o.split_depth));
  if (!sorted.joins.empty()) note("joined", "along strokes", join_grains(sorted.cells, sorted.joins));
}

using Shares = std::array<double, 256>;

/// Of the phases in a raster [-].
Shares shares_of(const Raster<Cell>& cells) {
  Shares shares{};
  for (const Cell cell : cells.data) shares[phase_of(cell)] += 1.0 / static_cast<double>(cells.size());
  return shares;
}

/// What the new pixels did to the phases.
void note_shares(const Shares& before, const Sorted& sorted, double pixel_size, ConvertReport& report) {
  const Shares after = shares_of(sorted.cells);
  std::string changes, thin;
  for (std::size_t label = 0; label < sorted.phases.size(); ++label) {
    if (before[label] == 0 && after[label] == 0) continue;
    changes += (changes.empty() ? "" : ", ") + sorted.phases[label] + " " + share_text(before[label], 1) +
               " -> " + share_text(after[label], 1);
    if (label != phase::itz && after[label] < 0.9 * before[label] && before[label] > 0.001)
      if (label != phase::mortar || before[phase::itz] == 0)
        thin += (thin.empty() ? "" : ", ") + sorted.phases[label];
  }
  report.notes.push_back("shares of the area in the picture and in the mask: " + changes);
  if (before[phase::itz] > 0)
    report.notes.push_back("the ITZ was drawn anew along the aggregate, one pixel of " +
                           length_text(pixel_size) + " thick");
  if (!thin.empty())
    report.notes.push_back("pixels of " + length_text(pixel_size) + " are too large for " + thin +
                           ", which lost more than a tenth of its area; ask for more pixels");
}

/// Bring the cells to the pixels of the mask.   @return the pixel size [m].
double resample(Sorted& sorted, int rows, int cols, const ConvertOptions& o, double source_pixel,
                ConvertReport& report) {
  if (o.pixels == 0) {
    if (sorted.factor > 1) sorted.cells = at_centres(sorted.cells, {rows, cols, sorted.factor, rows, cols});
    return source_pixel;
  }
  const Resampling to = choose_mask_size(rows, cols, sorted.factor, o.pixels);
  const Shares before = shares_of(sorted.cells);
  sorted.cells = resampled(sorted.cells, to);
  report.notes.push_back("resampled " + grouped(cols) + " x " + grouped(rows) + " pixels to " +
                         grouped(to.cols) + " x " + grouped(to.rows) +
                         (to.cols > to.source_cols ? " by the nearest" : " by majority"));
  if (to.cols < to.source_cols) note_shares(before, sorted, source_pixel * to.ratio(), report);
  const double left_out = rows - to.rows * to.ratio();
  if (left_out > 0.01)
    report.notes.push_back("omitted " + short_number(left_out) +
                           (short_number(left_out) == "1" ? " pixel row" : " pixel rows") +
                           " at the bottom, so that the number of rows is even");
  return source_pixel * to.ratio();
}

/// Number the grains that are left 1, 2, ... in the order of their numbers.
void fill_instances(Segmented& segmented, Raster<Cell> cells) {
  const std::vector<std::int32_t> numbers = grain_numbers(cells);
  segmented.mask.labels = Raster<std::uint8_t>(cells.rows, cells.cols);
  std::transform(cells.data.begin(), cells.data.end(), segmented.mask.labels.data.begin(), phase_of);
  segmented.instances = std::move(cells);  // in their place: a large picture fills the memory
  std::int32_t last = 0, last_number = 0;
  for (std::int32_t& cell : segmented.instances.data) {
    if (cell < first_grain) {
      cell = 0;
      continue;
    }
    if (cell != last)
      last_number = static_cast<std::int32_t>(
          std::lower_bound(numbers.begin(), numbers.end(), cell - first_grain) - numbers.begin() + 1);
    last = cell;
    cell = last_number;
  }
  segmented.inclusions = measure_inclusions(segmented.instances, segmented.mask.pixel_size);
}

void note_result(const Segmented& segmented, ConvertReport& report) {
  std::string text;
  const std::vector<std::int64_t> counts = count_labels(segmented.mask);
  for (std::size_t label = 0; label < counts.size(); ++label)
    if (counts[label] > 0)
      text +=
          (text.empty() ? "" : ", ") + segmented.mask.phases[label] + " " +
          share_text(static_cast<double>(counts[label]), static_cast<double>(segmented.mask.labels.size()));
  report.notes.push_back("the mask: " + text + "; " +
                         counted(static_cast<std::int64_t>(segmented.inclusions.size()), "aggregate"));
}

/// What a mask covers of a picture, by the nearest pixels.
template <class T>
Raster<T> part_under(const LabelledMask& mask, const Raster<T>& picture) {
  constexpr int wanted = 600;
  const int fine = (wanted + mask.labels.cols - 1) / mask.labels.cols;
  const double ratio = static_cast<double>(picture.cols) / mask.labels.cols / fine;
  Raster<T> part(mask.labels.rows * fine, mask.labels.cols * fine);
  for (int r = 0; r < part.rows; ++r)
    for (int c = 0; c < part.cols; ++c)
      part(r, c) = picture(std::min(picture.rows - 1, static_cast<int>((r + 0.5) * ratio)),
                           std::min(picture.cols - 1, static_cast<int>((c + 0.5) * ratio)));
  return part;
}

}  // namespace

Converted convert_picture(const std::string& path, const ConvertOptions& options,
                          SizeListener before_pixels) {
  check_options(options);
  return convert_picture(read_picture(path, options.max_pixels, std::move(before_pixels)), options);
}

Converted convert_picture(Picture whole, const ConvertOptions& options) {
  check_options(options);
  if (whole.origin == Origin::drawing)
    throw Error("specimen.picture", "a drawing of mesopix, made to be looked at", "must show a specimen",
                "convert the picture that the specimen was made from");
  Converted result;
  ConvertReport& report = result.report;
  report.notes = whole.notes;
  Strokes strokes;
  if (implied_method(options) == Segmentation::taught) strokes = strokes_for(whole, options);
  if (strokes.painted_over > 0)
    report.notes.push_back(counted(strokes.painted_over, "pixel") +
                           " of strokes were painted over by later strokes, which hold there");
  if (!strokes.labels.empty()) strokes.labels = cropped(std::move(strokes.labels), options.crop);
  if (!strokes.joins.empty()) strokes.joins = cropped(std::move(strokes.joins), options.crop);
  Picture picture = in_common_form(squared(cropped(std::move(whole), options.crop), options, report));
  if (options.outside == Outside::none) lay_over_white(picture);
  report.source_pixel_size = source_pixel_size(picture, options, report);

  const int rows = picture.rows(), cols = picture.cols();
  Sorted sorted = segment(std::move(picture), options, report, std::move(strokes));
  const double cell_size = report.source_pixel_size * sorted.factor;
  clean(sorted.cells, plan_cleaning(sorted, options, cell_size), cell_size, report);
  clear_outside(sorted);
  separate_grains(sorted, options, report);

  LabelledMask& mask = result.segmented.mask;
  mask.phases = sorted.phases;
  mask.pixel_size = resample(sorted, rows, cols, options, report.source_pixel_size, report);
  fill_instances(result.segmented, std::move(sorted.cells));
  note_result(result.segmented, report);
  result.model = std::move(sorted.model);
  if (sorted.photograph) result.photograph = part_under(mask, sorted.shown);
  if (!sorted.uncertain.empty()) result.uncertain = part_under(mask, sorted.uncertain);
  return result;
}

std::vector<double> intersection_over_union(const LabelledMask& mask, const LabelledMask& reference) {
  const auto size_of = [](const LabelledMask& m) {
    return std::to_string(m.labels.cols) + " x " + std::to_string(m.labels.rows) + " px";
  };
  if (mask.labels.rows != reference.labels.rows || mask.labels.cols != reference.labels.cols)
    throw Error("reference", size_of(reference), "the mask has " + size_of(mask),
                "convert both to the same pixels");
  const std::size_t count = std::max(mask.phases.size(), reference.phases.size());
  std::vector<double> both(256, 0), either(256, 0);
  for (std::size_t i = 0; i < mask.labels.size(); ++i) {
    const std::uint8_t a = mask.labels.data[i], b = reference.labels.data[i];
    ++either[a];
    if (a == b)
      ++both[a];
    else
      ++either[b];
  }
  std::vector<double> iou(count);
  for (std::size_t k = 0; k < count; ++k)
    iou[k] = either[k] > 0 ? both[k] / either[k] : std::numeric_limits<double>::quiet_NaN();
  return iou;
}

}  // namespace specimen
