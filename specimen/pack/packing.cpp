#include "specimen/pack/packing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "specimen/body/error.hpp"
#include "specimen/pack/grading.hpp"
#include "specimen/pack/relaxation.hpp"

namespace specimen {
namespace {

constexpr double least_aspect = 0.02, most_fraction = 0.9, most_aggregates = 2e6;

void check_length(const char* field, double value) {
  if (!(value > 0) || !std::isfinite(value))
    throw Error(field, millimetres(value), "must be > 0", "give it with its unit, e.g. \"150 mm\"");
}

void check_aspects(const PackingOptions& options) {
  if (!(options.aspect_min >= least_aspect && options.aspect_min <= 1)) {
    throw Error("generate.aspect_min", number(options.aspect_min),
                "must be between " + number(least_aspect) + " and 1", "1 makes circles");
  }
  if (!(options.aspect_max >= options.aspect_min && options.aspect_max <= 1)) {
    throw Error("generate.aspect_max", number(options.aspect_max),
                "must be between aspect_min, which is " + number(options.aspect_min) + ", and 1");
  }
}

// With half the gap round each, the ellipses still do not overlap, and all of them lie in a room that is
// smaller by half the gap on all sides. Steiner: the collar adds perimeter * gap / 2 + pi gap^2 / 4.
double fraction_with_gaps(const std::vector<Ellipse>& ellipses, const PackingOptions& options) {
  double sum = 0;
  for (const Ellipse& e : ellipses) {
    sum += area(e) + perimeter(e) * options.gap / 2 + std::numbers::pi / 4 * options.gap * options.gap;
  }
  return sum / ((options.width - options.gap) * (options.height - options.gap));
}

double fraction_of(const std::vector<Ellipse>& ellipses, const PackingOptions& options) {
  double sum = 0;
  for (const Ellipse& e : ellipses) sum += area(e);
  return sum / (options.width * options.height);
}

void check_sizes(const PackingOptions& options) {
  check(options.grading);
  const double d_max = options.grading.front().d_max, side = std::min(options.width, options.height);
  if (d_max + 2 * options.gap > side) {
    throw Error("generate.d_max", millimetres(d_max),
                "must leave the gap of " + millimetres(options.gap) + " to both walls of a specimen of " +
                    millimetres(side),
                "lower d_max or take a larger specimen");
  }
  const double count = expected_count(options.grading, options.fraction * options.width * options.height);
  if (count > most_aggregates) {
    throw Error("generate.d_min", millimetres(options.grading.back().d_min),
                "makes " + number(count) + " aggregates; at most " + number(most_aggregates) + " are allowed",
                "raise d_min or take a smaller specimen");
  }
}

void check_fraction(const PackingOptions& options) {
  if (!(options.fraction >= 0 && options.fraction <= most_fraction)) {
    throw Error("generate.fraction", percent(options.fraction),
                "must be between 0 and " + percent(most_fraction), "0 makes plain mortar");
  }
}

void check_gap(const PackingOptions& options) {
  if (!(options.gap >= 0) || !std::isfinite(options.gap))
    throw Error("generate.gap", millimetres(options.gap), "must be >= 0");
}

// Ellipses of these diameters [m] with random aspect and direction, not yet anywhere.
std::vector<Ellipse> shape(const std::vector<double>& diameters, const PackingOptions& options,
                           Random& random) {
  std::vector<Ellipse> ellipses;
  ellipses.reserve(diameters.size());
  for (const double d : diameters) {
    const double root = std::sqrt(random.uniform(options.aspect_min, options.aspect_max));
    ellipses.push_back({0, 0, d / 2 / root, d / 2 * root, 0});
  }
  return ellipses;
}

[[noreturn]] void refuse_size(const Ellipse& e, const PackingOptions& options) {
  throw Error("generate.d_max", millimetres(options.grading.front().d_max),
              "an aggregate of " + millimetres(2 * e.a) + " x " + millimetres(2 * e.b) +
                  " does not fit between the walls in any direction that was tried",
              "lower d_max, raise aspect_min or take a larger specimen");
}

// Ellipses that are to fill a fraction, not yet anywhere.
std::vector<Ellipse> draw_ellipses_to_fill(const PackingOptions& options, Random& random) {
  const double target = options.fraction * options.width * options.height;
  return shape(draw_sizes(options.grading, target, random), options, random);
}

// Empty when there is no room for the fraction.
std::optional<Packing> try_to_pack(const PackingOptions& options) {
  Random random(options.seed);
  const Room room{options.width, options.height, options.gap};
  Packing packing{draw_ellipses_to_fill(options, random), 0, false};
  if (fraction_with_gaps(packing.ellipses, options) > 1) return std::nullopt;
  const Settlement settlement = settle(packing.ellipses, room, Turning::free, random);
  if (settlement.too_large) refuse_size(packing.ellipses[*settlement.too_large], options);
  if (!settlement.solved) return std::nullopt;
  packing.relaxed = settlement.relaxed;
  packing.fraction = fraction_of(packing.ellipses, options);
  return packing;
}

// A part of the specimen with so many aggregates that it tells for the whole, and no more.
PackingOptions representative(PackingOptions options) {
  constexpr double enough = 1000;
  const double count = expected_count(options.grading, options.fraction * options.width * options.height);
  const double shrink = std::sqrt(std::min(1.0, enough / count));
  const double least_side = 4 * (options.grading.front().d_max + options.gap);
  options.width = std::min(options.width, std::max(options.width * shrink, least_side));
  options.height = std::min(options.height, std::max(options.height * shrink, least_side));
  return options;
}

// Largest fraction found that the same options and seed can fill.
double fraction_within_reach(const PackingOptions& wanted) {
  PackingOptions options = representative(wanted);
  double reached = 0, beyond = wanted.fraction;
  for (int n = 0; n < 4; ++n) {
    options.fraction = n == 0 ? 0.75 * beyond : (reached + beyond) / 2;
    try {
      (try_to_pack(options) ? reached : beyond) = options.fraction;
    } catch (const Error&) {  // so small a fraction that the sizes cannot make it up
      break;
    }
  }
  return reached;
}

[[noreturn]] void refuse_fraction(const PackingOptions& options) {
  Random random(options.seed);
  const std::vector<Ellipse> wanted = draw_ellipses_to_fill(options, random);
  const double with_gaps = fraction_with_gaps(wanted, options);
  std::string limit = "reached about " + percent(std::round(1000 * fraction_within_reach(options)) / 1000) +
                      " with aggregates of " + millimetres(options.grading.back().d_min) + " to " +
                      millimetres(options.grading.front().d_max);
  if (options.gap > 0) {
    limit += "; with the gap of " + millimetres(options.gap) + " round them they need " + percent(with_gaps) +
             " of the specimen";
  }
  // Small aggregates fill the holes between large ones, until the gap round them costs more than they fill.
  constexpr double costly_gap = 0.08;
  const bool gap_limits = with_gaps - options.fraction > costly_gap;
  throw Error("generate.fraction", percent(options.fraction), limit,
              gap_limits ? "lower the fraction or the gap, or raise d_min"
                         : "lower the fraction, or widen the range of sizes (lower d_min or raise d_max)");
}

}  // namespace

std::vector<Error> faults(const PackingOptions& options) {
  std::vector<Error> found;
  const auto look = [&](auto check) {
    try {
      check();
    } catch (const Error& fault) {
      found.push_back(fault);
    }
  };
  look([&] { check_length("generate.width", options.width); });
  look([&] { check_length("generate.height", options.height); });
  look([&] { check_fraction(options); });
  look([&] { check_gap(options); });
  look([&] { check_aspects(options); });
  if (found.empty()) look([&] { check_sizes(options); });  // which go by the others
  return found;
}

Packing pack(const PackingOptions& options) {
  if (const std::vector<Error> found = faults(options); !found.empty()) throw Error(found.front());
  if (options.fraction == 0) return {};
  std::optional<Packing> packing = try_to_pack(options);
  if (!packing) refuse_fraction(options);
  return *packing;
}

}  // namespace specimen
