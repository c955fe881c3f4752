#include "apps/study/study_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "apps/run/energy_note.hpp"
#include "apps/job/job.hpp"
#include "apps/text/html.hpp"
#include "apps/report/load_words.hpp"
#include "apps/drawing/picture_parts.hpp"
#include "apps/drawing/png.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/report/run_words.hpp"
#include "apps/text/text.hpp"
#include "apps/study/study_charts.hpp"
#include "apps/system/text_file.hpp"
#include "libmpm/files/replace_file.hpp"

namespace app {
namespace {

using output::paragraph;
using output::section;

constexpr double picture_scale = 2;  ///< pixels of cracks.png per px of its drawing
constexpr double paper_margin = 12;  ///< round it [px]

std::string counted(std::size_t count, const std::string& thing) {
  return fmt::format("{} {}{}", output::grouped(static_cast<std::int64_t>(count)), thing,
                     count == 1 ? "" : "s");
}

std::string header(const StudyRecord& record) {
  const StudyPlan& plan = record.study.plan;
  const std::size_t seeds = std::max<std::size_t>(1, plan.seeds.size());
  std::string setting = output::capitalised(output::setting_of_loading(record.scene)) + "; " +
                        counted(record.members.size(), "member");
  if (!plan.parameters.empty()) setting += ", " + counted(record.members.size() / seeds, "point");
  if (!plan.seeds.empty()) setting += ", " + counted(seeds, "seed") + " of " + output::listed(plan.seed_of);
  return output::heading(plan.title, setting);
}

std::string failures_section(const StudyRecord& record) {
  constexpr std::size_t most = 10;
  std::vector<std::string> reasons;
  for (const Member& member : record.members)
    if (const MemberOutcome& outcome = record.results.outcomes[member.number];
        outcome.state == MemberState::failed)
      reasons.push_back(name_of(record.study, member) + ": " + outcome.reason);
  if (reasons.empty()) return "";
  std::string html =
      paragraph(counted(reasons.size(), "member") + " failed, and stand in none of the figures.");
  std::string list;
  for (std::size_t i = 0; i < std::min(most, reasons.size()); ++i)
    list += "<li>" + output::escape(reasons[i]) + "</li>\n";
  if (reasons.size() > most) list += "<li>" + std::to_string(reasons.size() - most) + " more</li>\n";
  return section("Failures", html + "<ul class=\"notes\">\n" + list + "</ul>\n");
}

/// What a run of its own would have been noted for, of the worst member.
std::string notes_section(const StudyRecord& record) {
  const auto error = [&](const Member& member) {
    const MemberOutcome& outcome = record.results.outcomes[member.number];
    return outcome.state == MemberState::done ? outcome.figures.energy_error : 0;
  };
  const auto worst = std::max_element(record.members.begin(), record.members.end(),
                                      [&](const Member& a, const Member& b) { return error(a) < error(b); });
  if (!(error(*worst) > 0)) return "";
  const std::string note = energy_note(record.results.outcomes[worst->number].figures,
                                       member_settings(record.study, *worst).scene);
  if (note.empty()) return "";
  return section("Notes", paragraph("The energies of " + name_of(record.study, *worst) + " are the worst: " +
                                    note + ". Those of all members stand in table.csv."));
}

std::string cracks_section(const StudyRecord& record) {
  if (!has_crack_picture(record)) return "";
  const std::string png =
      output::png_of(crack_drawing(record.results.cracks, *record.mask), picture_scale, paper_margin);
  return section(
      "Where it cracks",
      output::side_by_side(
          "fit",
          fmt::format("<img width=\"{:.0f}\" alt=\"How often each pixel failed\" src=\"{}\"/>\n",
                      output::picture_width + 2 * paper_margin, output::png_address(png)),
          paragraph("The share of the members in which a pixel had failed by the end of the run, over all "
                    "members. Where specimens differ, edges and nothing else can stand out; where only "
                    "strengths do, the cracks that most of them share.")));
}

}  // namespace

bool has_crack_picture(const StudyRecord& record) {
  const auto& failures = record.results.cracks.failures;
  return record.mask && failures.size() > 0 && failures.rows() == record.mask->labels.rows &&
         failures.cols() == record.mask->labels.cols;
}

std::string study_html(const StudyRecord& record, const std::string& study_toml) {
  return output::page(record.study.plan.title,
                      header(record) + peaks_section(record) + weibull_section(record) +
                          convergence_section(record) + curves_section(record) + cracks_section(record) +
                          sensitivity_section(record) + size_section(record) + failures_section(record) +
                          notes_section(record) +
                          section("Study", output::folded("The study file", study_toml)));
}

void write_study_report(const StudyFolder& folder, const Study& study, const std::vector<Member>& members,
                        const StudyResults& results) {
  const auto done = std::find_if(results.outcomes.begin(), results.outcomes.end(),
                                 [](const auto& outcome) { return outcome.state == MemberState::done; });
  const auto first = done == results.outcomes.end() ? 0 : done - results.outcomes.begin();
  const Settings settings = member_settings(study, members[static_cast<std::size_t>(first)]);
  StudyRecord record{study, members, results, settings.scene, {}};
  if (results.cracks.failures.size() > 0 && !varies_pixels(study.plan))
    record.mask = prepare_cells(settings).specimen.mask;
  if (has_crack_picture(record))
    mpm::replace_file(
        folder.file("cracks.png").string(),
        output::png_of(crack_drawing(results.cracks, *record.mask), picture_scale, paper_margin));
  mpm::replace_file(folder.file("report.html").string(),
                    study_html(record, read_text_file(folder.file("study.toml").string())));
}

}  // namespace app
