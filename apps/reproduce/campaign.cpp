#include "apps/reproduce/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <exception>
#include <map>

#include "apps/job/job.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/run/run_length.hpp"
#include "apps/system/job_pool.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/words.hpp"

namespace app::reproduce {
namespace {

bool has_id(const Figure& figure, const std::string& id) {
  return std::find(figure.ids.begin(), figure.ids.end(), id) != figure.ids.end();
}

void check_id(const std::string& id) {
  std::vector<std::string> known;
  for (const Figure& figure : figures()) {
    if (has_id(figure, id)) return;
    known.insert(known.end(), figure.ids.begin(), figure.ids.end());
  }
  throw Rejected(Exit::usage, "--figure", id, "must be " + listed(known),
                 "leave it out, or give --all, for all of them");
}

}  // namespace

const std::vector<Figure>& figures() {
  static const std::vector<Figure> all{
      generation_figure(),     weibull_figure(), curves_figure(),   damage_figure(),
      two_aggregates_figure(), modulus_figure(), strength_figure(), cohesion_figure(),
      objectivity_figure(),    inertia_figure(),
  };
  return all;
}

std::vector<const Figure*> select_figures(const std::vector<std::string>& ids) {
  for (const std::string& id : ids) check_id(id);
  std::vector<const Figure*> selected;
  for (const Figure& figure : figures())
    if (ids.empty() ||
        std::any_of(ids.begin(), ids.end(), [&](const auto& id) { return has_id(figure, id); }))
      selected.push_back(&figure);
  return selected;
}

std::string name_of(const Figure& figure) {
  if (figure.ids.size() == 1 && std::isdigit(figure.ids.front().front()) == 0)
    return output::capitalised(figure.ids.front());
  if (figure.ids.size() == 1) return "Figure " + figure.ids.front();
  return "Figures " + figure.ids.front() + (figure.ids.size() == 2 ? " and " : " to ") + figure.ids.back();
}

namespace {

/// Run what is expected and not yet done.
void run_open(TrialResults& outcomes, int workers, const Watch& watch) {
  std::vector<std::function<void()>> jobs;
  for (TrialResults::Entry& entry : outcomes.entries())
    if (!entry.outcome.done)
      jobs.emplace_back([&entry, &watch] { entry.outcome = run_trial(entry.trial, watch.go_on); });
  const std::size_t before = outcomes.entries().size() - jobs.size(), all = outcomes.entries().size();
  run_jobs(jobs, workers,
           {[&](std::size_t done, std::size_t) { watch.tell(before + done, all); }, watch.go_on});
}

bool all_done(const std::vector<Trial>& trials, const TrialResults& outcomes) {
  return std::all_of(trials.begin(), trials.end(), [&](const Trial& trial) { return outcomes.has(trial); });
}

/// Trials of the second round, for a figure whose first round is done.
std::vector<Trial> more_trials(const Figure& figure, const Effort& effort, const TrialResults& outcomes) {
  if (!figure.more_trials || !all_done(figure.trials(effort), outcomes)) return {};
  return figure.more_trials(effort, outcomes);
}

FigureResult result_of(const Figure& figure, const Effort& effort, const TrialResults& outcomes) {
  FigureResult result{&figure, false, {}};
  result.done =
      all_done(figure.trials(effort), outcomes) && all_done(more_trials(figure, effort, outcomes), outcomes);
  if (!result.done) return result;
  try {
    result.section = figure.evaluate(effort, outcomes);
  } catch (const std::exception& fault) {  // the other figures are not lost with this one
    result.section.html =
        output::paragraph(std::string("This figure could not be made: ") + fault.what() + ".");
  }
  return result;
}

}  // namespace

namespace {

/// The trials of the first round, those of a figure with a second one twice.
std::vector<Trial> trials_to_come(const std::vector<const Figure*>& figures, const Effort& effort) {
  TrialResults first;
  std::vector<Trial> second;
  for (const Figure* figure : figures)
    for (const Trial& trial : figure->trials(effort)) {
      first.expect(trial);
      if (figure->more_trials) second.push_back(trial);
    }
  std::vector<Trial> all;
  for (const TrialResults::Entry& entry : first.entries()) all.push_back(entry.trial);
  all.insert(all.end(), second.begin(), second.end());
  return all;
}

/// Trials that differ by nothing but their random numbers share it.
std::string size_key(Trial trial) {
  std::erase_if(trial.settings, [](const Setting& setting) { return setting.first.ends_with(".seed"); });
  return name_of(trial);
}

}  // namespace

std::string announcement(const std::vector<const Figure*>& figures, const Effort& effort, int workers) {
  const std::vector<Trial> trials = trials_to_come(figures, effort);
  std::map<std::string, RunSize> known;
  std::vector<RunSize> sizes;
  bool may_end_before = false;
  for (const Trial& trial : trials) {
    const auto [place, is_new] = known.try_emplace(size_key(trial));
    if (is_new) {
      const mpm::Scene scene = make_job(settings_of(trial)).scene;
      place->second = size_of(scene);
      may_end_before = may_end_before || scene.loading.stop_drop;
    }
    sizes.push_back(place->second);
  }
  const double seconds = time_of_runs(
      sizes, [&](std::size_t i) { return make_job(settings_of(trials[i])).scene; }, workers);
  if (!is_long(seconds)) return {};
  return fmt::format("{} of up to {}, which take {} {} here, {} at a time",
                     app::counted(static_cast<int>(sizes.size()), "run"), size_text(sizes),
                     precision_word(sizes, may_end_before), duration_text(seconds), workers);
}

Reproduction reproduce_figures(const std::vector<const Figure*>& figures, const Effort& effort, int workers,
                               const Watch& watch) {
  const auto start = std::chrono::steady_clock::now();
  Reproduction reproduction{{}, {}, effort, workers, 0, false};
  TrialResults& outcomes = reproduction.outcomes;
  for (const Figure* figure : figures)
    for (const Trial& trial : figure->trials(effort)) outcomes.expect(trial);
  run_open(outcomes, workers, watch);
  for (const Figure* figure : figures)
    for (const Trial& trial : more_trials(*figure, effort, outcomes)) outcomes.expect(trial);
  run_open(outcomes, workers, watch);
  for (const Figure* figure : figures) reproduction.figures.push_back(result_of(*figure, effort, outcomes));
  reproduction.interrupted = !watch.goes_on();
  reproduction.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return reproduction;
}

std::vector<Claim> claims_of(const Reproduction& reproduction) {
  std::vector<Claim> claims;
  for (const FigureResult& figure : reproduction.figures)
    claims.insert(claims.end(), figure.section.claims.begin(), figure.section.claims.end());
  return claims;
}

}  // namespace app::reproduce
