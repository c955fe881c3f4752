#include "apps/scene/stroke_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/settings/schema.hpp"
#include "apps/system/files.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/quantity.hpp"
#include "apps/text/text_parts.hpp"
#include "apps/text/words.hpp"

namespace app {
namespace {

using specimen::StrokeLine;

constexpr const char* stroke_header = "write the header stroke,phase,width_px,x_px,y_px";
constexpr const char* allowed_phase = "must be the name of a phase: letters, digits, _ and -";

/// Rows of points; those of a stroke follow each other.
class StrokeTable : public TableReader {
 public:
  using TableReader::TableReader;

  std::vector<StrokeLine> read(const std::string& text) {
    read_lines(text);
    if (!has_header()) complaints_.push_back(complaint(path_, "no header", stroke_header));
    if (complaints_.empty() && lines_.empty())
      complaints_.push_back(complaint(path_, "no strokes", "give one point a line"));
    if (!complaints_.empty()) throw Rejected(Exit::data, complaints_);
    return lines_;
  }

 private:
  static constexpr std::array<const char*, 5> names{"stroke", "phase", "width_px", "x_px", "y_px"};

  void read_header(const std::vector<CsvCell>& cells) override {
    for (const CsvCell& cell : cells) {
      const auto [name, unit] = name_and_unit(cell);
      const std::string whole = unit.empty() ? name : name + "_" + unit;
      const auto* const known = std::find(names.begin(), names.end(), whole);
      if (known == names.end())
        complain(cell.column, cell.text, "unknown column", stroke_header);
      else if (has(whole))
        complain(cell.column, whole, "column given twice", "", "remove one");
      columns_.push_back(whole);
    }
    for (const char* name : names)
      if (std::string(name) != "width_px" && !has(name) && complaints_.empty())
        complain(1, name, "column missing", stroke_header);
  }

  bool has(const std::string& name) const {
    return std::find(columns_.begin(), columns_.end(), name) != columns_.end();
  }

  void read_row(const std::vector<CsvCell>& cells) override {
    StrokeLine line;
    std::string stroke;
    std::pair<double, double> point;
    const std::size_t before = complaints_.size();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string& column = columns_[i];
      const auto number = [&] { return number_in(cells[i], column, "", Dimension::ratio).value_or(0); };
      if (column == "stroke") stroke = cells[i].text;
      if (column == "phase") line.phase = cells[i].text;
      if (column == "width_px") line.width = number();
      if (column == "x_px") point.first = number();
      if (column == "y_px") point.second = number();
      if (column == "phase" && !is_phase_name(line.phase))
        complain(cells[i].column, "phase", line.phase, allowed_phase);
    }
    if (complaints_.size() > before) return;
    if (lines_.empty() || stroke != stroke_) {
      line.where = fmt::format("{}: stroke {}", path_, stroke);
      lines_.push_back(line);
      stroke_ = stroke;
    } else if (lines_.back().phase != line.phase) {
      complain(1, "phase", line.phase, fmt::format("stroke {} began as {}", stroke, lines_.back().phase),
               "give each stroke a number of its own");
      return;
    } else if (lines_.back().width != line.width) {
      complain(1, "width_px", fmt::format("{}", line.width),
               fmt::format("stroke {} began with {}", stroke, lines_.back().width),
               "give each stroke a number of its own");
      return;
    }
    lines_.back().points.push_back(point);
  }

  std::vector<std::string> columns_;
  std::vector<StrokeLine> lines_;
  std::string stroke_;
};

using FeatureJson = nlohmann::json;

constexpr int deepest_features = 32;  ///< of brackets; a MultiLineString of a FeatureCollection has 7

/// Brackets that are open at once at most, those in texts not counted.
int deepest_brackets(const std::string& text) {
  int open = 0, most = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (in_text && text[i] == '\\')
      ++i;
    else if (text[i] == '"')
      in_text = !in_text;
    else if (!in_text && (text[i] == '[' || text[i] == '{'))
      most = std::max(most, ++open);
    else if (!in_text && (text[i] == ']' || text[i] == '}'))
      --open;
  }
  return most;
}

Rejected bad_feature(const std::string& where, const std::string& value, const std::string& allowed) {
  return {Exit::data, where, value, allowed, ""};
}

