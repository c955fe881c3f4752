#include "specimen/convert/tones.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "specimen/convert/levels.hpp"

namespace specimen {
namespace {

constexpr std::int32_t unsettled = -1;
/// Number of a tone of a pixel, in two bytes: rasters of them stand beside large pictures.
using ToneNumber = std::uint16_t;
constexpr ToneNumber no_tone = 0xffff;
ToneNumber number_of_tone(std::int32_t tone) { return tone < 0 ? no_tone : static_cast<ToneNumber>(tone); }
constexpr int few_tones = 12;         ///< up to which a tone is more than one exact value
constexpr double least_trace = 0.25;  ///< of a tone in a pixel of another that may be a gap [-]

std::uint32_t packed(Rgb c) { return static_cast<std::uint32_t>(c.r << 16 | c.g << 8 | c.b); }
Rgb unpacked(std::uint32_t v) {
  return {static_cast<std::uint8_t>(v >> 16), static_cast<std::uint8_t>(v >> 8),
          static_cast<std::uint8_t>(v)};
}

/// Largest difference of a channel.
int apart(Rgb x, Rgb y) { return std::max({std::abs(x.r - y.r), std::abs(x.g - y.g), std::abs(x.b - y.b)}); }

struct Tone {
  Rgb colour;
  std::int64_t flat = 0;  ///< pixels in the middle of 3 x 3 equal ones
};

class Sorter {
 public:
  Sorter(const Raster<Rgb>& picture, bool lossy) : picture_(picture), lossy_(lossy) {}

  /// Code of each pixel, or nothing.
  std::optional<Raster<ToneNumber>> sort() {
    constexpr double least_core = 0.6;
    constexpr int most_rounds = 3;
    const auto pixels = static_cast<double>(picture_.size());
    most_unexplained_ = (lossy_ ? 0.06 : 0.02) * pixels;
    if (!find_tones()) return std::nullopt;
    for (int round = 0; round < most_rounds; ++round) {
      far_off_ = lossy_ || round > 0 ? 60 : 32;
      mark_cores();
      if (static_cast<double>(cores_) < least_core * pixels) return std::nullopt;
      settle();
      if (!add_missed_tone()) break;
    }
    if (explains_too_little()) return std::nullopt;
    return std::move(own_);
  }

  [[nodiscard]] const std::vector<Tone>& tones() const { return tones_; }
  [[nodiscard]] std::int64_t settled() const { return settled_; }

 private:
  [[nodiscard]] bool explains_too_little() const {
    return static_cast<double>(unexplained_) > most_unexplained_;
  }

  /// Dots too small for a flat middle have a tone of their own where nothing else explains them.
  bool add_missed_tone() {
    constexpr double least_share = 2e-4;
    constexpr std::size_t least = 8;
    if (static_cast<int>(tones_.size()) >= few_tones || far_.size() < least ||
        static_cast<double>(far_.size()) < least_share * static_cast<double>(picture_.size()))
      return false;
    const auto distance = [&](Rgb c) {
      return squared(tones_[static_cast<std::size_t>(nearest(c))].colour, c);
    };
    const auto place = far_.begin() + static_cast<std::ptrdiff_t>(far_.size() / 50);
    std::nth_element(far_.begin(), place, far_.end(),
                     [&](Rgb x, Rgb y) { return distance(x) > distance(y); });
    tones_.push_back({*place, 0});
    return true;
  }

  /// Flat pixels by colour; few in every photograph, where the search ends after some rows.
  [[nodiscard]] std::unordered_map<std::uint32_t, std::int64_t> count_flat() const {
    std::unordered_map<std::uint32_t, std::int64_t> flat;
    const int cols = picture_.cols, rows = picture_.rows;
    std::int64_t seen = 0, met = 0;
    for (int r = 1; r + 1 < rows; ++r) {
      for (int c = 1; c + 1 < cols; ++c) {
        const Rgb mine = picture_(r, c);
        ++seen;
        const auto alike = [&](Rgb other) { return lossy_ ? apart(other, mine) <= 10 : other == mine; };
        const auto row_alike = [&](int row) {
          return alike(picture_(row, c - 1)) && alike(picture_(row, c)) && alike(picture_(row, c + 1));
        };
        if (!row_alike(r) || !row_alike(r - 1) || !row_alike(r + 1)) continue;
        ++flat[packed(mine)];
        ++met;
      }
      if (r == rows / 2 && met * 5 < seen) return {};
    }
    return flat;
  }

