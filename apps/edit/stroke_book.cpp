#include "apps/edit/stroke_book.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>
#include <utility>

#include "apps/scene/stroke_list.hpp"
#include "apps/settings/schema.hpp"
#include "apps/text/complaint.hpp"
#include "specimen/body/files.hpp"

namespace app {
namespace {

using specimen::StrokeLine;

constexpr std::size_t most_steps = 200;               ///< that can be undone
constexpr std::size_t most_strokes = 100'000;         ///< of a picture
constexpr std::size_t most_points = 100'000;          ///< of a stroke
constexpr double least_width = 1, most_width = 1000;  ///< [px], as strokes_along() has it

void check_stroke(const StrokeLine& line, int rows, int cols) {
  const auto refuse = [](const char* field, const std::string& value, const std::string& allowed) {
    throw Rejected(Exit::data, field, value, allowed);
  };
  if (!is_phase_name(line.phase) || line.phase.size() > 60)
    refuse("phase", line.phase.substr(0, 60),
           "must be the name of a phase: at most 60 letters, digits, _ and -");
  if (!(line.width >= least_width && line.width <= most_width))
    refuse("width", fmt::format("{} px", line.width), "must be 1 to 1000 px");
  if (line.points.empty() || line.points.size() > most_points)
    refuse("points", std::to_string(line.points.size()), fmt::format("must be 1 to {}", most_points));
  for (const auto& [x, y] : line.points)
    if (!(x >= 0 && x <= cols && y >= 0 && y <= rows))
      refuse("points", fmt::format("x = {}, y = {} px", x, y),
             fmt::format("must lie on the picture of {} x {} px", cols, rows));
}

/// Lines along the runs of a value in the rows of a raster.
void add_runs(const specimen::Raster<std::uint8_t>& values, std::uint8_t value, const std::string& phase,
              std::vector<StrokeLine>& lines) {
  for (int r = 0; r < values.rows; ++r)
    for (int c = 0; c < values.cols; ++c) {
      if (values(r, c) != value) continue;
      const int begin = c;
      while (c + 1 < values.cols && values(r, c + 1) == value) ++c;
      StrokeLine line{phase, 1, {{begin + 0.5, r + 0.5}}};
      if (c > begin) line.points.emplace_back(c + 0.5, r + 0.5);
      lines.push_back(std::move(line));
    }
}

}  // namespace

StrokeBook::StrokeBook(std::string file, const std::vector<StrokeLine>& lines, int rows, int cols)
    : file_(std::move(file)), rows_(rows), cols_(cols) {
  for (const StrokeLine& line : lines) {
    check_stroke(line, rows, cols);
    pages_.push_back(std::make_shared<const StrokeLine>(line));
  }
}

std::vector<StrokeLine> StrokeBook::lines() const {
  std::vector<StrokeLine> lines;
  for (const auto& page : pages_) {
    lines.push_back(*page);
    lines.back().where = fmt::format("stroke {}", lines.size());
  }
  return lines;
}

void StrokeBook::keep() const { keep(pages_); }

void StrokeBook::keep(const Pages& pages) const {
  if (pages.empty()) {
    std::error_code gone;
    std::filesystem::remove(file_, gone);
    return;
  }
  std::vector<StrokeLine> lines;
  for (const auto& page : pages) lines.push_back(*page);
  const std::string text = stroke_list_text(lines);
  specimen::replace_file(file_, std::as_bytes(std::span(text)));
}

void StrokeBook::turn_to(Pages pages) {
  keep(pages);
  before_.push_back(std::exchange(pages_, std::move(pages)));
  if (before_.size() > most_steps) before_.erase(before_.begin());
  after_.clear();
  ++version_;
}

void StrokeBook::add(const StrokeLine& line) {
  check_stroke(line, rows_, cols_);
  if (pages_.size() >= most_strokes)
    throw Rejected(Exit::data, "strokes", std::to_string(pages_.size()), "are as many as there may be",
                   "remove some");
  Pages pages = pages_;
  pages.push_back(std::make_shared<const StrokeLine>(line));
  turn_to(std::move(pages));
}

void StrokeBook::remove(const std::vector<std::size_t>& numbers) {
  Pages pages = pages_;
  for (const std::size_t number : numbers) {
    if (number >= pages.size())
      throw Rejected(Exit::data, "stroke", std::to_string(number),
                     fmt::format("must be one of the {} strokes", pages.size()));
    pages[number] = nullptr;
  }
  std::erase(pages, nullptr);
  if (pages.size() < pages_.size()) turn_to(std::move(pages));
}

void StrokeBook::step(std::vector<Pages>& from, std::vector<Pages>& to) {
  if (from.empty()) return;
  keep(from.back());
  to.push_back(std::exchange(pages_, std::move(from.back())));
  from.pop_back();
  ++version_;
}

void StrokeBook::undo() { step(before_, after_); }
void StrokeBook::redo() { step(after_, before_); }

std::vector<StrokeLine> lines_of(const specimen::Strokes& painted) {
  std::vector<StrokeLine> lines;
  for (std::size_t label = 0; label < painted.phases.size(); ++label)
    if (!painted.phases[label].empty())
      add_runs(painted.labels, static_cast<std::uint8_t>(label), painted.phases[label], lines);
  add_runs(painted.labels, specimen::cut_stroke, specimen::cut_word, lines);
  add_runs(painted.joins, 1, specimen::one_grain_word, lines);
  return lines;
}

}  // namespace app
