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

/// Colours that the samples keep to: the commonest one with all within `reach` of it, then the commonest of
/// the rest, and so on.
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

ColourClasses drawing_classes(const Raster<Lab>& picture, const std::vector<Position>& flat) {
  ColourClasses result;
  result.flat = true;
  result.centres = flat;
  result.classes = sorted_pixels(picture, result.centres, 0);
  result.reason = "the picture is a drawing in " + std::to_string(flat.size()) + " colours";
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

template <class Value>
Raster<double> averaged(const Raster<Lab>& picture, int edge, Value value) {
  Raster<double> channel(picture.rows, picture.cols);
  std::transform(picture.data.begin(), picture.data.end(), channel.data.begin(), value);
  return local_mean(channel, edge);
}

/// Lightness, tint and roughness round each pixel.
Raster<Position> surroundings(const Raster<Lab>& picture, const Raster<Lab>& grainy) {
  const int edge = 2 * static_cast<int>(0.01 * std::min(picture.rows, picture.cols)) + 1;
  const Raster<double> l = averaged(picture, edge, [](Lab c) { return c.l(); });
  const Raster<double> a = averaged(picture, edge, [](Lab c) { return c.a(); });
  const Raster<double> b = averaged(picture, edge, [](Lab c) { return c.b(); });
  Raster<double> lightness(grainy.rows, grainy.cols);
  std::transform(grainy.data.begin(), grainy.data.end(), lightness.data.begin(), [](Lab c) { return c.l(); });
  const Raster<double> rough = roughness(lightness, edge);
  Raster<Position> all(picture.rows, picture.cols);
  for (std::size_t i = 0; i < all.size(); ++i) all.data[i] = {l.data[i], a.data[i], b.data[i], rough.data[i]};
  return all;
}

ColourClasses textured_classes(const Raster<Lab>& picture, const Raster<Lab>& grainy, double dark_below) {
  constexpr int classes = 2;
  const Raster<Position> all = surroundings(picture, grainy);
  std::vector<WeightedPoint> points;
  for (const Position& at : sample(all)) points.push_back({weighted(at), 1});
  ColourClasses result;
  const std::vector<Position> centres = rising_lightness(find_clusters(points, classes).centres);
  result.centres = unweighted(centres);
  result.classes = Raster<std::uint8_t>(picture.rows, picture.cols);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (picture.data[i].l() >= dark_below)
      result.classes.data[i] =
          static_cast<std::uint8_t>(nearest(centres, weighted(all.data[i])) + (dark_below > 0 ? 1 : 0));
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