  bool find_tones() {
    constexpr std::size_t most = no_tone - 1;
    std::vector<Tone> found;
    for (const auto& [colour, count] : count_flat()) found.push_back({unpacked(colour), count});
    std::sort(found.begin(), found.end(), [](const Tone& x, const Tone& y) {
      return x.flat != y.flat ? x.flat > y.flat : packed(x.colour) < packed(y.colour);
    });
    const auto least = lossy_ ? std::max<std::int64_t>(
                                    9, static_cast<std::int64_t>(1e-4 * static_cast<double>(picture_.size())))
                              : std::int64_t{4};
    for (const Tone& tone : found) {
      if (tone.flat < least) break;
      if (!is_ripple(tone)) tones_.push_back(tone);
      if (tones_.size() > most) return false;
    }
    reach_ = static_cast<int>(tones_.size()) > few_tones ? 0 : reach();
    return tones_.size() >= 2;
  }

  /// How far from a tone compression takes its pixels.
  [[nodiscard]] int reach() const { return lossy_ ? 28 : 10; }

  /// A little of a colour close to a tone that there is much of.
  [[nodiscard]] bool is_ripple(const Tone& tone) const {
    const double share = lossy_ ? 1 : 0.02;
    const std::size_t looked_at = std::min<std::size_t>(tones_.size(), few_tones);
    return std::any_of(tones_.begin(), tones_.begin() + static_cast<std::ptrdiff_t>(looked_at),
                       [&](const Tone& t) {
                         return apart(t.colour, tone.colour) <= reach() &&
                                static_cast<double>(tone.flat) < share * static_cast<double>(t.flat);
                       });
  }

  /// The tone that a colour is, within the reach; -1 = none.
  std::int32_t tone_of(Rgb colour) {
    if (last_ != nullptr && colour == last_colour_) return *last_;
    const auto [place, is_new] = known_.try_emplace(packed(colour), unsettled);
    if (is_new) {
      const std::int32_t tone = nearest(colour);
      if (apart(tones_[static_cast<std::size_t>(tone)].colour, colour) <= reach_) place->second = tone;
    }
    last_colour_ = colour;
    last_ = &place->second;
    return place->second;
  }

  [[nodiscard]] std::int32_t nearest(Rgb colour) const {
    std::int32_t best = 0;
    int least = std::numeric_limits<int>::max();
    for (std::size_t t = 0; t < tones_.size(); ++t)
      if (const int d = squared(tones_[t].colour, colour); d < least) {
        least = d;
        best = static_cast<std::int32_t>(t);
      }
    return best;
  }

  static int squared(Rgb x, Rgb y) {
    const int r = x.r - y.r, g = x.g - y.g, b = x.b - y.b;
    return r * r + g * g + b * b;
  }

  void mark_cores() {
    known_.clear();
    last_ = nullptr;
    far_.clear();
    cores_ = settled_ = unexplained_ = 0;
    own_ = Raster<ToneNumber>(picture_.rows, picture_.cols);
    if (reach_ == 0) {
      for (std::size_t t = 0; t < tones_.size(); ++t)
        known_[packed(tones_[t].colour)] = static_cast<std::int32_t>(t);
    }
    for (std::size_t i = 0; i < own_.size(); ++i)
      own_.data[i] = number_of_tone(reach_ == 0 ? exact(picture_.data[i]) : tone_of(picture_.data[i]));
    code_ = Raster<ToneNumber>(picture_.rows, picture_.cols, no_tone);
    const int least = lossy_ ? 4 : 3;
    for (int r = 0; r < own_.rows; ++r)
      for (int c = 0; c < own_.cols; ++c) {
        const ToneNumber mine = own_(r, c);
        if (mine == no_tone) continue;
        int alike = 0;
        for (int dr = -1; dr <= 1 && alike < least; ++dr)
          for (int dc = -1; dc <= 1 && alike < least; ++dc)
            alike += (dr != 0 || dc != 0) && own_.contains(r + dr, c + dc) && own_(r + dr, c + dc) == mine;
        const bool at_border = r == 0 || c == 0 || r + 1 == own_.rows || c + 1 == own_.cols;
        if (alike < (at_border ? 2 : least)) continue;
        code_(r, c) = mine;
        ++cores_;
      }
  }

  [[nodiscard]] std::int32_t exact(Rgb colour) const {
    const auto place = known_.find(packed(colour));
    return place == known_.end() ? unsettled : place->second;
  }

  /// Share of the tone b in a colour between two tones [-]; -1 for one that is not.
  [[nodiscard]] double share_between(Rgb colour, std::int32_t a, std::int32_t b) const {
    const double tolerance = lossy_ ? 60 : 12;
    const Rgb x = tones_[static_cast<std::size_t>(a)].colour, y = tones_[static_cast<std::size_t>(b)].colour;
    const std::array<double, 3> way{double(y.r) - x.r, double(y.g) - x.g, double(y.b) - x.b};
    const std::array<double, 3> from{double(colour.r) - x.r, double(colour.g) - x.g, double(colour.b) - x.b};
    const double length = way[0] * way[0] + way[1] * way[1] + way[2] * way[2];
    const double t = (way[0] * from[0] + way[1] * from[1] + way[2] * from[2]) / length;
    if (t <= 0 || t >= 1) return -1;
    double off = 0;
    for (std::size_t k = 0; k < 3; ++k) off += (from[k] - t * way[k]) * (from[k] - t * way[k]);
    return off > tolerance * tolerance ? -1 : t;
  }

