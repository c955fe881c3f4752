#include "specimen/convert/segment.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "specimen/body/error.hpp"
#include "specimen/body/measure.hpp"
#include "specimen/convert/classes.hpp"
#include "specimen/convert/convert_options.hpp"
#include "specimen/convert/guess.hpp"
#include "specimen/convert/levels.hpp"
#include "specimen/convert/outside.hpp"
#include "specimen/convert/photo.hpp"
#include "specimen/convert/reading.hpp"
#include "specimen/convert/segment_map.hpp"
#include "specimen/convert/segment_taught.hpp"
#include "specimen/convert/smoothing.hpp"
#include "specimen/picture/image_colour.hpp"

namespace specimen {
namespace {

void note(ConvertReport& report, std::string text) { report.notes.push_back(std::move(text)); }

/// Edge of the median filter on a picture that was averaged: as given in pixels of the picture itself, or 1 %
/// of the shorter side, which leaves what a mask can show.
int median_edge(const ConvertOptions& o, int rows, int cols, int factor) {
  const auto odd = [](double edge) { return 2 * static_cast<int>(std::lround((edge - 1) / 2)) + 1; };
  if (o.median > 1 && factor > 1) return odd(std::max(1.0, static_cast<double>(o.median) / factor));
  return o.median >= 0 ? o.median : odd(0.01 * std::min(rows, cols));
}

/// Twice the columns of the mask are sharp enough for a vote; below some 600 the colours of small pores mix
/// with what is round them. Of a large picture the median would leave no more than its average over squares,
/// and sorting takes some 70 bytes a pixel.
int shrink_factor(const ConvertOptions& o, int rows, int cols) {
  constexpr int fewest_columns = 600, fine_enough = 2000, least = 3;
  constexpr double large = 16e6;  // [px]
  const bool is_large = static_cast<double>(rows) * cols > large;
  const int needed = is_large ? std::max(least, std::min(rows, cols) / fine_enough) : 1;
  if (o.median != -1 || o.pixels == 0) return needed;
  return std::max(needed, cols / std::max(2 * o.pixels, fewest_columns));
}

template <class T>
Raster<T> calmed(const Raster<T>& picture, const ConvertOptions& o, int& factor, ConvertReport& report) {
  factor = shrink_factor(o, picture.rows, picture.cols);
  Raster<T> calm = factor > 1 ? shrunk(picture, factor) : picture;
  if (factor > 1)
    note(report,
         "averaged squares of " + std::to_string(factor) + " x " + std::to_string(factor) + " pixels");
  const int edge = std::min(median_edge(o, calm.rows, calm.cols, factor), 255);
  if (edge <= 1) return calm;
  note(report, "median over " + std::to_string(edge) + " x " + std::to_string(edge) + " pixels" +
                   (factor > 1 ? " of these" : "") + (o.median < 0 ? ", chosen as 1 % of the picture" : ""));
  return median_of(calm, edge);
}

void note_classes(const Raster<std::uint8_t>& classes, const std::vector<std::string>& phases,
                  const std::vector<std::string>& centres, bool guessed, ConvertReport& report) {
  std::vector<double> count(phases.size(), 0);
  for (const std::uint8_t k : classes.data) ++count[k];
  std::string text;
  for (std::size_t k = 0; k < phases.size(); ++k)
    text += (text.empty() ? "" : ", ") + centres[k] + " = " + phases[k] + " (" +
            share_text(count[k], static_cast<double>(classes.size())) + ")";
  note(report, std::string("phases of the classes from dark to bright, ") +
                   (guessed ? "guessed: " : "as given: ") + text +
                   (guessed ? "; class_phases gives them other ones, in this order" : ""));
}

void fill_cells(Sorted& sorted, const Raster<std::uint8_t>& classes, const std::vector<std::string>& phases) {
  Raster<std::int32_t> code(classes.rows, classes.cols);
  for (std::size_t i = 0; i < code.size(); ++i) code.data[i] = classes.data[i];
  fill_cells(sorted, std::move(code), phases);
  if (sorted.drawing) return;  // each colour is a grain of its own
  for (Cell& cell : sorted.cells.data)
    if (is_aggregate(cell)) cell = phase::aggregate;  // light and dark minerals of one stone
}

std::vector<double> thresholds_of(const Raster<double>& channel, const ConvertOptions& o,
                                  Segmentation method) {
  if (method == Segmentation::threshold) return o.thresholds;
  if (method == Segmentation::otsu) return otsu_thresholds(channel, 2);
  const int named = static_cast<int>(o.class_phases.size());
  return otsu_thresholds(channel, o.classes != 0 ? o.classes : named != 0 ? named : 3);
}

/// A photograph whose outside is filled with mirror images of the middle of its inside, so that it neither
/// leads the classes astray nor makes shapes of its own; hot pixels are tamed.
struct Inside {
  Picture picture;
  OutsideMask outside;
};

bool is_inside(const OutsideMask& outside, const Crop& part) {
  for (int r = part.y; r < part.y + part.height; ++r)
    for (int c = part.x; c < part.x + part.width; ++c)
      if (outside(r, c) != 0) return false;
  return true;
}

/// A rectangle round the middle of the body that lies in it; of one pixel where there is no larger one.
Crop middle_of(const OutsideMask& outside) {
  double rows = 0, cols = 0, count = 0;
  for (int r = 0; r < outside.rows; ++r)
    for (int c = 0; c < outside.cols; ++c)
      if (outside(r, c) == 0) rows += r, cols += c, ++count;
  const int row = static_cast<int>(rows / std::max(1.0, count)),
            col = static_cast<int>(cols / std::max(1.0, count));
  for (double share = 0.95; share > 0.02; share -= 0.03) {
    const int high = static_cast<int>(share * std::min(row, outside.rows - 1 - row));
    const int wide = static_cast<int>(share * std::min(col, outside.cols - 1 - col));
    const Crop part{col - wide, row - high, 2 * wide + 1, 2 * high + 1};
    if (is_inside(outside, part)) return part;
  }
  return {col, row, 1, 1};
}

/// Place of a coordinate in a strip that is mirrored at its ends again and again.
int mirrored(int at, int first, int length) {
  const int period = 2 * length, turn = ((at - first) % period + period) % period;
  return first + (turn < length ? turn : period - 1 - turn);
}

template <class T>
void fill_outside(Raster<T>& values, const OutsideMask& outside, const Crop& middle) {
  for (int r = 0; r < values.rows; ++r)
    for (int c = 0; c < values.cols; ++c)
      if (outside(r, c) != 0)
        values(r, c) = values(mirrored(r, middle.y, middle.height), mirrored(c, middle.x, middle.width));
}

Inside inside_of(Picture picture, const ConvertOptions& o, ConvertReport& report) {
  Inside inside{std::move(picture), {}};
  Picture& p = inside.picture;
  if (o.outside != Outside::none)
    inside.outside = outside_of_photograph(p, o.outside == Outside::void_);
  else if (p.opacity.empty())
    inside.outside = without_value(p);  // what is no number has no colour either
  if (!inside.outside.empty()) {
    const bool clear = !without_value(p).empty();
    const Crop middle = middle_of(inside.outside);
    if (!p.gray.empty())
      p.gray = p.gray.with([&](auto gray) {
        fill_outside(gray, inside.outside, middle);
        return gray;
      });
    if (!p.colour.empty()) fill_outside(p.colour, inside.outside, middle);
    const auto pixels =
        static_cast<double>(std::count(inside.outside.data.begin(), inside.outside.data.end(), 1));
    note_outside(pixels, static_cast<double>(inside.outside.size()),
                 clear ? "transparent or without a value" : "even and at the corners", report);
  }
  if (!p.gray.empty() && report.method != Segmentation::threshold)
    if (std::string outliers = tame_outliers(p.gray); !outliers.empty()) note(report, std::move(outliers));
  return inside;
}

Sorted segment_thresholds(const Picture& picture, const ConvertOptions& o, ConvertReport& report) {
  if (picture.colour.empty() && o.channel != "gray")
    throw Error("convert.channel", o.channel + " of a grey picture", "it has only the channel gray");
  Sorted sorted;
  sorted.photograph = true;
  const Raster<double> channel =
      picture.colour.empty() ? calmed(picture.gray.doubles(), o, sorted.factor, report)
                             : channel_of(calmed(picture.colour, o, sorted.factor, report), o.channel);
  report.thresholds = thresholds_of(channel, o, report.method);
  const Raster<std::uint8_t> classes = classes_between(channel, report.thresholds);
  const int count = static_cast<int>(report.thresholds.size()) + 1;
  const bool guessed = o.class_phases.empty();
  if (!guessed && static_cast<int>(o.class_phases.size()) != count)
    throw Error("convert.class_phases", counted(static_cast<std::int64_t>(o.class_phases.size()), "name"),
                "the picture has levels for " + counted(count, "class"));
  const std::vector<std::string> phases = guessed ? guess_class_phases(classes, count, true) : o.class_phases;

  std::vector<std::string> ranges;
  for (int k = 0; k < count; ++k)
    ranges.push_back(k < count - 1 ? "below " + short_number(report.thresholds[static_cast<std::size_t>(k)])
                                   : "the rest");
  note_classes(classes, phases, ranges, guessed, report);
  fill_cells(sorted, classes, phases);
  return sorted;
}

ColourClasses classes_by_colour(const Raster<Rgb>& picture, bool has_black, const ConvertOptions& o,
                                int& factor, ConvertReport& report) {
  const Raster<Lab> calm = to_lab(calmed(picture, o, factor, report));
  if (o.classes != 0) return colour_classes(calm, o.classes);
  return automatic_classes(calm, to_lab(factor > 1 ? shrunk(picture, factor) : picture), has_black);
}

/// Whether the darkest class has less than half of the lightness of the others' mean.
bool has_dark_class(const ColourClasses& found) {
  const int count = static_cast<int>(found.centres.size());
  double others = 0;
  for (int k = 1; k < count; ++k) others += found.centres[static_cast<std::size_t>(k)][0] / (count - 1);
  return found.dark || found.centres[0][0] < 0.5 * others;
}

/// A drawing in a few colours is read by how they lie, as a map of labels is.
std::vector<std::string> read_drawing(const ColourClasses& found, ConvertReport& report) {
  ValueMap map;
  map.code = Raster<std::int32_t>(found.classes.rows, found.classes.cols);
  std::copy(found.classes.data.begin(), found.classes.data.end(), map.code.data.begin());
  for (std::size_t k = 0; k < found.centres.size(); ++k) map.values.push_back(static_cast<std::int64_t>(k));
  map.black = has_dark_class(found) ? 0 : -1;
  Reading reading = read_map(map);
  if (reading.other.empty()) return std::move(reading.phases);
  std::string names;
  for (const std::string& phase : reading.other) names += (names.empty() ? "" : ",") + phase;
  report.warnings.push_back("the picture can be read in two ways; class_phases = " + names +
                            " gives the other one");
  return std::move(reading.phases);
}

/// Phases of colour classes: of a photograph a dark one is void.
std::vector<std::string> guessed_phases(const ColourClasses& found, ConvertReport& report) {
  if (!found.phases.empty()) return found.phases;
  if (found.flat) return read_drawing(found, report);
  return guess_class_phases(found.classes, static_cast<int>(found.centres.size()), has_dark_class(found));
}

/// Names belong to the classes that a run without them has told, so that these can be corrected.
[[noreturn]] void refuse_names(std::size_t names, const ColourClasses& found, const ConvertOptions& o) {
  const auto count = static_cast<std::int64_t>(found.centres.size());
  const std::string given = counted(static_cast<std::int64_t>(names), "name");
  if (o.classes != 0)
    throw Error("convert.class_phases", given, "the picture has colours for " + counted(count, "class"));
  throw Error("convert.class_phases", given,
              "the picture has " + counted(count, "class") + ", told by a conversion without names",
              "name each of them, the darkest first, or set classes = " + std::to_string(names) +
                  " for as many other ones");
}

Sorted segment_colours(const Picture& picture, const ConvertOptions& o, ConvertReport& report) {
  Sorted sorted;
  const bool is_gray = picture.colour.empty();
  const ColourClasses found =
      classes_by_colour(is_gray ? as_colour(picture.gray, picture.bits) : picture.colour,
                        !is_gray || !is_spread(picture.gray, picture.bits), o, sorted.factor, report);
  const int count = static_cast<int>(found.centres.size());
  const bool guessed = o.class_phases.empty();
  if (!guessed && static_cast<int>(o.class_phases.size()) != count)
    refuse_names(o.class_phases.size(), found, o);
  const std::vector<std::string> phases = guessed ? guessed_phases(found, report) : o.class_phases;
  sorted.drawing = found.flat;
  sorted.photograph = !found.flat;

  std::vector<std::string> centres;
  for (const auto& c : found.centres)
    centres.push_back("L " + std::to_string(std::lround(c[0])) + " a " + std::to_string(std::lround(c[1])) +
                      " b " + std::to_string(std::lround(c[2])) +
                      (c[3] > 0 ? " roughness " + std::to_string(std::lround(c[3])) : ""));
  if (!found.reason.empty()) note(report, found.reason);
  note_classes(found.classes, phases, centres, guessed, report);
  fill_cells(sorted, found.classes, phases);
  return sorted;
}

/// Every so many pixels, so that about four million are left.
Raster<Rgb> thinned(Raster<Rgb> picture) {
  constexpr double wanted = 4e6;
  const int every = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(picture.size()) / wanted)));
  if (every == 1) return picture;
  Raster<Rgb> part((picture.rows + every - 1) / every, (picture.cols + every - 1) / every);
  for (int row = 0; row < part.rows; ++row)
    for (int col = 0; col < part.cols; ++col) part(row, col) = picture(row * every, col * every);
  return part;
}

}  // namespace

