#include "apps/bench/problem_table.hpp"

#include <algorithm>

#include "apps/bench/concrete_problems.hpp"
#include "apps/bench/known_problems.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/suggestion.hpp"

namespace app::bench {

std::vector<Problem> all_problems() {
  return {tension_problem(), modulus_problem(), bar_problem(),  manufactured_problem(), inclusion_problem(),
          hole_problem(),    layers_problem(),  spin_problem(), collision_problem(),    flight_problem()};
}

std::vector<Problem> select_problems(const std::vector<std::string>& names) {
  std::vector<Problem> all = all_problems();
  std::vector<std::string> known;
  for (const Problem& problem : all) known.push_back(problem.name);
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw Rejected(Exit::usage,
                     complaint("--problem", name, "must be " + listed(known), did_you_mean(name, known)));
  if (!names.empty())
    std::erase_if(all, [&](const Problem& problem) {
      return std::find(names.begin(), names.end(), problem.name) == names.end();
    });
  return all;
}

}  // namespace app::bench