  /// Whether a colour lies between two tones; then which of them is nearer.
  [[nodiscard]] std::int32_t between(Rgb colour, std::int32_t a, std::int32_t b) const {
    const double t = share_between(colour, a, b);
    return t < 0 ? unsettled : t < 0.5 ? a : b;
  }

  /// Whether the tone is on both sides of a pixel that has most of the other: the trace of a gap, or of a
  /// bridge, of about a pixel. Two stones must not become one because a picture was made smaller.
  [[nodiscard]] bool is_trace(int r, int c, std::int32_t tone, std::int32_t other) const {
    if (lossy_) return false;  // compression leaves such traces of its own along every edge
    const double mine = share_between(picture_(r, c), tone, other);
    if (mine < least_trace) return false;
    const auto reaches_tone = [&](int dr, int dc) {
      for (int k = 1; k <= 2; ++k) {
        const int row = r + k * dr, col = c + k * dc;
        if (!code_.contains(row, col)) return false;
        if (code_(row, col) != no_tone) return code_(row, col) == number_of_tone(tone);
        const double share = share_between(picture_(row, col), tone, other);
        if (share < 0 || share > mine) return false;
      }
      return false;
    };
    constexpr std::array<std::array<int, 2>, 4> ways{{{0, 1}, {1, 0}, {1, 1}, {1, -1}}};
    return std::any_of(ways.begin(), ways.end(), [&](const std::array<int, 2>& way) {
      return reaches_tone(way[0], way[1]) && reaches_tone(-way[0], -way[1]);
    });
  }

  /// The tone of which the pixel is the trace, where a gap is so long that nothing of its tone is near: the
  /// pixels before and behind show as much of it.
  [[nodiscard]] std::int32_t long_trace(int r, int c, std::int32_t tone) const {
    for (std::int32_t other = 0; other < static_cast<std::int32_t>(tones_.size()); ++other) {
      if (other == tone || !is_trace(r, c, tone, other)) continue;
      int alike = 0;
      for (int dr = -1; dr <= 1; ++dr)
        for (int dc = -1; dc <= 1; ++dc)
          if ((dr != 0 || dc != 0) && code_.contains(r + dr, c + dc) &&
              share_between(picture_(r + dr, c + dc), tone, other) >= least_trace)
            ++alike;
      if (alike >= 2) return other;
    }
    return unsettled;
  }

  [[nodiscard]] bool between_any(Rgb colour) const {
    for (std::int32_t a = 0; a < static_cast<std::int32_t>(tones_.size()); ++a)
      for (std::int32_t b = a + 1; b < static_cast<std::int32_t>(tones_.size()); ++b)
        if (between(colour, a, b) >= 0) return true;
    return false;
  }

  /// Tones with a core within a square window.
  void look_round(int r, int c, int radius, std::vector<std::int32_t>& met) const {
    for (int dr = -radius; dr <= radius; ++dr)
      for (int dc = -radius; dc <= radius; ++dc) {
        if (std::max(std::abs(dr), std::abs(dc)) != radius || !code_.contains(r + dr, c + dc)) continue;
        const ToneNumber t = code_(r + dr, c + dc);
        if (t != no_tone && std::find(met.begin(), met.end(), t) == met.end()) met.push_back(t);
      }
  }

  std::int32_t settle_pixel(int r, int c) {
    const Rgb colour = picture_(r, c);
    const int far = lossy_ ? 6 : 4;
    std::vector<std::int32_t>& met = met_;
    met.clear();
    for (int radius = 1; radius <= far; ++radius) {
      look_round(r, c, radius, met);
      std::int32_t best = unsettled, other = unsettled;
      int least = std::numeric_limits<int>::max();
      for (std::size_t i = 0; i < met.size(); ++i)
        for (std::size_t j = i + 1; j < met.size(); ++j)
          if (const std::int32_t t = between(colour, met[i], met[j]); t >= 0) {
            const int d = squared(tones_[static_cast<std::size_t>(t)].colour, colour);
            if (d < least) least = d, best = t, other = t == met[i] ? met[j] : met[i];
          }
      if (best >= 0) return is_trace(r, c, best, other) ? other : best;
    }
    if (const ToneNumber own = own_(r, c); own != no_tone) return own;
    if (static_cast<int>(tones_.size()) <= few_tones) {
      const std::int32_t tone = nearest(colour);
      if (const std::int32_t gap = long_trace(r, c, tone); gap != unsettled) return gap;
      if (apart(tones_[static_cast<std::size_t>(tone)].colour, colour) > far_off_ && !between_any(colour)) {
        ++unexplained_;
        far_.push_back(colour);
      }
      return tone;
    }
    ++unexplained_;
    const auto closer = [&](std::int32_t x, std::int32_t y) {
      return squared(tones_[static_cast<std::size_t>(x)].colour, colour) <
             squared(tones_[static_cast<std::size_t>(y)].colour, colour);
    };
    return met.empty() ? nearest(colour) : *std::min_element(met.begin(), met.end(), closer);
  }

