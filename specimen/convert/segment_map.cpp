#include "specimen/convert/segment_map.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "specimen/body/error.hpp"
#include "specimen/body/measure.hpp"
#include "specimen/convert/convert_options.hpp"
#include "specimen/convert/fringes.hpp"
#include "specimen/convert/instances.hpp"
#include "specimen/convert/levels.hpp"
#include "specimen/convert/outside.hpp"
#include "specimen/convert/reading.hpp"
#include "specimen/convert/shapes.hpp"
#include "specimen/convert/tones.hpp"

namespace specimen {
namespace {

void add_note(ConvertReport& report, std::string text) { report.notes.push_back(std::move(text)); }

void refuse_median(const ConvertOptions& o, Segmentation method) {
  if (o.median > 1)
    throw Error("convert.median", std::to_string(o.median) + " px on a map of " + method_name(method),
                "the values of a map are not ordered, so they have no median", "use drop_islands");
}

}  // namespace

bool is_map_method(Segmentation method) {
  return method == Segmentation::labels || method == Segmentation::instances;
}

ValueMap require_values(std::optional<ValueMap> map, int most, const char* what) {
  if (map && map->count() <= most) return std::move(*map);
  throw Error("convert.method", what,
              "needs a picture with whole numbers and at most " + grouped(most) + " different ones",
              "this one looks like a photograph: use kmeans or otsu");
}

namespace {

std::size_t first_marked(const OutsideMask& mask) {
  return static_cast<std::size_t>(std::find(mask.data.begin(), mask.data.end(), 1) - mask.data.begin());
}

/// Phase of each value as the user maps it.   @throws Error for values that were left out.
std::vector<std::string> mapped_phases(const ValueMap& map, const ConvertOptions& o) {
  std::vector<std::string> phases;
  std::string left_out;
  int count = 0;
  for (int code = 0; code < map.count(); ++code) {
    const std::vector<std::int64_t>& known_by = map.names.empty() ? map.values : map.names;
    const std::int64_t value = known_by[static_cast<std::size_t>(code)];
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

}  // namespace

void fill_cells(Sorted& sorted, Raster<std::int32_t> code, const std::vector<std::string>& phases) {
  std::vector<Cell> cell_of;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const std::uint8_t label = label_of(sorted.phases, phases[i]);
    cell_of.push_back(label == phase::aggregate ? grain(static_cast<std::int32_t>(i)) : label);
  }
  sorted.cells = std::move(code);  // in its place: a large picture fills the memory
  for (Cell& cell : sorted.cells.data)
    cell = cell < 0 ? Cell{phase::void_} : cell_of[static_cast<std::size_t>(cell)];
}

namespace {

void note_values(const ValueMap& map, const std::vector<std::string>& phases, const char* how,
                 ConvertReport& report) {
  std::vector<double> count(map.values.size(), 0);
  for (const std::int32_t code : map.code.data)
    if (code >= 0) ++count[static_cast<std::size_t>(code)];
  std::string text;
  for (int code = 0; code < map.count(); ++code) {
    const auto i = static_cast<std::size_t>(code);
    if (count[i] == 0) continue;
    if (code == 40) {
      text += ", ...";
      break;
    }
    text += (text.empty() ? "" : ", ") + value_text(map, code) + " = " + phases[i] + " (" +
            share_text(count[i], static_cast<double>(map.code.size())) + ")";
  }
  add_note(report, std::string("phases of the values, ") + how + ": " + text);
}

}  // namespace

void note_outside(double pixels, double all, const std::string& what, ConvertReport& report) {
  if (pixels > 0)
    add_note(report, "outside of the specimen lies " + share_text(pixels, all) + " of the picture (" + what +
                         "): void; outside = none says otherwise");
}

namespace {

/// Transparent pixels, and those that are not a number where that is not what lies between the grains.
OutsideMask without_value(const Picture& picture, const ValueMap& map,
                          const std::function<bool(std::int32_t)>& is_matrix) {
  const bool has_holes = !map.values.empty() && map.values.front() == no_number;
  if (!has_holes || !is_matrix(0)) return specimen::without_value(picture);
  Picture clear;  // its opacity alone
  clear.opacity = picture.opacity;
  return specimen::without_value(clear);
}

/// Take what lies outside of the specimen out of a map.
/// @param is_matrix  whether a code is what lies between the grains: pixels without a value may well be that.
void leave_outside_out(ValueMap& map, const Picture& picture, const ConvertOptions& o, ConvertReport& report,
                       const std::function<bool(std::int32_t)>& is_matrix) {
  if (o.outside == Outside::none) return;
  OutsideMask outside = without_value(picture, map, is_matrix);
  const bool by_value = outside.empty();
  if (by_value) outside = outside_of_map(map.code, o.outside == Outside::void_, map.black);
  if (outside.empty()) return;
  if (by_value) map.outside = map.code.data[first_marked(outside)];
  const std::string what =
      by_value ? "value " + value_text(map, map.outside) : "transparent or without a value";
  double pixels = 0;
  for (std::size_t i = 0; i < outside.size(); ++i)
    if (outside.data[i] != 0) ++pixels, map.code.data[i] = -1;
  note_outside(pixels, static_cast<double>(outside.size()), what, report);
}

/// Phases of a map: as the user says, or as they are read.   @throws TwoReadings.
std::vector<std::string> phases_of_map(ValueMap& map, const Picture& picture, const ConvertOptions& o,
                                       ConvertReport& report) {
  if (!o.label_phases.empty()) return mapped_phases(map, o);
  leave_outside_out(map, picture, o, report, [&](std::int32_t code) {
    return read_map(map).phases[static_cast<std::size_t>(code)] == "mortar";
  });
  Reading reading = read_map(map);
  if (!reading.other.empty()) throw refusal_of(map, reading);
  return std::move(reading.phases);
}

}  // namespace

Sorted segment_labels(ValueMap map, Picture picture, const ConvertOptions& o, ConvertReport& report) {
  refuse_median(o, Segmentation::labels);
  const std::vector<std::string> phases = phases_of_map(map, picture, o, report);
  if (picture.lossy)
    add_note(report,
             "a JPEG blurs gaps of a pixel or two between grains, which may have become one: save maps as "
             "PNG or TIFF");
  picture = {};
  add_note(report, "read as a map of " + counted(map.count(), map.colours ? "colour" : "label"));
  note_values(map, phases, o.label_phases.empty() ? "guessed" : "as given", report);
  Sorted sorted;
  fill_cells(sorted, std::move(map.code), phases);
  return sorted;
}

namespace {

std::string grains_text(const ValueMap& map, const GrainMap& grains) {
  std::string text =
      grains.matrix < 0 ? "nothing between them" : value_text(map, grains.matrix) + " = mortar";
  if (grains.line >= 0) text += ", " + value_text(map, grains.line) + " = lines between them";
  for (const std::int32_t v : grains.voids) text += ", " + value_text(map, v) + " = void";
  return text;
}

}  // namespace

Sorted segment_instances(ValueMap map, Picture picture, const ConvertOptions& o, ConvertReport& report) {
  refuse_median(o, Segmentation::instances);
  if (map.count() > 1)
    leave_outside_out(map, picture, o, report,
                      [&](std::int32_t code) { return understand_grains(map).matrix == code; });
  picture = {};
  const GrainMap grains = understand_grains(map);
  dissolve_line(map, grains);
  std::vector<Cell> cell_of;
  for (std::int32_t v = 0; v < map.count(); ++v) cell_of.push_back(grain(v + 1));
  if (grains.matrix >= 0) cell_of[static_cast<std::size_t>(grains.matrix)] = phase::mortar;
  for (const std::int32_t v : grains.voids) cell_of[static_cast<std::size_t>(v)] = phase::void_;
  Sorted sorted;
  sorted.keeps_grains = true;
  sorted.cells = std::move(map.code);
  for (Cell& cell : sorted.cells.data)
    cell = cell < 0 ? Cell{phase::void_} : cell_of[static_cast<std::size_t>(cell)];
  add_note(report, "read as a map of " +
                       counted(static_cast<std::int64_t>(grain_numbers(sorted.cells).size()), "grain") +
                       ", " + grains_text(map, grains));
  return sorted;
}

std::optional<Sorted> segment_own(const Picture& picture, ConvertReport& report) {
  std::vector<std::string> phases = picture.phases;
  std::optional<ValueMap> map = distinct_values(picture, static_cast<int>(phases.size()));
  if (!map) return std::nullopt;
  std::vector<std::string> names;
  for (const std::int64_t value : map->values) {
    std::size_t label = 0;
    for (; label < phases.size(); ++label) {
      const Rgb c = phase_colour(static_cast<std::uint8_t>(label));
      if (value == (map->colours ? c.r << 16 | c.g << 8 | c.b : static_cast<std::int64_t>(label))) break;
    }
    if (label == phases.size()) return std::nullopt;
    names.push_back(phases[label]);
  }
  report.method = Segmentation::labels;
  add_note(report, std::string("read as ") + (map->colours ? "the colours of phases" : "a label map") +
                       " of mesopix");
  note_values(*map, names, map->colours ? "by their colours" : "as the file says", report);
  Sorted sorted;
  sorted.phases = std::move(phases);
  fill_cells(sorted, std::move(map->code), names);
  for (Cell& cell : sorted.cells.data)
    if (is_aggregate(cell)) cell = phase::aggregate;
  return sorted;
}

bool has_our_colours(const ValueMap& map) {
  if (!map.colours || map.count() < 2) return false;
  const auto number = [](std::uint8_t label) {
    const Rgb c = phase_colour(label);
    return std::int64_t{c.r << 16 | c.g << 8 | c.b};
  };
  const auto is_ours = [&](std::int64_t value) {
    for (std::uint8_t label = 0; label <= phase::itz; ++label)
      if (value == number(label)) return true;
    return false;
  };
  return std::all_of(map.values.begin(), map.values.end(), is_ours) &&
         std::find(map.values.begin(), map.values.end(), number(phase::mortar)) != map.values.end();
}

namespace {

/// Label numbers drown in what JPEG adds to its values.
void refuse_lossy_labels(const Picture& picture) {
  constexpr double least_span = 32;
  if (!picture.lossy || is_coloured(picture) || picture.rows() < 2) return;
  double low = gray_at(picture, 0), high = low;
  const std::size_t count =
      static_cast<std::size_t>(picture.rows()) * static_cast<std::size_t>(picture.cols());
  for (std::size_t i = 0; i < count; ++i)
    low = std::min(low, gray_at(picture, i)), high = std::max(high, gray_at(picture, i));
  if (high - low < least_span)
    throw Error("convert.method",
                "a JPEG with grey levels " + short_number(low) + " to " + short_number(high),
                "label numbers do not survive the compression of JPEG", "save the labels as PNG or TIFF");
}

/// Values between which there are others only where edges are smooth.
bool has_fringes(const ValueMap& map) {
  constexpr double mostly_alone = 0.2;
  if (map.count() < 3 || map.count() > most_in_contact) return map.count() > most_in_contact;
  const std::vector<double> solid = solidity(map.code, map.count());
  const auto is_thin = [](double share) { return share < mostly_alone; };
  if (std::none_of(solid.begin(), solid.end(), is_thin)) return false;
  const std::vector<bool> bands = bands_of(shapes_of(map.code, map.count()));
  for (std::size_t v = 0; v < solid.size(); ++v)
    if (is_thin(solid[v]) && !bands[v]) return true;
  return false;
}

void note_settled(std::int64_t settled, const ValueMap& map, ConvertReport& report) {
  if (settled > 0)
    add_note(report, "gave " + counted(settled, "pixel") + " (" +
                         share_text(static_cast<double>(settled), static_cast<double>(map.code.size())) +
                         ") between two of " + counted(map.count(), "tone") + " to the nearer one");
}

}  // namespace

namespace {

/// Grains that share colours, as where a palette has fewer colours than there are grains, are told apart by
/// their indices; so is all of a picture in one colour, and what the user knows by its indices.
std::optional<ValueMap> values_of(const Picture& picture, int most, const ConvertOptions& o) {
  if (picture.indices.empty() || !shares_colours(picture)) return distinct_values(picture, most);
  std::optional<ValueMap> shown = distinct_values(picture, most);
  std::optional<ValueMap> indices = distinct_values(picture, most, Palette::indices);
  const bool tells_more =
      !o.label_phases.empty() || (shown && shown->count() < 2) || looks_like_grains(*indices);
  return tells_more ? indices : shown;
}

}  // namespace

std::optional<ValueMap> map_of(const Picture& picture, const ConvertOptions& o, ConvertReport& report) {
  refuse_lossy_labels(picture);
  constexpr int few = 8;
  constexpr double noise = 0.5;  // of a map not even that many neighbours would differ
  std::optional<ValueMap> map = values_of(picture, most_grains, o);
  if (map && !picture.lossy && map->count() > few && coherence(*map) < noise) return map;
  if (map && !picture.lossy && looks_like_grains(*map)) return map;
  if (map && !picture.lossy && !has_fringes(*map)) {
    const bool has_order = picture.indices.empty() || !shares_colours(picture);
    if (has_order) note_settled(dissolve_fringes(*map), *map, report);
    return map;
  }
  const bool is_map = map.has_value();
  map.reset();  // found again if it is needed: a large picture fills the memory
  std::optional<TonedMap> toned = sort_into_tones(picture);
  if (!toned && picture.lossy) return std::nullopt;  // exact values mean nothing in a JPEG
  if (!toned || (is_map && !picture.lossy && toned->settled == 0))
    return is_map ? values_of(picture, most_grains, o) : std::nullopt;
  note_settled(toned->settled, toned->map, report);
  name_by_palette(toned->map, picture);
  return std::move(toned->map);
}

}  // namespace specimen
