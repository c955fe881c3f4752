#include "apps/study/study_outcome.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/study/study_growth.hpp"
#include "apps/study/study_report.hpp"
#include "apps/study/study_results.hpp"
#include "apps/text/figures.hpp"
#include "libmpm/files/replace_file.hpp"

namespace app {
namespace {

constexpr std::size_t most_reasons = 5;

void write_tables(const StudyFolder& folder, const Study& study, const std::vector<Member>& members,
                  const StudyResults& results) {
  const std::vector<mpm::TableColumn> table = study_table(study, members, results);
  mpm::replace_file(folder.file("table.csv").string(), table_csv(table));
  mpm::write_table(folder.file("table.h5").string(), table);
  mpm::replace_file(folder.file("timing.csv").string(), table_csv(timing_table(members, results)));
}

void say_means(const Study& study, const StudyResults& results, Console& console) {
  if (const std::string text = without_peak_text(results); !text.empty()) console.say("warning: " + text);
  if (!study.plan.parameters.empty()) return;
  const MeanEstimate stress = mean_estimate(results.peak_stress());
  if (stress.count < 2) return;
  console.say(fmt::format("mean peak {:.4g} MPa, 95 % confidence interval \u00b1{}, standard deviation {}",
                          1e-6 * stress.mean, output::percent(stress.relative_half_width(), 2),
                          output::percent(stress.deviation / stress.mean, 1)));
}

}  // namespace

std::vector<std::string> close_study(const StudyFolder& folder, const Study& study,
                                     const std::vector<Member>& members, const StudyResults& results,
                                     Console& console) {
  std::vector<std::string> doubts = doubts_of(members);
  if (std::string text = inertia_text(results); !text.empty()) doubts.push_back(std::move(text));
  write_tables(folder, study, members, results);
  write_study_report(folder, study, members, results, doubts);
  say_means(study, results, console);
  console.say("wrote " + folder.path().string());
  return doubts;
}

nlohmann::ordered_json count_json(const StudyFolder& folder, const std::vector<Member>& members) {
  std::size_t done = 0;
  std::size_t failed = 0;
  for (const Member& member : members) {
    const bool has_result = folder.has_result(member);
    done += has_result ? 1 : 0;
    failed += !has_result && folder.has_failed(member) ? 1 : 0;
  }
  return {{"folder", folder.path().string()},
          {"members", members.size()},
          {"done", done},
          {"failed", failed},
          {"open", members.size() - done - failed}};
}

nlohmann::ordered_json study_json(const StudyFolder& folder, const Study& study,
                                  const std::vector<Member>& members, const StudyResults& results,
                                  const std::vector<std::string>& doubts) {
  nlohmann::ordered_json json = count_json(folder, members);
  json["warnings"] = doubts;
  json["without_peak"] = results.without_peak();
  json["peak_stress"] = nullptr;
  if (study.plan.parameters.empty()) {
    const MeanEstimate stress = mean_estimate(results.peak_stress());
    json["peak_stress"] = {{"mean_Pa", stress.mean},
                           {"standard_deviation_Pa", stress.deviation},
                           {"half_width_95_Pa", stress.half_width}};
  }
  json["files"] = {"table.csv", "table.h5", "timing.csv", "report.html"};
  return json;
}

void refuse_failures(const Study& study, const StudyFolder& folder, const std::vector<Member>& members) {
  std::vector<Complaint> complaints;
  std::size_t failed = 0;
  for (const Member& member : members) {
    if (folder.has_result(member) || !folder.has_failed(member)) continue;
    if (++failed <= most_reasons)
      complaints.push_back(complaint(name_of(study, member), folder.failure(member), ""));
  }
  if (failed == 0) return;
  complaints.push_back(complaint("study", fmt::format("{} of {} members failed", failed, members.size()),
                                 "all reasons are in " + (folder.path() / "failures").string(),
                                 option_name("retry") + " runs them again"));
  throw Rejected(Exit::data, std::move(complaints));
}

std::string study_text(const StudyTally& tally, double elapsed) {
  std::string text = fmt::format("{} of {} members", tally.before + tally.done + tally.failed, tally.all);
  if (tally.failed > 0) text += fmt::format("   {} failed", tally.failed);
  const std::size_t now = tally.done + tally.failed;
  if (now == 0) return text;
  const double seconds = elapsed * static_cast<double>(tally.open()) / static_cast<double>(now);
  if (seconds < 100) return text + fmt::format("   {:.0f} s left", seconds);
  return text + fmt::format("   {:.0f} min left", seconds / 60);
}

}  // namespace app
