#include "apps/bench/stability.hpp"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "apps/system/job_pool.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/words.hpp"

namespace app::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void run_case(const StabilityCase& one, StabilityRow& row) {
  const Clock::time_point start = Clock::now();
  try {
    row.finding = one.run();
  } catch (const std::exception& error) {
    row.finding = {false, std::string("it threw: ") + error.what()};
  }
  row.seconds = seconds_since(start);
  row.done = true;
}

}  // namespace

bool StabilityOutcome::holds() const {
  return !rows.empty() && std::all_of(rows.begin(), rows.end(),
                                      [](const StabilityRow& row) { return row.done && row.finding.holds; });
}

StabilityOutcome run_cases(const std::vector<const StabilityCase*>& cases, int workers, const Watch& watch) {
  const Clock::time_point start = Clock::now();
  StabilityOutcome outcome;
  outcome.workers = workers;
  for (const StabilityCase* one : cases)
    outcome.rows.push_back({.name = one->name, .group = one->group, .must = one->must});
  std::vector<std::function<void()>> jobs;
  for (std::size_t i = 0; i < cases.size(); ++i)
    jobs.emplace_back([&outcome, &cases, i] { run_case(*cases[i], outcome.rows[i]); });
  outcome.interrupted = run_jobs(jobs, workers, watch) < jobs.size();
  outcome.wall_time = seconds_since(start);
  return outcome;
}

StabilityOutcome run_stability(const StabilityOptions& options, const Watch& watch) {
  return run_cases(select_cases(options.cases), options.workers, watch);
}

namespace {

std::vector<StabilityCase> all_cases() {
  std::vector<StabilityCase> cases;
  using CasesOf = std::vector<StabilityCase> (*)();
  for (const auto& [group, cases_of] : {std::pair<const char*, CasesOf>{"Materials", material_cases},
                                        {"Strength", strength_cases},
                                        {"Pictures", geometry_cases},
                                        {"Points", point_cases},
                                        {"Time step", time_step_cases},
                                        {"Loading", loading_cases},
                                        {"Inertia", inertia_cases},
                                        {"Equilibrium", quasi_static_cases},
                                        {"Motion", motion_cases},
                                        {"Numbers", number_cases}})
    for (StabilityCase& one : cases_of()) {
      one.group = group;
      cases.push_back(std::move(one));
    }
  return cases;
}

void check_name(const std::string& name) {
  std::vector<std::string> names;
  for (const StabilityCase& one : stability_cases()) names.push_back(one.name);
  if (std::find(names.begin(), names.end(), name) != names.end()) return;
  throw Rejected(Exit::usage, "--case", name, "must be one of " + listed(names), did_you_mean(name, names));
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
