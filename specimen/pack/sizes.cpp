#include "specimen/pack/sizes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "specimen/body/error.hpp"
#include "specimen/body/plane.hpp"
#include "specimen/body/wording.hpp"

namespace specimen {
namespace {

double disc_area(double diameter) { return std::numbers::pi / 4 * diameter * diameter; }

double total_area(const std::vector<double>& diameters) {
  double sum = 0;
  for (const double d : diameters) sum += disc_area(d);
  return sum;
}

// Area spread evenly over the diameter means numbers that fall with its square.
double draw_diameter(const SizeClass& size, Random& random) {
  return size.d_min * size.d_max / (size.d_max - random.uniform() * (size.d_max - size.d_min));
}

std::vector<double> draw_by_class(const Grading& grading, double area, Random& random) {
  std::vector<double> diameters;
  double drawn = 0, due = 0;
  for (const SizeClass& size : grading) {
    due += size.share * area;
    while (drawn < due) {
      const double d = draw_diameter(size, random);
      if (drawn + disc_area(d) / 2 > due) break;
      diameters.push_back(d);
      drawn += disc_area(d);
    }
  }
  return diameters;
}

double area_when_scaled(const std::vector<double>& diameters, double factor, double low, double high) {
  double sum = 0;
  for (const double d : diameters) sum += disc_area(std::clamp(d * factor, low, high));
  return sum;
}

// All sizes times one factor near 1, kept between `low` and `high`, so that their area is met.
void scale_within(std::vector<double>& diameters, double area, double low, double high) {
  double small = low / high, large = high / low;
  for (int n = 0; n < 100; ++n) {
    const double factor = (small + large) / 2;
    (area_when_scaled(diameters, factor, low, high) < area ? small : large) = factor;
  }
  for (double& d : diameters) d = std::clamp(d * large, low, high);
}

[[noreturn]] void refuse_area(double area, double d_min, double d_max) {
  const std::string sizes = millimetres(d_min) + " to " + millimetres(d_max);
  const std::string wanted = number(area * 1e6) + " mm^2 of aggregate";
  if (area < disc_area(d_min)) {
    throw Error("generate.fraction", wanted,
                "must be at least one aggregate of " + millimetres(d_min) + ", " +
                    number(disc_area(d_min) * 1e6) + " mm^2",
                "raise the fraction or lower d_min");
  }
  throw Error("generate.fraction", wanted, "no whole number of aggregates of " + sizes + " has that area",
              "widen the range of sizes or change the fraction");
}

}  // namespace

void check(const Grading& grading) {
  if (grading.empty())
    throw Error("generate.grading", "no size class", "must have at least one", "add d_min, d_max and share");
  double sum = 0, above = infinite;
  for (const SizeClass& size : grading) {
    const std::string range = millimetres(size.d_min) + " to " + millimetres(size.d_max);
    if (!(size.d_min > 0) || !(size.d_max >= size.d_min) || !std::isfinite(size.d_max))
      throw Error("generate.grading", range, "a class must have 0 < d_min <= d_max");
    if (!(size.d_max <= above * (1 + 1e-9)))
      throw Error("generate.grading", range, "classes must be in falling order and must not overlap");
    if (!(size.share >= 0))
      throw Error("generate.grading", "share " + number(size.share) + " of " + range, "must be >= 0");
    sum += size.share;
    above = size.d_min;
  }
  if (!(std::abs(sum - 1) < 1e-6))
    throw Error("generate.grading", "shares that add up to " + number(sum), "must add up to 1");
}

double expected_count(const Grading& grading, double area) {
  double count = 0;
  for (const SizeClass& size : grading)
    count += size.share * area / (std::numbers::pi / 4 * size.d_min * size.d_max);
  return count;
}

std::vector<double> draw_sizes(const Grading& grading, double area, Random& random) {
  std::vector<double> diameters = draw_by_class(grading, area, random);
  const double d_max = grading.front().d_max, d_min = grading.back().d_min;
  const auto largest = [&] { return static_cast<double>(diameters.size()) * disc_area(d_max); };
  const auto smallest = [&] { return static_cast<double>(diameters.size()) * disc_area(d_min); };
  while (!diameters.empty() && smallest() > area) diameters.pop_back();
  while (largest() < area) diameters.push_back(draw_diameter(grading.back(), random));

  const bool one_less_is_nearer = smallest() - area > disc_area(d_min) / 2;
  if (one_less_is_nearer && diameters.size() > 1) diameters.pop_back();

  if (smallest() <= area && area <= largest()) {
    scale_within(diameters, area, d_min, d_max);
  } else {
    // Classes so narrow that whole numbers of aggregates leave gaps between the areas they can have: half
    // an aggregate among many may be spread over all of them.
    constexpr double unnoticed = 0.05;
    const double factor = std::sqrt(area / total_area(diameters));
    if (!(std::abs(factor - 1) < unnoticed)) refuse_area(area, d_min, d_max);
    for (double& d : diameters) d *= factor;
  }
  std::sort(diameters.begin(), diameters.end(), std::greater<>());
  return diameters;
}

}  // namespace specimen
