#include "apps/bench/error_study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/statistics/statistics.hpp"

namespace app::bench {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// The run with the median of its times.
Measured repeated(const Run& run) {
  std::vector<Measured> all;
  double total = 0;
  do {
    all.push_back(run());
    total += all.back().wall_time;
  } while (total < 0.1 && all.size() < 5 && all.back().trouble.empty());
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end(),
                   [](const Measured& a, const Measured& b) { return a.wall_time < b.wall_time; });
  return *middle;
}

Sample judged(const Measured& measured, double size, const Problem& problem, double reference) {
  Sample sample{size, std::abs(measured.value), measured.wall_time, measured.point_updates, measured.trouble,
                false};
  if (problem.reference) sample.error = std::abs(measured.value / reference - 1);
  if (!measured.trouble.empty()) sample.error = unknown;
  return sample;
}

double order_of(const std::vector<Sample>& samples) {
  std::vector<double> sizes, errors;
  for (const Sample& sample : samples)
    if (sample.error > 0) {
      sizes.push_back(sample.size);
      errors.push_back(sample.error);
    }
  const bool falls = std::is_sorted(errors.rbegin(), errors.rend());
  return sizes.size() < 3 || !falls ? unknown : power_of(sizes, errors);
}

template <class Visit>
void for_each_sample(ProblemResult& result, const Visit& visit) {
  for (MethodResult& method : result.methods)
    for (Sample& sample : method.samples) visit(sample);
}

/// Pareto's front: from the fastest run on, each that is more exact than all faster ones.
void mark_front(ProblemResult& result) {
  std::vector<Sample*> samples;
  for_each_sample(result, [&](Sample& sample) {
    if (std::isfinite(sample.error)) samples.push_back(&sample);
  });
  std::sort(samples.begin(), samples.end(), [](const Sample* a, const Sample* b) {
    return a->wall_time != b->wall_time ? a->wall_time < b->wall_time : a->error < b->error;
  });
  double best = std::numeric_limits<double>::infinity();
  for (Sample* sample : samples)
    if (sample->error < best) {
      best = sample->error;
      sample->in_front = true;
    }
}

std::size_t runs_of(const Problem& problem) {
  std::size_t count = problem.reference ? 1 : 0;
  for (const Method& method : problem.methods) count += method.runs.size();
  return count;
}

/// Runs one after the other, until somebody says no.
class Progress {
 public:
  Progress(std::size_t all, const Watch& watch) : all_(all), watch_(watch) {}

  [[nodiscard]] bool goes_on() const { return watch_.goes_on(); }
  Measured take(const Run& run) {
    const Measured measured = repeated(run);
    watch_.tell(++done_, all_);
    return measured;
  }

 private:
  std::size_t done_ = 0, all_;
  const Watch& watch_;
};

/// @return whether all runs were done.
bool solve(ProblemResult& result, Progress& progress) {
  const Problem& problem = result.problem;
  if (problem.reference) {
    const Measured reference = progress.take(problem.reference);
    result.reference_value = reference.value;
    result.reference_time = reference.wall_time;
  }
  for (const Method& method : problem.methods) {
    MethodResult& line = result.methods.emplace_back(MethodResult{&method, {}, 0});
    for (std::size_t i = 0; i < method.runs.size(); ++i) {
      if (!progress.goes_on()) return false;
      line.samples.push_back(
          judged(progress.take(method.runs[i]), method.sizes[i], problem, result.reference_value));
    }
    line.order = order_of(line.samples);
  }
  mark_front(result);
  return progress.goes_on();
}

/// The best sample of those that may be taken.
template <class MayTake, class Better>
Cheapest best_of(const ProblemResult& result, const MayTake& may_take, const Better& better) {
  Cheapest best;
  for (const MethodResult& method : result.methods)
    for (const Sample& sample : method.samples)
      if (may_take(sample) && (best.sample == nullptr || better(sample, *best.sample)))
        best = {method.method, &sample};
  return best;
}

}  // namespace

std::vector<ProblemResult> study_errors(const std::vector<Problem>& problems, const Watch& watch) {
  std::size_t all = 0;
  for (const Problem& problem : problems) all += runs_of(problem);
  Progress progress(all, watch);
  std::vector<ProblemResult> results;
  results.reserve(problems.size());  // the methods are pointed to
  for (const Problem& problem : problems) {
    results.push_back({problem, 0, 0, {}});
    if (!solve(results.back(), progress)) {
      results.pop_back();
      break;
    }
  }
  return results;
}

Cheapest cheapest_within(const ProblemResult& result, double tolerance) {
  return best_of(
      result, [&](const Sample& sample) { return sample.error <= tolerance; },
      [](const Sample& a, const Sample& b) { return a.wall_time < b.wall_time; });
}

Cheapest most_exact(const ProblemResult& result) {
  return best_of(
      result, [](const Sample& sample) { return std::isfinite(sample.error); },
      [](const Sample& a, const Sample& b) { return a.error < b.error; });
}

}  // namespace app::bench
