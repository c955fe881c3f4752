#include "specimen/teach/taught.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "specimen/body/error.hpp"
#include "specimen/body/mask.hpp"
#include "specimen/body/measure.hpp"
#include "specimen/teach/parallel.hpp"

namespace specimen {
namespace {

constexpr std::int64_t fewest_cells = 10;      ///< of a phase
constexpr std::int64_t most_lessons = 40'000;  ///< of a phase that are learnt from
constexpr int tile_rows = 64, tile_cols = 128;

/// Cells under strokes, phase by phase.
std::vector<std::vector<std::int32_t>> cells_by_label(const Raster<std::uint8_t>& strokes) {
  std::vector<std::vector<std::int32_t>> cells(256);
  for (std::size_t i = 0; i < strokes.size(); ++i)
    if (strokes.data[i] < cut_stroke) cells[strokes.data[i]].push_back(static_cast<std::int32_t>(i));
  return cells;
}

void check_strokes(const std::vector<std::vector<std::int32_t>>& cells,
                   const std::vector<std::string>& names) {
  std::vector<std::string> shown;
  for (std::size_t label = 0; label < names.size(); ++label) {
    const auto count = static_cast<std::int64_t>(cells[label].size());
    if (count == 0) {
      if (label < standard_phases().size() || names[label].empty()) continue;
      throw Error("convert.strokes", "no stroke of the phase " + names[label],
                  "every phase that is named needs one", "paint one, or leave the name out");
    }
    if (count < fewest_cells)
      throw Error("convert.strokes", counted(count, "pixel") + " of the phase " + names[label],
                  "at least " + std::to_string(fewest_cells) + " are needed to learn from",
                  "paint a longer stroke");
    shown.push_back(names[label]);
  }
  if (shown.size() < 2)
    throw Error("convert.strokes",
                shown.empty() ? "no stroke of a phase" : "strokes of " + shown.front() + " only",
                "at least two phases need a stroke", "paint one on each phase that the picture shows");
}

}  // namespace

TaughtModel teach(const PixelFeatures& features, const Raster<std::uint8_t>& strokes,
                  const std::vector<std::string>& names, int threads, TeachingReport& report) {
  const auto cells = cells_by_label(strokes);
  check_strokes(cells, names);
  const Components pieces = connected_pieces(strokes, Connectivity::corners);
  TaughtModel model;
  Lessons lessons;
  lessons.features = features.count();
  model.scales = features.scales();
  std::int32_t strokes_so_far = 0;
  for (std::size_t label = 0; label < names.size(); ++label) {
    if (cells[label].empty()) continue;
    const auto count = static_cast<std::int64_t>(cells[label].size());
    const std::int64_t taken = std::min(count, most_lessons);
    std::map<std::int32_t, std::int32_t> number;  // of the strokes of this phase
    for (const std::int32_t cell : cells[label])
      if (number.try_emplace(pieces.piece.data[static_cast<std::size_t>(cell)], strokes_so_far).second)
        ++strokes_so_far;
    for (std::int64_t i = 0; i < taken; ++i) {
      const std::int32_t cell = cells[label][static_cast<std::size_t>(i * count / taken)];
      const std::size_t at = lessons.values.size();
      lessons.values.resize(at + static_cast<std::size_t>(lessons.features));
      const int row = cell / strokes.cols, col = cell % strokes.cols;
      features.read(row, col, col + 1, lessons.values.data() + at);
      lessons.classes.push_back(static_cast<std::uint8_t>(model.phases.size()));
      lessons.strokes.push_back(number.at(pieces.piece.data[static_cast<std::size_t>(cell)]));
    }
    model.phases.push_back(names[label]);
    report.phases.push_back({names[label], static_cast<std::int64_t>(number.size()), count, 0});
  }
  Taught taught = grow_forest(lessons, static_cast<int>(model.phases.size()), {}, threads);
  for (std::size_t k = 0; k < report.phases.size(); ++k) report.phases[k].right = taught.right[k];
  model.forest = std::move(taught.forest);
  return model;
}

void ask_tile(const TaughtModel& model, const PixelFeatures& features, int row, int col, int rows, int cols,
              ClassShares& shares) {
  const auto classes = model.phases.size();
  std::vector<float> values(static_cast<std::size_t>(cols) * static_cast<std::size_t>(features.count()));
  std::vector<float> found(static_cast<std::size_t>(cols) * classes);
  for (int r = row; r < row + rows; ++r) {
    features.read(r, col, col + cols, values.data());
    ask_forest(model.forest, values.data(), cols, found.data());
    std::uint8_t* out = shares.at(r, col);
    for (const float share : found) *out++ = static_cast<std::uint8_t>(std::lround(share * 255));
  }
}

ClassShares ask(const TaughtModel& model, const PixelFeatures& features, int threads) {
  ClassShares shares(features.rows(), features.cols(), static_cast<int>(model.phases.size()));
  const int across = (features.cols() + tile_cols - 1) / tile_cols;
  const int down = (features.rows() + tile_rows - 1) / tile_rows;
  share_out(across * down, threads, [&](int tile) {
    const int row = tile / across * tile_rows, col = tile % across * tile_cols;
    ask_tile(model, features, row, col, std::min(tile_rows, features.rows() - row),
             std::min(tile_cols, features.cols() - col), shares);
  });
  return shares;
}

}  // namespace specimen
