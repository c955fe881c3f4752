#include "apps/reproduce/trial.hpp"

#include "apps/job/job.hpp"
#include "apps/scene/scene_file.hpp"
#include "apps/statistics/curve.hpp"
#include "apps/statistics/statistics.hpp"
#include "apps/text/complaint.hpp"
#include "libmpm/run/simulate.hpp"

namespace app::reproduce {
namespace {

/// The settings of a trial without those that a later one overrides.
std::vector<Setting> lasting(const std::vector<Setting>& settings) {
  std::vector<Setting> lasting;
  for (const Setting& setting : settings) {
    const auto same = [&](const Setting& other) { return other.first == setting.first; };
    std::erase_if(lasting, same);
    lasting.push_back(setting);
  }
  return lasting;
}

}  // namespace

std::string name_of(const Trial& trial) {
  std::string name = trial.scene;
  for (const auto& [key, value] : lasting(trial.settings))
    name.append(" ").append(key).append("=").append(value);
  return name;
}

std::string command_of(const Trial& trial) {
  std::string command = "mesopix simulate " + path_of_scene(trial.scene);
  for (const auto& [key, value] : lasting(trial.settings)) {
    const bool spaced = value.find(' ') != std::string::npos;
    command.append(" --set ").append(spaced ? "\"" : "").append(key).append("=").append(value);
    if (spaced) command += '"';
  }
  return command;
}

Settings settings_of(const Trial& trial) {
  std::vector<Assignment> given;
  for (const auto& [key, value] : lasting(trial.settings)) {
    const auto field = find_field(key);
    if (!field) throw Rejected(Exit::internal, key, "unknown key", "", "in " + name_of(trial));
    given.push_back(given_as_option(key, field->form.kind, "--set " + key, value));
  }
  return resolve(parse_scene(paper_scene(trial.scene).text, path_of_scene(trial.scene)), given).settings;
}

TrialResult run_trial(const Trial& trial, const std::function<bool()>& go_on) {
  Job job = make_job(settings_of(trial));
  job.scene.threads = 1;  // other trials have the other cores
  TrialResult outcome;
  outcome.specimen = std::move(job.specimen);
  try {
    outcome.result = mpm::simulate(job.scene, {.observer = [&](const mpm::Progress&) { return go_on(); }});
  } catch (const mpm::Diverged& diverged) {
    throw Rejected(Exit::data, "reproduce", diverged.what(), "in " + command_of(trial));
  }
  outcome.done = outcome.result.stop != mpm::StopReason::interrupted;
  if (trial.keep_maps) return outcome;
  outcome.specimen = {};
  drop_maps(outcome.result);
  return outcome;
}

void TrialResults::expect(const Trial& trial) {
  const auto [place, is_new] = index_.try_emplace(name_of(trial), entries_.size());
  if (is_new)
    entries_.push_back({trial, {}});
  else if (trial.keep_maps && !entries_[place->second].trial.keep_maps)
    entries_[place->second] = {trial, {}};
}

bool TrialResults::has(const Trial& trial) const {
  const auto place = index_.find(name_of(trial));
  return place != index_.end() && entries_[place->second].outcome.done;
}

}  // namespace app::reproduce