Segmentation implied_method(const ConvertOptions& options) {
  if (options.method != Segmentation::automatic) return options.method;
  if (!options.strokes.empty() || !options.stroke_lines.empty() || !options.model.empty())
    return Segmentation::taught;
  if (!options.thresholds.empty()) return Segmentation::threshold;
  if (!options.label_phases.empty()) return Segmentation::labels;
  return Segmentation::automatic;
}

Sorted segment(Picture picture, const ConvertOptions& options, ConvertReport& report, Strokes strokes) {
  report.method = implied_method(options);
  const bool automatic = report.method == Segmentation::automatic;
  const bool wants_classes = options.classes != 0 || !options.class_phases.empty() || options.median > 1;
  std::optional<ValueMap> map;
  const bool takes_labels = automatic || report.method == Segmentation::labels;
  if (takes_labels && !wants_classes && options.label_phases.empty() && !picture.phases.empty())
    if (std::optional<Sorted> own = segment_own(picture, report)) return std::move(*own);
  if ((automatic && !wants_classes) || is_map_method(report.method)) map = map_of(picture, options, report);
  if (automatic && map && has_our_colours(*map)) {
    picture.phases = standard_phases();
    if (std::optional<Sorted> sorted = segment_own(picture, report)) return std::move(*sorted);
  }
  if (automatic) {
    report.method = guess_method(map);
    note(report, "method " + method_name(report.method) + ", chosen from the picture");
  }
  switch (report.method) {
    case Segmentation::labels:
      return segment_labels(require_values(std::move(map), 256, "labels"), std::move(picture), options,
                            report);
    case Segmentation::instances:
      return segment_instances(require_values(std::move(map), most_grains, "instances"), std::move(picture),
                               options, report);
    default: {
      map.reset();  // a large picture fills the memory
      Raster<Rgb> shown = thinned(shown_colours(picture));
      Inside inside = inside_of(std::move(picture), options, report);
      Sorted sorted = report.method == Segmentation::kmeans ? segment_colours(inside.picture, options, report)
                      : report.method == Segmentation::taught
                          ? segment_taught(std::move(inside.picture), std::move(strokes), options, report)
                          : segment_thresholds(inside.picture, options, report);
      sorted.outside = std::move(inside.outside);
      sorted.shown = std::move(shown);
      return sorted;
    }
  }
}

}  // namespace specimen
