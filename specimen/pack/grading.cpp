#include "specimen/pack/grading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "specimen/body/error.hpp"
#include "specimen/body/mask.hpp"

namespace specimen {
namespace {

// Share of the aggregate that passes a sieve; straight lines between the sieves.
struct Sieve {
  double diameter;  // [m]
  double passing;   // [-]
};
using Curve = std::vector<Sieve>;

struct NamedCurve {
  std::string_view name;
  std::array<double, 8> passing;  // [%] at the sieves of DIN 1045-2
};
constexpr std::array<double, 8> din_sieves{0.25e-3, 0.5e-3, 1e-3, 2e-3, 4e-3, 8e-3, 16e-3, 31.5e-3};
constexpr std::array<NamedCurve, 9> din_curves{{
    {"A8", {5, 14, 21, 36, 61, 100, 100, 100}},
    {"B8", {11, 26, 42, 57, 74, 100, 100, 100}},
    {"C8", {21, 39, 57, 71, 85, 100, 100, 100}},
    {"A16", {3, 8, 12, 21, 36, 60, 100, 100}},
    {"B16", {8, 20, 32, 42, 56, 76, 100, 100}},
    {"C16", {18, 34, 49, 62, 74, 88, 100, 100}},
    {"A32", {2, 5, 8, 14, 23, 38, 62, 100}},
    {"B32", {8, 18, 28, 37, 47, 62, 80, 100}},
    {"C32", {15, 29, 42, 53, 65, 77, 89, 100}},
}};

// The R10 sieves of ISO 565: ten to a decade.
constexpr std::array<double, 10> r10{1, 1.25, 1.6, 2, 2.5, 3.15, 4, 5, 6.3, 8};
constexpr std::array<double, 7> decades{1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1};  // [m]

// With the two ends.
std::vector<double> r10_sieves(double d_min, double d_max) {
  std::vector<double> sieves{d_min};
  for (const double decade : decades) {
    for (const double mantissa : r10) {
      const double sieve = mantissa * decade;
      if (sieve > d_min * 1.001 && sieve < d_max * 0.999) sieves.push_back(sieve);
    }
  }
  sieves.push_back(d_max);
  return sieves;
}

double passing(const Curve& curve, double diameter) {
  if (diameter <= curve.front().diameter) return curve.front().passing;
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const Sieve &low = curve[i - 1], &high = curve[i];
    if (diameter <= high.diameter) {
      return low.passing +
             (high.passing - low.passing) * (diameter - low.diameter) / (high.diameter - low.diameter);
    }
  }
  return curve.back().passing;
}

// Fuller's parabola (d / d_max)^0.5 at the R10 sieves.
Curve fuller(double d_min, double d_max) {
  Curve curve;
  for (const double d : r10_sieves(d_min, d_max)) curve.push_back({d, std::sqrt(d / d_max)});
  return curve;
}

Curve din(const NamedCurve& named) {
  Curve curve;
  for (std::size_t i = 0; i < din_sieves.size(); ++i) {
    curve.push_back({din_sieves[i], named.passing[i] / 100});
    if (named.passing[i] == 100) break;
  }
  return curve;
}

// Area share below d in a plane cut through spheres that follow Fuller's curve, x = d / d_max. Source:
// Walraven (1980). He cut a series short: the integral of `passing_in_cut` differs by up to 0.012.
double walraven_of_fuller(double x) {
  const double x2 = x * x, x4 = x2 * x2;
  return 1.065 * std::sqrt(x) - x4 * (0.053 + x2 * (0.012 + x2 * (0.0045 - x2 * 0.0025)));
}

// The same for any curve. A cut at the distance z from the centre of a sphere of radius R shows a circle of
// the area pi (R^2 - z^2), every z is equally likely, so of the area cut from one sphere 1 - (3 t - t^3) / 2
// lies in circles below d, t^2 = 1 - (d / 2R)^2.
double passing_in_cut(const Curve& curve, double d) {
  constexpr int steps = 64;
  double share = passing(curve, d);
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const double low = std::max(curve[i - 1].diameter, d), high = curve[i].diameter;
    if (low >= high) continue;
    const double per_metre = (curve[i].passing - curve[i - 1].passing) / (high - curve[i - 1].diameter);
    for (int k = 0; k < steps; ++k) {  // d_sphere = low + (high - low) s^2 takes the root at low away
      const double s = (k + 0.5) / steps, sphere = low + (high - low) * s * s;
      const double t = std::sqrt(std::max(0.0, 1 - (d / sphere) * (d / sphere)));
      share += per_metre * (1 - t * (3 - t * t) / 2) * 2 * s * (high - low) / steps;
    }
  }
  return share;
}

Curve curve_of(std::string_view name, double d_min, double d_max) {
  if (name == "fuller") return fuller(d_min, d_max);
  for (const NamedCurve& named : din_curves) {
    if (named.name == name) return din(named);
  }
  const std::string nearest = nearest_name(name, grading_names());
  throw Error("generate.grading", std::string(name), "must be one of " + listed(grading_names()),
              nearest.empty() ? "" : "did you mean \"" + nearest + "\"?");
}

void check_range(std::string_view name, double d_min, double d_max, const Curve& curve) {
  if (d_min < curve.front().diameter) {
    throw Error("generate.d_min", millimetres(d_min),
                "must be at least " + millimetres(curve.front().diameter) + ", where the curve " +
                    std::string(name) + " begins",
                "raise d_min or use the grading fuller");
  }
  if (d_min >= curve.back().diameter) {
    throw Error("generate.d_min", millimetres(d_min),
                "must be below " + millimetres(curve.back().diameter) +
                    ", the largest aggregate of the curve " + std::string(name),
                "lower d_min or choose a coarser grading");
  }
  if (passing(curve, d_max) <= passing(curve, d_min)) {
    throw Error("generate.d_max", millimetres(d_max), "no aggregate between d_min and d_max",
                "widen the range of sizes");
  }
}

}  // namespace

Grading named_grading(std::string_view name, double d_min, double d_max, bool walraven) {
  if (!(d_min > 0) || !std::isfinite(d_min))
    throw Error("generate.d_min", millimetres(d_min), "must be > 0",
                "give the size of the smallest aggregate");
  if (!(d_max > d_min) || !std::isfinite(d_max)) {
    throw Error("generate.d_max", millimetres(d_max), "must be above d_min, which is " + millimetres(d_min),
                "swap them or widen the range");
  }
  const Curve curve = curve_of(name, d_min, d_max);
  check_range(name, d_min, d_max, curve);

  std::vector<double> limits{d_min};
  for (const Sieve& sieve : curve) {
    if (sieve.diameter > d_min * 1.001 && sieve.diameter < d_max * 0.999) limits.push_back(sieve.diameter);
  }
  limits.push_back(std::min(d_max, curve.back().diameter));
  if (limits.back() <= limits[limits.size() - 2]) limits.pop_back();

  const auto below = [&](double d) {
    if (!walraven) return passing(curve, d);
    return name == "fuller" ? walraven_of_fuller(d / d_max) : passing_in_cut(curve, d);
  };
  const double least = below(limits.front()), whole = below(limits.back()) - least;
  Grading grading;
  for (std::size_t i = limits.size() - 1; i > 0; --i) {
    const double share = (below(limits[i]) - below(limits[i - 1])) / whole;
    if (share > 0) grading.push_back({limits[i - 1], limits[i], share});
  }
  return grading;
}

std::vector<std::string> grading_names() {
  std::vector<std::string> names{"fuller"};
  for (const NamedCurve& named : din_curves) names.emplace_back(named.name);
  return names;
}

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