  /// The cores stay; what is found for the others comes into own_, which nobody else looks at.
  void settle() {
    for (int r = 0; r < code_.rows; ++r)
      for (int c = 0; c < code_.cols; ++c) {
        if (code_(r, c) != no_tone) continue;
        const ToneNumber found = number_of_tone(settle_pixel(r, c));
        settled_ += found != own_(r, c);
        own_(r, c) = found;
        // No tone will be added; every further pixel would be held against all tones for nothing.
        if (static_cast<int>(tones_.size()) > few_tones && explains_too_little()) return;
      }
  }

  const Raster<Rgb>& picture_;
  bool lossy_;
  int reach_ = 0, far_off_ = 0;
  std::vector<Tone> tones_;
  std::unordered_map<std::uint32_t, std::int32_t> known_;
  Rgb last_colour_{};
  const std::int32_t* last_ = nullptr;
  Raster<ToneNumber> own_, code_;
  std::vector<std::int32_t> met_;
  std::vector<Rgb> far_;  ///< colours that no two tones explain
  std::int64_t cores_ = 0, settled_ = 0, unexplained_ = 0;
  double most_unexplained_ = 0;  ///< pixels
};

/// The value that the user knows a tone by: the commonest value of the picture among its pixels.
std::vector<std::int64_t> names_of(const Picture& picture, const Raster<ToneNumber>& code,
                                   const std::vector<Tone>& tones) {
  std::vector<std::int64_t> names;
  const bool coloured = is_coloured(picture);
  for (const Tone& tone : tones) names.push_back(coloured ? packed(tone.colour) : tone.colour.r);
  if (coloured) return names;
  const std::vector<std::int64_t> levels = names;
  std::vector<std::unordered_map<std::int64_t, std::int64_t>> votes(tones.size());
  for (std::size_t i = 0; i < code.size(); ++i) {
    const double gray = gray_at(picture, i);
    if (std::isfinite(gray)) ++votes[code.data[i]][static_cast<std::int64_t>(std::lround(gray))];
  }
  for (std::size_t t = 0; t < tones.size(); ++t) {
    std::int64_t most = 0;
    for (const auto& [value, count] : votes[t])
      if (count > most || (count == most && value < names[t])) most = count, names[t] = value;
  }
  std::vector<std::int64_t> distinct = names;
  std::sort(distinct.begin(), distinct.end());
  const bool all_differ = std::adjacent_find(distinct.begin(), distinct.end()) == distinct.end();
  return all_differ ? names : levels;  // fractions, such as 0.2 and 0.4
}

/// With the values in rising order; tones that go by the same value become one.
ValueMap in_order(const Raster<ToneNumber>& code, const std::vector<std::int64_t>& names, bool colours) {
  ValueMap map;
  map.colours = colours;
  map.values = names;
  std::sort(map.values.begin(), map.values.end());
  map.values.erase(std::unique(map.values.begin(), map.values.end()), map.values.end());
  std::vector<std::int32_t> place;
  for (const std::int64_t name : names)
    place.push_back(static_cast<std::int32_t>(std::lower_bound(map.values.begin(), map.values.end(), name) -
                                              map.values.begin()));
  map.code = Raster<std::int32_t>(code.rows, code.cols);
  std::transform(code.data.begin(), code.data.end(), map.code.data.begin(),
                 [&](ToneNumber tone) { return place[tone]; });
  map.black = blackest(map);
  return map;
}

}  // namespace

std::optional<TonedMap> sort_into_tones(const Picture& picture) {
  const Raster<Rgb> grey = picture.gray.empty() ? Raster<Rgb>() : shown_colours(picture);
  Sorter sorter(picture.gray.empty() ? picture.colour : grey, picture.lossy);
  const std::optional<Raster<ToneNumber>> code = sorter.sort();
  if (!code) return std::nullopt;
  const std::vector<std::int64_t> names = names_of(picture, *code, sorter.tones());
  return TonedMap{in_order(*code, names, is_coloured(picture)), sorter.settled()};
}

}  // namespace specimen
