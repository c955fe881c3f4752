#include "apps/bench/stability_table.hpp"

#include <algorithm>
#include <iterator>

#include "apps/bench/stability_groups.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/suggestion.hpp"

namespace app::bench {
namespace {

std::vector<StabilityCase> all_cases() {
  std::vector<StabilityCase> cases;
  for (auto* group : {material_cases, strength_cases, geometry_cases, point_cases, time_step_cases,
                      loading_cases, motion_cases, turning_cases, number_cases}) {
    std::vector<StabilityCase> some = group();
    std::move(some.begin(), some.end(), std::back_inserter(cases));
  }
  return cases;
}

void check_name(const std::string& name) {
  std::vector<std::string> names;
  for (const StabilityCase& one : stability_cases()) names.push_back(one.name);
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  throw Rejected(Exit::usage,
                 complaint("--case", name, "must be one of " + listed(names), did_you_mean(name, names)));
}

}  // namespace

const std::vector<StabilityCase>& stability_cases() {
  static const std::vector<StabilityCase> cases = all_cases();
  return cases;
}

std::vector<const StabilityCase*> select_cases(const std::vector<std::string>& names) {
  for (const std::string& name : names) check_name(name);
  std::vector<const StabilityCase*> selected;
  for (const StabilityCase& one : stability_cases())
    if (names.empty() || std::find(names.begin(), names.end(), one.name) != names.end())
      selected.push_back(&one);
  return selected;
}

}  // namespace app::bench
