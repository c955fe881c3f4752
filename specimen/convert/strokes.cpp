#include "specimen/convert/strokes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>

#include "specimen/body/error.hpp"
#include "specimen/body/measure.hpp"
#include "specimen/picture/image_colour.hpp"

namespace specimen {
namespace {

constexpr double widest_stroke = 1000;          ///< [px]
constexpr std::uint8_t one_grain_stroke = 253;  ///< in a table of paints only: joins are kept apart

/// A colour that strokes may have, and what it shows.
struct Paint {
  Rgb colour;
  std::uint8_t label;
};

std::vector<Paint> paints_for(const std::vector<std::pair<std::int64_t, std::string>>& names,
                              std::vector<std::string>& phases) {
  std::vector<Paint> paints{{cut_colour, cut_stroke}, {one_grain_colour, one_grain_stroke}};
  for (const auto& [value, name] : names) {
    if (value < 0 || value >= one_grain_stroke)
      throw Error("convert.label_phases", "value " + std::to_string(value),
                  "colours of strokes are those of the labels 0 to 252");
    const auto label = static_cast<std::size_t>(value);
    if (label < standard_phases().size() && name != standard_phases()[label])
      throw Error("convert.label_phases", std::to_string(value) + ":" + name,
                  "the colour of label " + std::to_string(value) + " is that of " + standard_phases()[label],
                  "give phases of your own a label above 3");
    if (phases.size() <= label) phases.resize(label + 1);
    phases[label] = name;
  }
  for (std::size_t label = 0; label < phases.size(); ++label)
    if (!phases[label].empty())
      paints.push_back({phase_colour(static_cast<std::uint8_t>(label)), static_cast<std::uint8_t>(label)});
  return paints;
}

std::string palette_text(const std::vector<Paint>& paints, const std::vector<std::string>& phases) {
  std::vector<std::string> all;
  for (const Paint& paint : paints)
    all.push_back((paint.label == cut_stroke         ? "a cut between two aggregates"
                   : paint.label == one_grain_stroke ? "one grain of several"
                                                     : phases[paint.label]) +
                  " " + colour_text(paint.colour));
  return listed(all);
}

bool is_near(Rgb a, Rgb b) {
  constexpr int reach = 8;
  return std::abs(a.r - b.r) <= reach && std::abs(a.g - b.g) <= reach && std::abs(a.b - b.b) <= reach;
}

/// Colours that are no paint, and how often each was met.
class Strange {
 public:
  void meet(Rgb colour) { ++count_[(colour.r << 16) | (colour.g << 8) | colour.b], ++all_; }
  [[nodiscard]] std::int64_t all() const { return all_; }
  [[nodiscard]] std::string commonest() const {
    const auto most = std::max_element(count_.begin(), count_.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    const auto byte = [&](int shift) { return static_cast<std::uint8_t>(most->first >> shift & 255); };
    return colour_text({byte(16), byte(8), byte(0)}) + " at " + counted(most->second, "pixel");
  }

 private:
  std::map<int, std::int64_t> count_;
  std::int64_t all_ = 0;
};

void mark(Raster<std::uint8_t>& marks, std::size_t pixel, int rows, int cols) {
  if (marks.empty()) marks = Raster<std::uint8_t>(rows, cols, 0);
  marks.data[pixel] = 1;
}

constexpr const char* how_to_paint =
    "paint on a new layer over the picture, in the colours of the phases, and save this layer alone as PNG";

}  // namespace

Strokes painted_strokes(const Picture& drawn, const std::string& path,
                        const std::vector<std::pair<std::int64_t, std::string>>& names) {
  if (drawn.opacity.empty())
    throw Error(path, "is opaque everywhere", "strokes must be transparent where nothing is painted",
                how_to_paint);
  Strokes strokes;
  strokes.labels = Raster<std::uint8_t>(drawn.rows(), drawn.cols(), no_stroke);
  const std::vector<Paint> paints = paints_for(names, strokes.phases);
  Strange strange;
  std::int64_t painted = 0;
  for (std::size_t i = 0; i < drawn.opacity.size(); ++i) {
    if (drawn.opacity.data[i] < 128) continue;
    ++painted;
    const auto grey = [&] {
      return static_cast<std::uint8_t>(
          std::clamp(drawn.gray.data[i] / std::ldexp(1.0, drawn.bits - 8), 0.0, 255.0));
    };
    const Rgb colour = drawn.colour.empty() ? Rgb{grey(), grey(), grey()} : drawn.colour.data[i];
    const auto paint = std::find_if(paints.begin(), paints.end(),
                                    [&](const Paint& one) { return is_near(one.colour, colour); });
    if (paint == paints.end())
      strange.meet(colour);
    else if (paint->label == one_grain_stroke)
      mark(strokes.joins, i, drawn.rows(), drawn.cols());
    else
      strokes.labels.data[i] = paint->label;
  }
  if (painted == 0) throw Error(path, "has no strokes", "every phase needs one", how_to_paint);
  if (painted == static_cast<std::int64_t>(drawn.opacity.size()))
    throw Error(path, "is opaque everywhere", "strokes must be transparent where nothing is painted",
                how_to_paint);
  constexpr double few = 0.02;
  if (static_cast<double>(strange.all()) > few * static_cast<double>(painted))
    throw Error(path,
                counted(strange.all(), "pixel") + " of a colour that is no phase's, most of them " +
                    strange.commonest(),
                "colours are: " + palette_text(paints, strokes.phases),
                "paint with these; label_phases = 4:NAME gives a phase of your own the colour " +
                    colour_text(phase_colour(4)));
  return strokes;
}

namespace {

/// Calls `visit(row, col)` for the pixels whose centres lie within half a width of a line.
template <class Visit>
void visit_line(const StrokeLine& line, int rows, int cols, const Visit& visit) {
  const double reach = line.width / 2;
  const std::size_t pieces = std::max<std::size_t>(1, line.points.size() - 1);
  for (std::size_t i = 0; i < pieces; ++i) {
    const auto [x0, y0] = line.points[i];
    const auto [x1, y1] = line.points[std::min(i + 1, line.points.size() - 1)];
    const double square = (x1 - x0) * (x1 - x0) + (y1 - y0) * (y1 - y0);
    const auto first = [&](double a, double b) {
      return std::max(0, static_cast<int>(std::floor(std::min(a, b) - reach)));
    };
    const auto last = [&](double a, double b, int count) {
      return std::min(count - 1, static_cast<int>(std::ceil(std::max(a, b) + reach)));
    };
    for (int row = first(y0, y1); row <= last(y0, y1, rows); ++row)
      for (int col = first(x0, x1); col <= last(x0, x1, cols); ++col) {
        const double x = col + 0.5 - x0, y = row + 0.5 - y0;
        const double along = square > 0 ? std::clamp((x * (x1 - x0) + y * (y1 - y0)) / square, 0.0, 1.0) : 0;
        if (std::hypot(x - along * (x1 - x0), y - along * (y1 - y0)) <= reach) visit(row, col);
      }
  }
}

void check_line(const StrokeLine& line, int rows, int cols) {
  if (line.points.empty()) throw Error(line.where, "no points", "a stroke needs one at least");
  if (!(line.width >= 1 && line.width <= widest_stroke))
    throw Error(line.where, "a width of " + short_number(line.width) + " px", "must be 1 to 1000 px");
  for (const auto& [x, y] : line.points)
    if (!(x >= 0 && x <= cols && y >= 0 && y <= rows))
      throw Error(line.where, "a point at x = " + short_number(x) + ", y = " + short_number(y) + " px",
                  "must lie on the picture of " + grouped(cols) + " x " + grouped(rows) + " px",
                  "x counts pixels from the left and y from the top");
}

}  // namespace

Strokes strokes_along(const std::vector<StrokeLine>& lines, int rows, int cols) {
  Strokes strokes;
  strokes.labels = Raster<std::uint8_t>(rows, cols, no_stroke);
  for (const StrokeLine& line : lines) {
    check_line(line, rows, cols);
    if (line.phase == one_grain_word) {
      visit_line(line, rows, cols, [&](int row, int col) {
        mark(strokes.joins, static_cast<std::size_t>(row) * static_cast<std::size_t>(cols) + col, rows, cols);
      });
      continue;
    }
    const std::uint8_t label = line.phase == cut_word ? cut_stroke : label_of(strokes.phases, line.phase);
    visit_line(line, rows, cols, [&](int row, int col) {
      std::uint8_t& here = strokes.labels(row, col);
      if (here != no_stroke && here != label) ++strokes.painted_over;
      here = label;
    });
  }
  return strokes;
}

}  // namespace specimen