/// The phase of a feature, as this program or QuPath calls it.
std::string phase_of_feature(const FeatureJson& feature, const std::string& where) {
  const FeatureJson properties = feature.value("properties", FeatureJson::object());
  std::string phase;
  if (properties.is_object()) {
    if (const auto named = properties.find("phase"); named != properties.end() && named->is_string())
      phase = *named;
    if (const auto sorted = properties.find("classification");
        phase.empty() && sorted != properties.end() && sorted->is_object())
      if (const auto name = sorted->find("name"); name != sorted->end() && name->is_string()) phase = *name;
  }
  phase = lower(phase);
  if (!is_phase_name(phase))
    throw bad_feature(where, phase.empty() ? "no phase" : phase,
                      std::string("its property phase ") + allowed_phase);
  return phase;
}

std::pair<double, double> point_of(const FeatureJson& position, const std::string& where) {
  if (!position.is_array() || position.size() < 2 || !position[0].is_number() || !position[1].is_number())
    throw bad_feature(where, position.dump().substr(0, 40), "a position must be [x, y] in pixels");
  return {position[0].get<double>(), position[1].get<double>()};
}

void add_line(const FeatureJson& positions, StrokeLine line, std::vector<StrokeLine>& lines) {
  if (!positions.is_array())
    throw bad_feature(line.where, positions.dump().substr(0, 40), "coordinates must be a list");
  for (const FeatureJson& position : positions) line.points.push_back(point_of(position, line.where));
  lines.push_back(std::move(line));
}

void add_feature(const FeatureJson& feature, const std::string& where, std::vector<StrokeLine>& lines) {
  const auto geometry = feature.is_object() ? feature.find("geometry") : feature.end();
  if (!feature.is_object() || geometry == feature.end() || !geometry->is_object())
    throw bad_feature(where, "no geometry", "must be a feature with a line");
  StrokeLine line;
  line.where = where;
  line.phase = phase_of_feature(feature, where);
  if (const auto properties = feature.find("properties"); properties->is_object())
    if (const auto width = properties->find("width"); width != properties->end()) {
      if (!width->is_number())
        throw bad_feature(where, width->dump().substr(0, 40),
                          "its property width must be a number of pixels");
      line.width = width->get<double>();
    }
  const FeatureJson type = geometry->value("type", FeatureJson()),
                    coordinates = geometry->value("coordinates", FeatureJson());
  if (type == "LineString") return add_line(coordinates, line, lines);
  if (type == "Point") return add_line(FeatureJson::array({coordinates}), line, lines);
  if ((type != "MultiLineString" && type != "MultiPoint") || !coordinates.is_array())
    throw bad_feature(where, type.is_string() ? type.get<std::string>() : "no type",
                      "strokes are of type LineString, MultiLineString, Point or MultiPoint");
  for (const FeatureJson& part : coordinates)
    add_line(type == "MultiPoint" ? FeatureJson::array({part}) : part, line, lines);
}

std::vector<StrokeLine> strokes_of_json(const std::string& text, const std::string& path) {
  if (deepest_brackets(text) > deepest_features)
    throw bad_feature(path, fmt::format("brackets deeper than {}", deepest_features), "must be GeoJSON");
  const FeatureJson json = FeatureJson::parse(text, nullptr, false);
  if (json.is_discarded()) throw bad_feature(path, "is no JSON", "strokes are GeoJSON, CSV or a picture");
  const FeatureJson features = json.is_array()                                 ? json
                               : json.is_object() && json.contains("features") ? json["features"]
                                                                               : FeatureJson::array({json});
  if (!features.is_array()) throw bad_feature(path, "no list of features", "must be a FeatureCollection");
  std::vector<StrokeLine> lines;
  for (std::size_t i = 0; i < features.size(); ++i)
    add_feature(features[i], fmt::format("{}: feature {}", path, i + 1), lines);
  if (lines.empty()) throw bad_feature(path, "no strokes", "every phase needs one");
  return lines;
}

}  // namespace

bool holds_lines(const std::string& path) {
  const std::string ending = ending_of(path);
  return ending == ".csv" || ending == ".geojson" || ending == ".json";
}

std::vector<specimen::StrokeLine> parse_stroke_list(const std::string& text, const std::string& path) {
  if (ending_of(path) == ".csv") return StrokeTable(path).read(text);
  return strokes_of_json(text, path);
}

std::string stroke_list_text(const std::vector<StrokeLine>& lines) {
  std::string text = "stroke,phase,width_px,x_px,y_px\n";
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (const auto& [x, y] : lines[i].points)
      text += fmt::format("{},{},{},{},{}\n", i + 1, lines[i].phase, lines[i].width, x, y);
  return text;
}

std::vector<specimen::StrokeLine> read_stroke_list(const std::string& path) {
  return parse_stroke_list(read_text_file(path, longest_table), path);
}

}  // namespace app
