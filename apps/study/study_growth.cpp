#include "apps/study/study_growth.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {

std::vector<MeanEstimate> peak_estimates(const std::vector<Member>& members, const StudyResults& results) {
  const std::vector<double> stress = results.peak_stress();
  std::vector<std::vector<double>> by_point;
  for (const Member& member : members) {
    by_point.resize(std::max(by_point.size(), member.point + 1));
    by_point[member.point].push_back(stress[member.number]);
  }
  std::vector<MeanEstimate> estimates;
  for (const std::vector<double>& values : by_point) estimates.push_back(mean_estimate(values));
  return estimates;
}

std::size_t seeds_to_go_on_with(const std::vector<MeanEstimate>& estimates, std::size_t seeds, double share) {
  if (seeds < least_seeds) return least_seeds;
  if (largest_half_width(estimates) <= share) return seeds;
  std::size_t needed = seeds + 1;
  for (const MeanEstimate& estimate : estimates) {
    const std::size_t wanted = values_needed(estimate, share);
    needed = std::max(needed, wanted == 0 ? 2 * seeds : wanted);
  }
  return std::min({needed, 2 * seeds, std::max(seeds, most_seeds)});
}

std::vector<std::uint64_t> grown_seeds(std::vector<std::uint64_t> seeds, std::size_t count) {
  std::uint64_t next = *std::max_element(seeds.begin(), seeds.end()) + 1;
  while (seeds.size() < count) seeds.push_back(next++);
  return seeds;
}

double largest_half_width(const std::vector<MeanEstimate>& estimates) {
  double largest = 0;
  for (const MeanEstimate& estimate : estimates) {
    const double width = estimate.relative_half_width();
    if (std::isnan(width)) return width;
    largest = std::max(largest, width);
  }
  return largest;
}

double WholeStudy::half_width() const { return largest_half_width(peak_estimates(members, *results)); }

WholeStudy run_whole_study(Study study, std::vector<Member> members, const StudyFolder& folder, double share,
                           const RunMembers& run) {
  WholeStudy whole{std::move(study), std::move(members), {}, {}};
  for (;;) {
    whole.tally = run(whole.study, whole.members);
    if (whole.tally.open() > 0) return whole;
    StudyResults results = read_results(folder, whole.members);
    std::vector<std::uint64_t>& seeds = whole.study.plan.seeds;
    const std::size_t wanted =
        share > 0 ? seeds_to_go_on_with(peak_estimates(whole.members, results), seeds.size(), share)
                  : seeds.size();
    if (wanted == seeds.size()) {
      whole.results = std::move(results);
      return whole;
    }
    seeds = grown_seeds(seeds, wanted);
    whole.members = list_members(whole.study, std::move(whole.members));
  }
}

}  // namespace app
