#include "specimen/convert/segment.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "specimen/body/error.hpp"
#include "specimen/body/measure.hpp"
#include "specimen/convert/classes.hpp"
#include "specimen/convert/convert_options.hpp"
#include "specimen/convert/guess.hpp"
#include "specimen/convert/image_colour.hpp"
#include "specimen/convert/photo.hpp"
#include "specimen/convert/smoothing.hpp"

namespace specimen {
namespace {

void note(ConvertReport& report, std::string text) { report.notes.push_back(std::move(text)); }

/// Methods that the other options call for; automatic where they leave it open.
Segmentation implied_method(const ConvertOptions& o) {
  if (o.method != Segmentation::automatic) return o.method;
  if (!o.thresholds.empty()) return Segmentation::threshold;
  if (!o.label_phases.empty()) return Segmentation::labels;
  return Segmentation::automatic;
}

// ---- maps ----

void refuse_median(const ConvertOptions& o, Segmentation method) {
  if (o.median > 1)
    throw Error("convert.median", std::to_string(o.median) + " px on a map of " + method_name(method),
                "the values of a map are not ordered, so they have no median", "use drop_islands");
}

ValueMap require_values(const Picture& picture, int most, const char* what) {
  std::optional<ValueMap> map = distinct_values(picture, most);
  if (map) return std::move(*map);
  throw Error("convert.method", what,
              "needs a picture with whole numbers and at most " + grouped(most) + " different ones",
              "this one looks like a photograph: use kmeans or otsu");
}

/// Phase of each value as the user maps it.   @throws Error for values that were left out.
std::vector<std::string> mapped_phases(const ValueMap& map, const ConvertOptions& o) {
  std::vector<std::string> phases;
  std::string left_out;
  int count = 0;
  for (int code = 0; code < map.count(); ++code) {
    const std::int64_t value = map.values[static_cast<std::size_t>(code)];
    const auto entry = std::find_if(o.label_phases.begin(), o.label_phases.end(),
                                    [&](const auto& e) { return e.first == value; });
    phases.push_back(entry == o.label_phases.end() ? "" : entry->second);
    if (entry == o.label_phases.end() && ++count <= 10)
      left_out += (left_out.empty() ? "" : ", ") + value_text(map, code);
  }
  if (count > 0)
    throw Error("convert.label_phases", "nothing for value " + left_out + (count > 10 ? ", ..." : ""),
                "every value of the picture needs a phase",
                "add it, or leave label_phases out to have all guessed");
  return phases;
}

/// Put each pixel in its phase; aggregates of different values stay apart even where they touch.
void fill_cells(Sorted& sorted, const Raster<std::int32_t>& code, const std::vector<std::string>& phases) {
  std::vector<Cell> cell_of;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const std::uint8_t label = label_of(sorted.phases, phases[i]);
    cell_of.push_back(label == phase::aggregate ? grain(static_cast<std::int32_t>(i)) : label);
  }
  sorted.cells = Raster<Cell>(code.rows, code.cols);
  std::transform(code.data.begin(), code.data.end(), sorted.cells.data.begin(),
                 [&](std::int32_t i) { return cell_of[static_cast<std::size_t>(i)]; });
}

void note_values(const ValueMap& map, const std::vector<std::string>& phases, bool guessed,
                 ConvertReport& report) {
  std::vector<double> count(map.values.size(), 0);
  for (const std::int32_t code : map.code.data) ++count[static_cast<std::size_t>(code)];
  std::string text;
  for (int code = 0; code < map.count(); ++code) {
    const auto i = static_cast<std::size_t>(code);
    text += (text.empty() ? "" : ", ") + value_text(map, code) + " = " + phases[i] + " (" +
            share_text(count[i], static_cast<double>(map.code.size())) + ")";
  }
  note(report, std::string("phases of the values, ") + (guessed ? "guessed: " : "as given: ") + text);
}

Sorted segment_labels(const ValueMap& map, const ConvertOptions& o, ConvertReport& report) {
  refuse_median(o, Segmentation::labels);
  const bool guessed = o.label_phases.empty();
  const std::vector<std::string> phases = guessed ? guess_label_phases(map) : mapped_phases(map, o);
  note(report, "read as a map of " + counted(map.count(), map.colours ? "colour" : "label"));
  note_values(map, phases, guessed, report);
  Sorted sorted;
  fill_cells(sorted, map.code, phases);
  return sorted;
}

Sorted segment_instances(const ValueMap& map, const ConvertOptions& o, ConvertReport& report) {
  refuse_median(o, Segmentation::instances);
  if (map.colours)
    throw Error("convert.method", "instances for a colour picture",
                "grains are distinguished by whole numbers", "use labels");
  if (map.values.front() < 0)
    throw Error("convert.method", "instances with the value " + std::to_string(map.values.front()),
                "0 = matrix, and each grain has a number above 0");
  const bool has_matrix = map.values.front() == 0;
  Sorted sorted;
  sorted.keeps_grains = true;
  sorted.cells = Raster<Cell>(map.code.rows, map.code.cols);
  std::transform(
      map.code.data.begin(), map.code.data.end(), sorted.cells.data.begin(),
      [&](std::int32_t code) { return has_matrix && code == 0 ? Cell{phase::mortar} : grain(code + 1); });
  note(report, "read as a map of " + counted(map.count() - (has_matrix ? 1 : 0), "grain") + ", 0 = mortar");
  return sorted;
}

// ---- photographs ----

/// Edge of the median filter: as given, or 1 % of the shorter side, which leaves what a mask can show.
int median_edge(const ConvertOptions& o, int rows, int cols) {
  if (o.median >= 0) return o.median;
  return 2 * static_cast<int>(std::lround((0.01 * std::min(rows, cols) - 1) / 2)) + 1;
}

/// Twice the columns of the mask are sharp enough for a vote; below some 600 the colours of small pores mix
/// with what is round them.
int shrink_factor(const ConvertOptions& o, int cols) {
  constexpr int fewest_columns = 600;
  if (o.median != -1 || o.pixels == 0) return 1;
  return std::max(1, cols / std::max(2 * o.pixels, fewest_columns));
}

template <class T>
Raster<T> calmed(const Raster<T>& picture, const ConvertOptions& o, int& factor, ConvertReport& report) {
  factor = shrink_factor(o, picture.cols);
  Raster<T> calm = factor > 1 ? shrunk(picture, factor) : picture;
  if (factor > 1)
    note(report,
         "averaged squares of " + std::to_string(factor) + " x " + std::to_string(factor) + " pixels");
  const int edge = std::min(median_edge(o, calm.rows, calm.cols), 255);
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
                   (guessed ? "guessed: " : "as given: ") + text);
}

