#include "specimen/convert/fringes.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "specimen/body/mask.hpp"

namespace specimen {
namespace {

std::size_t place_of(std::int32_t i) { return static_cast<std::size_t>(i); }

struct FringePiece {
  std::int32_t value = -1;
  bool core = false;             ///< has a pixel in the middle of 3 x 3 equal ones
  double lower = 0, higher = 0;  ///< edges shared with lower and with higher values
  [[nodiscard]] bool is_rim() const { return !core && lower > 0 && higher > 0; }
  [[nodiscard]] double along() const { return std::min(lower, higher); }
};

bool is_core(const Raster<std::int32_t>& code, int r, int c) {
  for (int dr = -1; dr <= 1; ++dr)
    for (int dc = -1; dc <= 1; ++dc)
      if (code.contains(r + dr, c + dc) && code(r + dr, c + dc) != code(r, c)) return false;
  return true;
}

/// What each piece is like, and the edges that lower and higher values share across each value.
struct FringeSurvey {
  std::vector<FringePiece> pieces;
  std::vector<double> across;

  FringeSurvey(const Raster<std::int32_t>& code, const Components& components, int count)
      : pieces(components.area.size()), across(place_of(count), 0) {
    for (int r = 0; r < code.rows; ++r)
      for (int c = 0; c < code.cols; ++c) {
        FringePiece& piece = pieces[place_of(components.piece(r, c))];
        piece.value = code(r, c);
        piece.core = piece.core || is_core(code, r, c);
        if (c + 1 < code.cols) meet(code, components, r, c, r, c + 1);
        if (r + 1 < code.rows) meet(code, components, r, c, r + 1, c);
      }
  }

 private:
  void meet(const Raster<std::int32_t>& code, const Components& components, int r, int c, int row, int col) {
    const std::int32_t a = code(r, c), b = code(row, col);
    if (a == b || a < 0 || b < 0) return;
    (a < b ? pieces[place_of(components.piece(r, c))].higher
           : pieces[place_of(components.piece(r, c))].lower) += 1;
    (b < a ? pieces[place_of(components.piece(row, col))].higher
           : pieces[place_of(components.piece(row, col))].lower) += 1;
    for (std::int32_t v = std::min(a, b) + 1; v < std::max(a, b); ++v) ++across[place_of(v)];
  }
};

/// The values whose rims are those of a resized map.
std::vector<bool> values_with_rims(const FringeSurvey& survey, const Components& components, int count) {
  constexpr double mostly = 0.8, much = 0.3;
  std::vector<double> area(place_of(count), 0), solid(place_of(count), 0), rims(place_of(count), 0);
  for (std::size_t p = 0; p < survey.pieces.size(); ++p) {
    const FringePiece& piece = survey.pieces[p];
    if (piece.value < 0) continue;
    const auto v = place_of(piece.value);
    area[v] += static_cast<double>(components.area[p]);
    if (piece.core) solid[v] += static_cast<double>(components.area[p]);
    if (piece.is_rim()) rims[v] += piece.along();
  }
  std::vector<bool> found(place_of(count), false);
  for (std::size_t v = 0; v < found.size(); ++v)
    found[v] = rims[v] > much * (rims[v] + survey.across[v]) && solid[v] > mostly * area[v] && rims[v] > 0;
  return found;
}

/// The commonest code among the neighbours of the side that has more of them; -1 where there is none.
std::int32_t side_of(const Raster<std::int32_t>& code, const Raster<std::uint8_t>& rim, int r, int c) {
  int lower = 0, higher = 0;
  std::int32_t below = -1, above = -1;
  for (int dr = -1; dr <= 1; ++dr)
    for (int dc = -1; dc <= 1; ++dc) {
      if (!code.contains(r + dr, c + dc) || rim(r + dr, c + dc) != 0) continue;
      const std::int32_t other = code(r + dr, c + dc);
      if (other < 0 || other == code(r, c)) continue;
      (other < code(r, c) ? lower : higher) += 1;
      (other < code(r, c) ? below : above) = other;
    }
  if (lower == 0 && higher == 0) return -1;
  return lower > higher ? below : above;
}

}  // namespace

std::int64_t dissolve_fringes(ValueMap& map) {
  constexpr int fewest = 3, most = 8;
  if (map.colours || map.count() < fewest || map.count() > most) return 0;
  const Components components = connected_pieces(map.code, Connectivity::edges);
  const FringeSurvey survey(map.code, components, map.count());
  const std::vector<bool> has_rims = values_with_rims(survey, components, map.count());
  if (std::find(has_rims.begin(), has_rims.end(), true) == has_rims.end()) return 0;
  Raster<std::uint8_t> rim(map.code.rows, map.code.cols, 0);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const FringePiece& piece = survey.pieces[place_of(components.piece.data[i])];
    rim.data[i] = piece.value >= 0 && piece.is_rim() && has_rims[place_of(piece.value)];
  }
  std::int64_t given = 0;
  for (int r = 0; r < rim.rows; ++r)
    for (int c = 0; c < rim.cols; ++c) {
      if (rim(r, c) == 0) continue;
      const std::int32_t side = side_of(map.code, rim, r, c);
      if (side < 0) continue;
      map.code(r, c) = side;
      ++given;
    }
  return given;
}

}  // namespace specimen
