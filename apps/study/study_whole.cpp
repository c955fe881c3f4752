#include "apps/study/study_whole.hpp"

#include <utility>

#include "apps/study/study_growth.hpp"

namespace app {

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
    whole.members = list_members(whole.study);
  }
}

}  // namespace app
