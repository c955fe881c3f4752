#include "specimen/convert/convert_options.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "specimen/body/error.hpp"
#include "specimen/body/measure.hpp"
#include "specimen/picture/image_colour.hpp"

namespace specimen {
namespace {

constexpr std::int64_t most_pixels = 2'000'000'000;  ///< pixels are numbered by 31 bits

bool uses_thresholds(Segmentation method) {
  return method == Segmentation::threshold || method == Segmentation::otsu ||
         method == Segmentation::multi_otsu;
}

bool is_map(Segmentation method) {
  return method == Segmentation::labels || method == Segmentation::instances;
}

/// An option that the method would pass over is a mistake.
void check_unused(const ConvertOptions& o) {
  const std::string method = "method " + method_name(o.method);
  const bool automatic = o.method == Segmentation::automatic;
  if (!o.thresholds.empty() && !automatic && o.method != Segmentation::threshold)
    throw Error("convert.thresholds", "given with " + method, "they belong to method threshold");
  if (!o.label_phases.empty() && !automatic && o.method != Segmentation::labels &&
      o.method != Segmentation::taught)
    throw Error("convert.label_phases", "given with " + method, "they belong to labels and taught");
  if (!o.class_phases.empty() && is_map(o.method))
    throw Error("convert.class_phases", "given with " + method, "they belong to thresholds and kmeans",
                "use label_phases for a map");
  if (!o.class_phases.empty() && !o.label_phases.empty())
    throw Error("convert.class_phases", "given beside label_phases", "only one of them fits a picture");
  if (o.classes != 0 && !automatic && o.method != Segmentation::multi_otsu &&
      o.method != Segmentation::kmeans)
    throw Error("convert.classes", std::to_string(o.classes) + " with " + method,
                "they belong to multi_otsu and kmeans");
  if (o.channel != "gray" && !uses_thresholds(o.method) && o.thresholds.empty())
    throw Error("convert.channel", o.channel + " with " + method,
                "a channel belongs to threshold, otsu and multi_otsu");
}

/// What strokes teach leaves nothing to choose for classes and thresholds.
void check_taught(const ConvertOptions& o) {
  const bool has_strokes = !o.strokes.empty() || !o.stroke_lines.empty(), has_model = !o.model.empty();
  const bool automatic = o.method == Segmentation::automatic;
  const std::string given = has_model ? "convert.model" : "convert.strokes";
  if (has_strokes && has_model)
    throw Error("convert.model", "given beside strokes", "one of the two sorts a picture",
                "leave the model out to teach a new one");
  if (!o.strokes.empty() && !o.stroke_lines.empty())
    throw Error("convert.strokes", "given as a file and as lines", "they come from one place");
  if ((has_strokes || has_model) && !automatic && o.method != Segmentation::taught)
    throw Error(given, "given with method " + method_name(o.method), "belongs to method taught");
  if (o.method == Segmentation::taught && !has_strokes && !has_model)
    throw Error("convert.strokes", "none given", "method taught needs strokes or a model",
                "paint some on each phase, on a layer over the picture");
  if (o.smooth < -1 || o.smooth > 1000)
    throw Error("convert.smooth", std::to_string(o.smooth) + " px", "0 to 1,000; -1 = automatic");
  const bool is_taught = has_strokes || has_model;
  if (!is_taught && o.smooth != -1)
    throw Error("convert.smooth", std::to_string(o.smooth) + " px without strokes",
                "it belongs to method taught", "use median for other methods");
  if (o.even_light && !has_strokes)
    throw Error(
        "convert.even_light", has_model ? "given beside a model" : "given without strokes",
        has_model ? "a model says itself whether the light is evened out" : "it belongs to method taught",
        "leave it out");
  if (!is_taught) return;
  const auto refuse = [&](const std::string& field) {
    throw Error(field, "given beside " + given, "it has no effect on what strokes teach", "leave it out");
  };
  if (!o.thresholds.empty()) refuse("convert.thresholds");
  if (o.channel != "gray") refuse("convert.channel");
  if (o.classes != 0) refuse("convert.classes");
  if (!o.class_phases.empty()) refuse("convert.class_phases");
  if (o.median != -1) refuse("convert.median");
  if ((has_model || !o.stroke_lines.empty()) && !o.label_phases.empty())
    throw Error("convert.label_phases",
                has_model ? "given beside a model" : "given beside strokes that are lines",
                "they name the colours of painted strokes", "leave it out");
}

void check_classes(const ConvertOptions& o) {
  if (o.classes != 0 && (o.classes < 2 || o.classes > 16))
    throw Error("convert.classes", std::to_string(o.classes), "2 to 16, or 0 for automatic");
  std::size_t classes = static_cast<std::size_t>(o.classes);
  if (o.method == Segmentation::otsu) classes = 2;
  if (!o.thresholds.empty()) classes = o.thresholds.size() + 1;
  if (!o.class_phases.empty() && classes != 0 && o.class_phases.size() != classes)
    throw Error("convert.class_phases", counted(static_cast<std::int64_t>(o.class_phases.size()), "name"),
                "there are " + std::to_string(classes) + " classes", "name every class, darkest first");
  if (o.class_phases.size() == 1 || o.class_phases.size() > 16)
    throw Error("convert.class_phases", counted(static_cast<std::int64_t>(o.class_phases.size()), "name"),
                "2 to 16 classes are possible");
  for (const std::string& name : o.class_phases)
    if (name.empty()) throw Error("convert.class_phases", "an empty name", "every class needs a phase");
}

void check_thresholds(const ConvertOptions& o) {
  if (o.method == Segmentation::threshold && o.thresholds.empty())
    throw Error("convert.thresholds", "none given", "method threshold needs at least one",
                "give the grey levels between the phases, or use method otsu");
  if (o.thresholds.size() > 15)
    throw Error("convert.thresholds", std::to_string(o.thresholds.size()) + " values",
                "at most 15 are allowed");
  for (std::size_t i = 0; i < o.thresholds.size(); ++i)
    if (!std::isfinite(o.thresholds[i]) || (i > 0 && o.thresholds[i] <= o.thresholds[i - 1]))
      throw Error("convert.thresholds", short_number(o.thresholds[i]), "must be finite and rise");
}

void check_label_phases(const ConvertOptions& o) {
  std::set<std::int64_t> known;
  for (const auto& [value, name] : o.label_phases) {
    if (name.empty())
      throw Error("convert.label_phases", "an empty name for value " + std::to_string(value),
                  "every value needs a phase");
    if (!known.insert(value).second)
      throw Error("convert.label_phases", "value " + std::to_string(value) + " twice",
                  "each value has one phase");
  }
}

void check_cleaning(const ConvertOptions& o) {
  if (o.median != -1 && o.median != 0 && (o.median < 1 || o.median > 255 || o.median % 2 == 0))
    throw Error("convert.median", std::to_string(o.median) + " px",
                "odd, 1 to 255; 0 = none, -1 = automatic");
  for (const auto& [name, radius] : {std::pair("convert.open", o.open), std::pair("convert.close", o.close)})
    if (radius < -1 || radius > 10'000)
      throw Error(name, std::to_string(radius) + " px", "0 to 10,000; -1 = automatic");
  if (!(o.drop_islands >= 0 || o.drop_islands == -1) || std::isinf(o.drop_islands))
    throw Error("convert.drop_islands", short_number(o.drop_islands) + " m2", "must be >= 0; -1 = automatic");
  if (!(o.split_depth > 0 && o.split_depth < 1))
    throw Error("convert.split_depth", short_number(o.split_depth), "must lie between 0 and 1");
}

void check_scale(const ConvertOptions& o) {
  for (const auto& [name, length] :
       {std::pair("convert.pixel_size", o.source_pixel_size), std::pair("convert.width", o.width)})
    if (!(length >= 0) || std::isinf(length))
      throw Error(name, length_text(length), "must be > 0", "omit it to use the resolution tag of the file");
  if (o.source_pixel_size > 0 && o.width > 0)
    throw Error("convert.pixel_size",
                length_text(o.source_pixel_size) + " beside a width of " + length_text(o.width),
                "one of them sets the scale", "leave one out");
  if (o.max_pixels < 1 || o.max_pixels > most_pixels)
    throw Error("convert.max_pixels", std::to_string(o.max_pixels),
                "must lie in [1, " + std::to_string(most_pixels) + "]");
  if (o.pixels < 0 || o.pixels > 100'000)
    throw Error("convert.pixels", std::to_string(o.pixels), "1 to 100,000; 0 = as the picture");
}

template <class T>
Raster<T> part_of(const Raster<T>& picture, const Crop& crop) {
  if (picture.empty()) return {};
  Raster<T> part(crop.height, crop.width);
  for (int r = 0; r < crop.height; ++r)
    for (int c = 0; c < crop.width; ++c) part(r, c) = picture(crop.y + r, crop.x + c);
  return part;
}

std::string size_text(int cols, int rows) {
  return std::to_string(cols) + " x " + std::to_string(rows) + " px";
}

bool is_whole(const Crop& crop) { return crop.width == 0 && crop.height == 0 && crop.x == 0 && crop.y == 0; }

void check_crop(const Crop& crop, int rows, int cols) {
  const bool inside = crop.x >= 0 && crop.y >= 0 && crop.width > 0 && crop.height > 0 &&
                      crop.width <= cols - crop.x && crop.height <= rows - crop.y;
  if (!inside)
    throw Error("convert.crop",
                size_text(crop.width, crop.height) + " at column " + std::to_string(crop.x) + ", row " +
                    std::to_string(crop.y),
                "must lie within the picture of " + size_text(cols, rows));
}

}  // namespace

void check_options(const ConvertOptions& options) {
  const auto& channels = channel_names();
  if (std::find(channels.begin(), channels.end(), options.channel) == channels.end()) {
    std::string all;
    for (const std::string& name : channels) all += (all.empty() ? "" : ", ") + name;
    throw Error("convert.channel", options.channel, all + " are known");
  }
  check_taught(options);
  check_unused(options);
  check_thresholds(options);
  check_classes(options);
  check_label_phases(options);
  check_cleaning(options);
  check_scale(options);
}

Picture cropped(Picture picture, const Crop& crop) {
  if (is_whole(crop)) return picture;
  check_crop(crop, picture.rows(), picture.cols());
  picture.gray = picture.gray.with([&](const auto& raster) { return part_of(raster, crop); });
  picture.colour = part_of(picture.colour, crop);
  picture.indices = part_of(picture.indices, crop);
  picture.opacity = part_of(picture.opacity, crop);
  return picture;
}

Raster<std::uint8_t> cropped(Raster<std::uint8_t> values, const Crop& crop) {
  if (is_whole(crop)) return values;
  check_crop(crop, values.rows, values.cols);
  return part_of(values, crop);
}

double source_pixel_size(const Picture& picture, const ConvertOptions& options, ConvertReport& report) {
  if (options.source_pixel_size > 0) return options.source_pixel_size;
  if (options.width > 0) return options.width / picture.cols();
  if (picture.pixel_size <= 0)
    throw NoScale("convert.pixel_size", "not given, and the file has no scale", "the scale is needed",
                  "give source_pixel_size or width");
  report.notes.push_back(
      "the scale, " + length_text(picture.pixel_size) + " per pixel (" +
      short_number(0.0254 / picture.pixel_size) +
      " dpi), comes from the file's resolution tag and is unconfirmed; set it with --pixel-size or --width");
  return picture.pixel_size;
}

std::string method_name(Segmentation method) {
  switch (method) {
    case Segmentation::automatic:
      return "automatic";
    case Segmentation::labels:
      return "labels";
    case Segmentation::instances:
      return "instances";
    case Segmentation::threshold:
      return "threshold";
    case Segmentation::otsu:
      return "otsu";
    case Segmentation::multi_otsu:
      return "multi_otsu";
    case Segmentation::kmeans:
      return "kmeans";
    case Segmentation::taught:
      return "taught";
  }
  return "unknown";
}

}  // namespace specimen
