#include "specimen/convert/photo.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "specimen/convert/classes.hpp"
#include "specimen/convert/smoothing.hpp"

namespace specimen {
namespace {

constexpr double lightness_weight = 0.5, roughness_weight = 2;

Position lab_of(Lab c) { return {c.l(), c.a(), c.b(), 0}; }
Position weighted(Position at) { return {at[0] * lightness_weight, at[1], at[2], at[3] * roughness_weight}; }

/// Some 20,000 pixels on a regular grid; they stand for the whole picture where its colours are learnt.
template <class T>
std::vector<T> sample(const Raster<T>& picture) {
  const double pixels = static_cast<double>(picture.size());
  const int step = std::max(1, static_cast<int>(std::sqrt(pixels / 20'000)));
  std::vector<T> colours;
  for (int r = step / 2; r < picture.rows; r += step)
    for (int c = step / 2; c < picture.cols; c += step) colours.push_back(picture(r, c));
  return colours;
}

std::vector<WeightedPoint> points_of(const std::vector<Lab>& colours) {
  std::map<Position, double> count;
  for (const Lab c : colours) ++count[weighted(lab_of(c))];
  std::vector<WeightedPoint> points;
  for (const auto& [at, weight] : count) points.push_back({at, weight});
  return points;
}

double median_lightness(std::vector<Lab> colours) {
  const auto middle = colours.begin() + static_cast<std::ptrdiff_t>(colours.size() / 2);
  std::nth_element(colours.begin(), middle, colours.end(), [](Lab x, Lab y) { return x.l_code < y.l_code; });
  return middle->l();
}

std::vector<Position> rising_lightness(std::vector<Position> centres) {
  std::sort(centres.begin(), centres.end());
  return centres;
}

std::vector<Position> unweighted(std::vector<Position> centres) {
  for (Position& c : centres) c[0] /= lightness_weight, c[3] /= roughness_weight;
  return centres;
}

/// Sort every pixel: class 0 when darker than `dark_below`, else the nearest centre.
Raster<std::uint8_t> sorted_pixels(const Raster<Lab>& picture, const std::vector<Position>& centres,
                                   double dark_below) {
  Raster<std::uint8_t> classes(picture.rows, picture.cols);
  std::vector<Position> targets = centres;
  for (Position& t : targets) t = weighted(t);
  const int first = dark_below > 0 ? 1 : 0;
  std::transform(picture.data.begin(), picture.data.end(), classes.data.begin(), [&](Lab c) {
    if (c.l() < dark_below) return std::uint8_t{0};
    return static_cast<std::uint8_t>(nearest(targets, weighted(lab_of(c))) + first);
  });
  return classes;
}

// ---- drawings ----

using Tally = std::map<Position, double>;  ///< how often each colour occurs

double difference(const Position& a, const Position& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Take all within `reach` of the commonest colour out of the tally.   @return their mean and number.
WeightedPoint take_commonest(Tally& left, double reach) {
  const Position mode = std::max_element(left.begin(), left.end(), [](const auto& x, const auto& y) {
                          return x.second < y.second;
                        })->first;
  WeightedPoint taken{{}, 0};
  for (auto it = left.begin(); it != left.end();) {
    const auto& [at, count] = *it;
    if (difference(at, mode) > reach) {
      ++it;
      continue;
    }
    taken.weight += count;
    for (std::size_t d = 0; d < at.size(); ++d) taken.at[d] += count * at[d];
    it = left.erase(it);
  }
  for (double& sum : taken.at) sum /= taken.weight;
  return taken;
}

/// Share of the colours that lie within `reach` of a centre [-].
double share_near(const Tally& tally, const std::vector<Position>& centres, double reach) {
  double near = 0, all = 0;
  for (const auto& [at, count] : tally) {
    all += count;
    if (difference(at, centres[static_cast<std::size_t>(nearest(centres, at))]) <= reach) near += count;
  }
  return near / all;
}

/// Adds the commonest of what is much darker than the picture, where no centre is and it is more than specks.
/// @param whole  number of samples.
void add_dark(const Tally& all, double median, double whole, std::vector<Position>& centres) {
  constexpr double much_darker = 0.5, least_share = 1e-3;
  double pixels = 0;
  std::pair<double, Position> commonest{0, {}};
  for (const auto& [at, count] : all) {
    if (at[0] >= much_darker * median) continue;
    pixels += count;
    commonest = std::max(commonest, {count, at});
  }
  const bool is_there = std::any_of(centres.begin(), centres.end(),
                                    [&](const Position& c) { return c[0] < much_darker * median; });
  if (!is_there && pixels > least_share * whole) centres.push_back(commonest.second);
}

/// Colours that the samples keep to: the commonest one with all within `reach` of it, then the commonest of
/// the rest, and so on; then, of few dark pixels, the commonest: holes are small.
/// @return nothing when more than 12 would be needed, or when the samples do not crowd round them: a
/// photograph fills the space between.
std::optional<std::vector<Position>> flat_colours(const std::vector<Lab>& colours) {
  constexpr double reach = 5, least_share = 0.005;
  constexpr std::size_t most = 12;
  Tally all;
  for (const Lab c : colours) ++all[lab_of(c)];
  Tally left = all;
  std::vector<Position> centres;
  while (!left.empty() && centres.size() < most) {
    const WeightedPoint taken = take_commonest(left, reach);
    if (taken.weight < least_share * static_cast<double>(colours.size())) break;
    centres.push_back(taken.at);
  }
  add_dark(all, median_lightness(colours), static_cast<double>(colours.size()), centres);
  if (centres.size() < 2 || share_near(all, centres, reach) < 0.97 ||
      share_near(all, centres, reach / 2) < 0.9)
    return std::nullopt;
  return rising_lightness(centres);
}

// ---- cuts with a pink indicator ----

bool is_pink(Lab c) { return c.a() > 20 && c.b() < 0.35 * c.a() && c.b() > -0.6 * c.a(); }

bool has_indicator(const std::vector<Lab>& colours) {
  return static_cast<double>(std::count_if(colours.begin(), colours.end(), is_pink)) >
         0.1 * static_cast<double>(colours.size());
}

/// Tint a* that parts mortar from aggregate.
double tint_threshold(const std::vector<Lab>& colours) {
  Raster<double> tint(1, static_cast<int>(colours.size()));
  std::transform(colours.begin(), colours.end(), tint.data.begin(), [](Lab c) { return c.a(); });
  return otsu_thresholds(tint, 2).front();
}

/// @param dark  whether a class of dark pixels comes before the centres.
std::vector<std::string> indicator_phases(const std::vector<Position>& centres, double threshold, bool dark) {
  Position mortar{};
  double mortars = 0;
  for (const Position& c : centres)
    if (c[1] >= threshold) {
      for (std::size_t d = 0; d < mortar.size(); ++d) mortar[d] += c[d];
      ++mortars;
    }
  for (double& m : mortar) m /= mortars;
  std::vector<std::string> phases;
  if (dark) phases.emplace_back("void");
  for (const Position& c : centres) {
    const bool shaded = c[0] < mortar[0] - 4 && c[1] > 0.35 * mortar[1] && c[2] > mortar[2] + 3;
    phases.emplace_back(c[1] >= threshold ? "mortar" : shaded ? "void" : "aggregate");
  }
  return phases;
}

void set_dark_apart(ColourClasses& result, double darkest) {
  if (darkest <= 0) return;
  std::vector<Position> centres{{darkest / 2, 0, 0, 0}};
  centres.insert(centres.end(), result.centres.begin(), result.centres.end());
  result.centres = std::move(centres);
  result.dark = true;
}

std::vector<Lab> lighter_than(double lightness, const std::vector<Lab>& colours) {
  std::vector<Lab> lit;
  std::copy_if(colours.begin(), colours.end(), std::back_inserter(lit),
               [&](Lab c) { return c.l() >= lightness; });
  return lit;
}

/// Whether a colour lies on the way from one other to another, so that smooth edges between these show it.
bool lies_between(const std::vector<Position>& centres, std::size_t k) {
  constexpr double aside = 6;
  const Position& at = centres[k];
  for (std::size_t i = 0; i < centres.size(); ++i)
    for (std::size_t j = i + 1; j < centres.size(); ++j) {
      if (i == k || j == k) continue;
      const double way = difference(centres[i], centres[j]);
      const double detour = difference(centres[i], at) + difference(at, centres[j]) - way;
      // The detour of a triangle of base `way` whose tip stands aside by as much, over its middle.
      if (detour < std::hypot(way, 2 * aside) - way) return true;
    }
  return false;
}

/// Share of the pixels of each class that lie in the middle of 3 x 3 of it [-].
std::vector<double> core_shares(const Raster<std::uint8_t>& classes, std::size_t count) {
  std::vector<double> all(count, 0), core(count, 0);
  for (int r = 0; r < classes.rows; ++r)
    for (int c = 0; c < classes.cols; ++c) {
      const std::uint8_t mine = classes(r, c);
      ++all[mine];
      bool inside = true;
      for (int dr = -1; dr <= 1 && inside; ++dr)
        for (int dc = -1; dc <= 1 && inside; ++dc)
          inside = !classes.contains(r + dr, c + dc) || classes(r + dr, c + dc) == mine;
      core[mine] += inside;
    }
  for (std::size_t k = 0; k < count; ++k) core[k] = all[k] > 0 ? core[k] / all[k] : 0;
  return core;
}

/// The colours of regions, without those that only smooth edges between two of them show.
std::vector<Position> colours_of_regions(const Raster<Lab>& picture, std::vector<Position> centres) {
  constexpr double no_region = 0.1;
  while (centres.size() > 2) {
    const std::vector<double> core = core_shares(sorted_pixels(picture, centres, 0), centres.size());
    std::size_t worst = centres.size();
    for (std::size_t k = 0; k < centres.size(); ++k)
      if (core[k] < no_region && lies_between(centres, k) &&
          (worst == centres.size() || core[k] < core[worst]))
        worst = k;
    if (worst == centres.size()) break;
    centres.erase(centres.begin() + static_cast<std::ptrdiff_t>(worst));
  }
  return centres;
}

ColourClasses drawing_classes(const Raster<Lab>& picture, const std::vector<Position>& flat) {
  ColourClasses result;
  result.flat = true;
  result.centres = colours_of_regions(picture, flat);
  result.classes = sorted_pixels(picture, result.centres, 0);
  result.reason = "the picture is a drawing in " + std::to_string(result.centres.size()) + " colours";
  return result;
}

ColourClasses indicator_classes(const Raster<Lab>& picture, const std::vector<Lab>& lit, double dark_below) {
  constexpr int classes = 7;  // enough for the shaded mortar inside pores to be one of them
  ColourClasses result;
  result.centres = rising_lightness(unweighted(find_clusters(points_of(lit), classes).centres));
  result.classes = sorted_pixels(picture, result.centres, dark_below);
  result.phases = indicator_phases(result.centres, tint_threshold(lit), dark_below > 0);
  result.reason = "the mortar is pink from an indicator";
  return result;
}

/// 1 for each pixel that is lit and keeps off the dark ones, at whose rims blur mixes both; else 0.
Raster<double> well_lit(const Raster<Lab>& picture, double dark_below) {
  constexpr int lens = 3, of_side = 200;  // the median, too, draws the edges of holes inwards
  const int reach = lens + std::min(picture.rows, picture.cols) / of_side;
  Raster<double> lit(picture.rows, picture.cols);
  std::transform(picture.data.begin(), picture.data.end(), lit.data.begin(),
                 [&](Lab c) { return c.l() < dark_below ? 1.0 : 0.0; });
  lit = local_mean(lit, 2 * reach + 1);
  for (double& dark : lit.data) dark = dark > 0 ? 0 : 1;
  return lit;
}

/// A channel whose pixels that are not well lit have the mean of those within the window that are.
Raster<double> without_dark(Raster<double> channel, const Raster<double>& lit, int edge) {
  if (lit.empty()) return channel;
  Raster<double> kept = channel;
  for (std::size_t i = 0; i < kept.size(); ++i) kept.data[i] *= lit.data[i];
  const Raster<double> sum = local_mean(kept, edge), share = local_mean(lit, edge);
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (lit.data[i] == 0 && share.data[i] > 0) channel.data[i] = sum.data[i] / share.data[i];
  return channel;
}

template <class Value>
Raster<double> channel_without_dark(const Raster<Lab>& picture, const Raster<double>& lit, int edge,
                                    Value value) {
  Raster<double> channel(picture.rows, picture.cols);
  std::transform(picture.data.begin(), picture.data.end(), channel.data.begin(), value);
  return without_dark(std::move(channel), lit, 4 * edge + 1);
}

/// Lightness, tint and roughness round each pixel.
/// @param lit  as of well_lit(); empty: all of the picture is.   @param edge  of the squares [px].
Raster<Position> surroundings(const Raster<Lab>& picture, const Raster<Lab>& grainy,
                              const Raster<double>& lit, int edge) {
  const auto averaged = [&](auto value) {
    return local_mean(channel_without_dark(picture, lit, edge, value), edge);
  };
  const Raster<double> l = averaged([](Lab c) { return c.l(); });
  const Raster<double> a = averaged([](Lab c) { return c.a(); });
  const Raster<double> b = averaged([](Lab c) { return c.b(); });
  const Raster<double> rough =
      roughness(channel_without_dark(grainy, lit, edge, [](Lab c) { return c.l(); }), edge);
  Raster<Position> all(picture.rows, picture.cols);
  for (std::size_t i = 0; i < all.size(); ++i) all.data[i] = {l.data[i], a.data[i], b.data[i], rough.data[i]};
  return all;
}

/// How much of the difference of two classes there is from one side of their common boundary to the other, in
/// the mean over it [-]: about 1 at the edges of stones, little where light or moisture change slowly.
/// @param classes  0 and 1; 2 for what is left out.   @param edge  over which `all` was averaged [px].
double step_between(const Raster<Position>& all, const Raster<std::uint8_t>& classes,
                    const std::vector<Position>& centres, int edge) {
  Position way{};
  double length = 0;
  for (std::size_t d = 0; d < way.size(); ++d) {
    way[d] = centres[1][d] - centres[0][d];
    length += way[d] * way[d];
  }
  const auto along = [&](int r, int c) {
    const Position at = weighted(all(r, c));
    double sum = 0;
    for (std::size_t d = 0; d < way.size(); ++d) sum += way[d] * at[d];
    return sum / length;
  };
  double steps = 0, count = 0;
  for (int r = 0; r < classes.rows; ++r)
    for (int c = 0; c < classes.cols; ++c)
      for (const auto& [dr, dc] : {std::pair(0, 1), std::pair(1, 0)}) {
        const int r0 = r - edge * dr, c0 = c - edge * dc, r1 = r + (edge + 1) * dr, c1 = c + (edge + 1) * dc;
        if (!classes.contains(r0, c0) || !classes.contains(r1, c1)) continue;
        const std::uint8_t mine = classes(r, c), other = classes(r + dr, c + dc);
        if (mine == other || mine == 2 || other == 2 || classes(r0, c0) == 2 || classes(r1, c1) == 2)
          continue;
        steps += (along(r1, c1) - along(r0, c0)) * (mine < other ? 1 : -1);
        ++count;
      }
  return count > 0 ? steps / count : 1;
}

/// Nothing but mortar, and holes where there are any.
ColourClasses one_class(const Raster<Lab>& picture, const Position& centre, double dark_below) {
  ColourClasses result;
  result.centres = {centre};
  result.classes = sorted_pixels(picture, result.centres, dark_below);
  if (dark_below > 0) result.phases.emplace_back("void");
  result.phases.emplace_back("mortar");
  result.reason = "what is light and what is darker part at no edges: they are one phase";
  return result;
}

/// Holes and their rims must not be one of the two classes: they would leave stones and mortar the other.
ColourClasses textured_classes(const Raster<Lab>& picture, const Raster<Lab>& grainy, double dark_below) {
  constexpr int count = 2;
  constexpr std::uint8_t none = count;
  constexpr double least_step = 0.5;
  const int edge = 2 * static_cast<int>(0.01 * std::min(picture.rows, picture.cols)) + 1;
  const Raster<double> lit = dark_below > 0 ? well_lit(picture, dark_below) : Raster<double>();
  const Raster<Position> all = surroundings(picture, grainy, lit, edge);
  const std::vector<Position> places = sample(all);
  const std::vector<double> weights = lit.empty() ? std::vector<double>(places.size(), 1) : sample(lit);
  std::vector<WeightedPoint> points;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (weights[i] > 0) points.push_back({weighted(places[i]), 1});
  if (points.empty())  // holes everywhere
    for (const Position& at : places) points.push_back({weighted(at), 1});
  const std::vector<Position> centres = rising_lightness(find_clusters(points, count).centres);
  ColourClasses result;
  result.classes = Raster<std::uint8_t>(picture.rows, picture.cols, none);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (picture.data[i].l() >= dark_below)
      result.classes.data[i] = static_cast<std::uint8_t>(nearest(centres, weighted(all.data[i])));
  if (centres.size() == count && step_between(all, result.classes, centres, edge) < least_step)
    return one_class(picture, unweighted(find_clusters(points, 1).centres).front(), dark_below);
  if (dark_below > 0)
    for (std::uint8_t& k : result.classes.data) k = k == none ? 0 : static_cast<std::uint8_t>(k + 1);
  result.centres = unweighted(centres);
  result.reason = "sorted by tint, lightness and roughness";
  return result;
}

}  // namespace

ColourClasses colour_classes(const Raster<Lab>& picture, int count) {
  ColourClasses result;
  const Clusters clusters = find_clusters(points_of(sample(picture)), count);
  result.centres = rising_lightness(unweighted(clusters.centres));
  result.classes = sorted_pixels(picture, result.centres, 0);
  return result;
}

ColourClasses automatic_classes(const Raster<Lab>& picture, const Raster<Lab>& grainy, bool has_black) {
  const std::vector<Lab> colours = sample(picture);
  if (const auto flat = flat_colours(colours)) return drawing_classes(picture, *flat);
  double dark_below = 0.5 * median_lightness(colours);
  std::vector<Lab> lit = lighter_than(dark_below, colours);
  const double dark = 1 - static_cast<double>(lit.size()) / static_cast<double>(colours.size());
  constexpr double most_holes = 0.12;
  if (dark < 1e-3 || (!has_black && dark > most_holes)) {
    dark_below = 0;  // nothing swallows the light
    lit = colours;
  }
  ColourClasses result = has_indicator(lit) ? indicator_classes(picture, lit, dark_below)
                                            : textured_classes(picture, grainy, dark_below);
  set_dark_apart(result, dark_below);
  return result;
}

}  // namespace specimen