void fill_cells(Sorted& sorted, const Raster<std::uint8_t>& classes, const std::vector<std::string>& phases) {
  Raster<std::int32_t> code(classes.rows, classes.cols);
  for (std::size_t i = 0; i < code.size(); ++i) code.data[i] = classes.data[i];
  fill_cells(sorted, code, phases);
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

Sorted segment_thresholds(const Picture& picture, const ConvertOptions& o, ConvertReport& report) {
  if (picture.colour.empty() && o.channel != "gray")
    throw Error("convert.channel", o.channel + " of a grey picture", "it has only the channel gray");
  Sorted sorted;
  sorted.photograph = true;
  const Raster<double> channel =
      picture.colour.empty() ? calmed(picture.gray, o, sorted.factor, report)
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

/// Grey as colour: 8-bit values as they are, others with their span brought to 0 ... 255.
Raster<Rgb> as_colour(const Raster<double>& gray) {
  const auto [low, high] = std::minmax_element(gray.data.begin(), gray.data.end());
  const bool bytes = *low >= 0 && *high <= 255 && *high > 1;
  const double start = bytes ? 0 : *low, scale = bytes ? 1 : *high > *low ? 255 / (*high - *low) : 0;
  Raster<Rgb> colour(gray.rows, gray.cols);
  std::transform(gray.data.begin(), gray.data.end(), colour.data.begin(), [&](double v) {
    const auto level = static_cast<std::uint8_t>(std::lround((v - start) * scale));
    return Rgb{level, level, level};
  });
  return colour;
}

ColourClasses classes_by_colour(const Raster<Rgb>& picture, const ConvertOptions& o, int& factor,
                                ConvertReport& report) {
  const int count = o.classes != 0 ? o.classes : static_cast<int>(o.class_phases.size());
  const Raster<Lab> calm = to_lab(calmed(picture, o, factor, report));
  if (count != 0) return colour_classes(calm, count);
  return automatic_classes(calm, to_lab(factor > 1 ? shrunk(picture, factor) : picture));
}

/// Phases of colour classes: the darkest is void when it has less than half of the lightness of the others'
/// mean.
std::vector<std::string> guessed_phases(const ColourClasses& found) {
  const int count = static_cast<int>(found.centres.size());
  if (!found.phases.empty()) return found.phases;
  double others = 0;
  for (int k = 1; k < count; ++k) others += found.centres[static_cast<std::size_t>(k)][0] / (count - 1);
  const bool dark = found.dark || (!found.flat && found.centres[0][0] < 0.5 * others);
  return guess_class_phases(found.classes, count, dark);
}

Sorted segment_colours(const Picture& picture, const ConvertOptions& o, ConvertReport& report) {
  Sorted sorted;
  const ColourClasses found = classes_by_colour(
      picture.colour.empty() ? as_colour(picture.gray) : picture.colour, o, sorted.factor, report);
  const int count = static_cast<int>(found.centres.size());
  const bool guessed = o.class_phases.empty();
  if (!guessed && static_cast<int>(o.class_phases.size()) != count)
    throw Error("convert.class_phases", counted(static_cast<std::int64_t>(o.class_phases.size()), "name"),
                "the picture has colours for " + counted(count, "class"));
  const std::vector<std::string> phases = guessed ? guessed_phases(found) : o.class_phases;
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

}  // namespace

Sorted segment(const Picture& picture, const ConvertOptions& options, ConvertReport& report) {
  report.method = implied_method(options);
  std::optional<ValueMap> map;
  if (report.method == Segmentation::automatic) {
    const bool wants_classes = options.classes != 0 || !options.class_phases.empty() || options.median > 1;
    if (!wants_classes) map = distinct_values(picture, most_grains);
    report.method = guess_method(map);
    note(report, "method " + method_name(report.method) + ", chosen from the picture");
  }
  switch (report.method) {
    case Segmentation::labels:
      return segment_labels(map ? std::move(*map) : require_values(picture, 256, "labels"), options, report);
    case Segmentation::instances:
      return segment_instances(map ? std::move(*map) : require_values(picture, most_grains, "instances"),
                               options, report);
    case Segmentation::kmeans:
      return segment_colours(picture, options, report);
    default:
      return segment_thresholds(picture, options, report);
  }
}

}  // namespace specimen
