#include "specimen/describe/twin.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "specimen/body/error.hpp"
#include "specimen/pack/canvas.hpp"
#include "specimen/pack/relaxation.hpp"

namespace specimen {
namespace {

constexpr double most_fraction = 0.9;  // no packing of ellipses comes near
constexpr double least_aspect = 0.02;  // of the gap test
constexpr double most_aggregates = 2e6;
constexpr double least_factor = 0.7;  // of the last scaling: half an aggregate in place of one
constexpr int strata = 10;

// Aggregates of one stratum of area and how often each is drawn.
class Stratum {
 public:
  void add(const SampledAggregate& aggregate, double area_inside) {
    members_.push_back(&aggregate);
    numbers_ += area_inside / aggregate.area();
    up_to_.push_back(numbers_);
  }
  [[nodiscard]] const SampledAggregate& draw(Random& random) const {
    const double at = random.uniform() * numbers_;
    const auto found = std::upper_bound(up_to_.begin(), up_to_.end(), at);
    const auto last = static_cast<std::ptrdiff_t>(members_.size()) - 1;
    return *members_[static_cast<std::size_t>(std::min(found - up_to_.begin(), last))];
  }
  [[nodiscard]] bool empty() const { return members_.empty(); }

 private:
  std::vector<const SampledAggregate*> members_;
  std::vector<double> up_to_;
  double numbers_ = 0;
};

// The sample, largest first, cut into strata of equal area; an aggregate at a limit is in both, in parts.
std::vector<Stratum> stratify(const AggregateSample& sample) {
  double whole = 0, before = 0;
  for (const SampledAggregate& one : sample.aggregates) whole += one.weighted_area();
  std::vector<Stratum> all(strata);
  for (const SampledAggregate& one : sample.aggregates) {
    const double after = before + one.weighted_area();
    for (int k = 0; k < strata; ++k) {
      const double from = whole * k / strata, to = whole * (k + 1) / strata;
      const double inside = std::min(after, to) - std::max(before, from);
      if (inside > 0) all[static_cast<std::size_t>(k)].add(one, inside);
    }
    before = after;
  }
  return all;
}

[[noreturn]] void refuse_area(double area, const SampledAggregate& one) {
  throw Error("twin", number(area * 1e6) + " mm^2 of aggregate",
              "holds not even one of " + millimetres(one.diameter), "take a larger twin");
}

std::vector<SampledAggregate> draw_aggregates(const AggregateSample& sample, double area, Random& random) {
  const std::vector<Stratum> all = stratify(sample);
  std::vector<SampledAggregate> drawn;
  double sum = 0;
  for (int k = 0; k < strata; ++k) {
    const Stratum& stratum = all[static_cast<std::size_t>(k)];
    const double due = area * (k + 1) / strata;
    while (sum < due && !stratum.empty()) {
      const SampledAggregate& one = stratum.draw(random);
      if (sum + one.area() / 2 > due) break;
      drawn.push_back(one);
      sum += one.area();
    }
  }
  if (drawn.empty()) {
    drawn.push_back(all[strata / 2].draw(random));
    sum = drawn.back().area();
  }
  const double factor = std::sqrt(area / sum);
  if (factor < least_factor) refuse_area(area, drawn.back());
  for (SampledAggregate& one : drawn) one.diameter *= factor;
  std::stable_sort(drawn.begin(), drawn.end(),
                   [](const auto& p, const auto& q) { return p.diameter > q.diameter; });
  return drawn;
}

std::vector<Ellipse> ellipses_of(const std::vector<SampledAggregate>& aggregates) {
  std::vector<Ellipse> ellipses;
  for (const SampledAggregate& one : aggregates) {
    const double root = std::sqrt(std::clamp(one.aspect, least_aspect, 1.0));
    ellipses.push_back({0, 0, one.diameter / 2 / root, one.diameter / 2 * root, one.angle});
  }
  return ellipses;
}

// What is seen of a periodic packing in its room.
std::vector<Ellipse> with_repeats(const std::vector<Ellipse>& ellipses, const Room& room) {
  std::vector<Ellipse> all;
  for (const Ellipse& e : ellipses) {
    const Point half = half_extent(e);
    for (const Point shift : repeats(room)) {
      Ellipse repeated = e;
      repeated.x += shift.x;
      repeated.y += shift.y;
      if (repeated.x + half.x > 0 && repeated.x - half.x < room.width && repeated.y + half.y > 0 &&
          repeated.y - half.y < room.height)
        all.push_back(repeated);
    }
  }
  return all;
}

int count_lost(const std::vector<Ellipse>& ellipses, double pixel_size) {
  return static_cast<int>(std::count_if(ellipses.begin(), ellipses.end(), [&](const Ellipse& e) {
    if (e.b > pixel_size) return false;
    const Point half = half_extent(e);
    const auto pixel = [&](double at) { return std::floor(at / pixel_size); };
    for (double row = pixel(e.y - half.y); row <= pixel(e.y + half.y); ++row)
      for (double col = pixel(e.x - half.x); col <= pixel(e.x + half.x); ++col)
        if (contains(e, {(col + 0.5) * pixel_size, (row + 0.5) * pixel_size})) return false;
    return true;
  }));
}

std::string size_text(const TwinPlan& plan) {
  return number(plan.width * 1e3) + " x " + millimetres(plan.height);
}

[[noreturn]] void refuse_size(const Ellipse& e, const TwinPlan& plan) {
  throw Error("twin", "an aggregate of " + millimetres(2 * e.a) + " x " + millimetres(2 * e.b),
              "does not fit into " + size_text(plan) + " with a gap of " + millimetres(plan.gap),
              "take a larger twin");
}

[[noreturn]] void refuse_fraction(const TwinPlan& plan) {
  throw Error("twin",
              "aggregates of the sizes of the original that fill " + percent(plan.fraction) + " of " +
                  size_text(plan),
              "could not be packed with a gap of " + millimetres(plan.gap),
              plan.gap > 0 ? "lower the gap" : "take a larger twin, or drop the smallest aggregates");
}

// In a periodic room an ellipse meets itself; so do the walls with too long an ellipse.
bool all_fit(const std::vector<Ellipse>& ellipses, const TwinPlan& plan) {
  const double side = std::min(plan.width, plan.height);
  for (const Ellipse& e : ellipses) {
    if (2 * e.a > side && plan.cut) refuse_size(e, plan);
    if (2 * e.a + plan.gap > side && plan.cut) return false;
  }
  return true;
}

std::optional<Twin> try_to_draw(const TwinPlan& plan, const Room& room, Random& random) {
  const double area = plan.fraction * plan.width * plan.height;
  std::vector<Ellipse> ellipses = ellipses_of(draw_aggregates(plan.sample, area, random));
  if (!all_fit(ellipses, plan)) return std::nullopt;
  const Turning turning = plan.oriented ? Turning::fixed : Turning::free;
  const Settlement settlement = settle(ellipses, room, turning, random);
  if (settlement.too_large) refuse_size(ellipses[*settlement.too_large], plan);
  if (!settlement.solved) return std::nullopt;
  return Twin{draw_window(with_repeats(ellipses, room), plan.width, plan.height, plan.pixel_size),
              settlement.relaxed, count_lost(ellipses, plan.pixel_size)};
}

std::optional<Twin> try_often_to_draw(const TwinPlan& plan, std::uint64_t seed) {
  constexpr int most_tries = 3;
  Random random(seed);
  const Room room{plan.width, plan.height, plan.gap, plan.cut};
  for (int tries = 0; tries < most_tries; ++tries)
    if (std::optional<Twin> twin = try_to_draw(plan, room, random)) return twin;
  return std::nullopt;
}

void halve_gap_until_it_can_be_kept(TwinPlan& plan) {
  constexpr std::uint64_t probe = 0;
  while (plan.gap > 0 && !try_often_to_draw(plan, probe))
    plan.gap = plan.gap > plan.pixel_size / 2 ? plan.gap / 2 : 0;
}

// As asked for, or as the original, to whole pixels.
double side_of(double asked, double original, double pixel_size) {
  return asked > 0 ? asked : std::max(1.0, std::round(original / pixel_size)) * pixel_size;
}

void check_original(const Descriptors& original) {
  if (original.sample.aggregates.empty()) {
    throw Error("original", "no aggregate", "twins need aggregates to match",
                "check how the phases are separated");
  }
  if (original.fraction > most_fraction) {
    throw Error("original", percent(original.fraction) + " of aggregate",
                "must be at most " + percent(most_fraction), "check how the phases are separated");
  }
}

void check_count(const TwinPlan& plan) {
  double area = 0, numbers = 0;
  for (const SampledAggregate& one : plan.sample.aggregates) {
    area += one.weighted_area();
    numbers += one.weight;
  }
  const double count = numbers / area * plan.fraction * plan.width * plan.height;
  if (count > most_aggregates)
    throw Error("twin", number(count) + " aggregates", "at most " + number(most_aggregates) + " are allowed",
                "take a smaller twin");
}

}  // namespace

double usual_gap(const Descriptors& original) {
  if (original.gaps.empty()) return 0;
  return original.gaps[original.gaps.size() / 20];
}

TwinPlan plan_twins(const Descriptors& original, const TwinOptions& options) {
  check_original(original);
  TwinPlan plan;
  plan.pixel_size = options.pixel_size > 0 ? options.pixel_size : original.pixel_size;
  plan.width = side_of(options.width, original.width, plan.pixel_size);
  plan.height = side_of(options.height, original.height, plan.pixel_size);
  (void)canvas_of(plan.width, plan.height, plan.pixel_size, "twin");
  plan.fraction = original.fraction;
  plan.gap = options.gap < 0 ? usual_gap(original) : options.gap;
  plan.cut = options.border == Border::automatic ? original.sample.cut > 0 : options.border == Border::cut;
  plan.oriented = original.orientation.probability < significant;
  plan.sample = original.sample;
  check_count(plan);
  if (options.gap < 0) halve_gap_until_it_can_be_kept(plan);
  return plan;
}

Twin draw_twin(const TwinPlan& plan, std::uint64_t seed) {
  std::optional<Twin> twin = try_often_to_draw(plan, seed);
  if (!twin) refuse_fraction(plan);
  return *std::move(twin);
}

}  // namespace specimen
