#include "apps/study/study_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "apps/drawing/drawing_files.hpp"
#include "apps/drawing/picture_parts.hpp"
#include "apps/job/job.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/report/run_words.hpp"
#include "apps/run/run_remarks.hpp"
#include "apps/statistics/influences.hpp"
#include "apps/statistics/statistics.hpp"
#include "apps/study/study_charts.hpp"
#include "apps/study/study_sections.hpp"
#include "apps/study/study_values.hpp"
#include "apps/system/files.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/words.hpp"
#include "libmpm/files/replace_file.hpp"

namespace app {
namespace {

using output::paragraph;
using output::section;

constexpr double picture_scale = 2;  ///< pixels of cracks.png per px of its drawing
constexpr double paper_margin = 12;  ///< round it [px]

std::string grouped_count(std::size_t count, const std::string& thing) {
  const auto number = static_cast<std::int64_t>(count);
  return output::grouped(number) + " " + noun_for(number, thing);
}

/// Whether what is said of the loading of the scene holds for all members.
bool has_one_loading(const StudyPlan& plan) {
  const auto is_of_loading = [](const Field& field) {
    return field.key.starts_with("loading.") || field.key == "solver.method";
  };
  return std::none_of(plan.parameters.begin(), plan.parameters.end(), [&](const StudyParameter& parameter) {
    return std::any_of(parameter.fields.begin(), parameter.fields.end(), is_of_loading);
  });
}

std::string header(const StudyRecord& record) {
  const StudyPlan& plan = record.study.plan;
  const std::size_t seeds = std::max<std::size_t>(1, plan.seeds.size());
  std::string setting;
  if (has_one_loading(plan)) setting = output::capitalised(output::setting_of_loading(record.scene)) + "; ";
  setting += grouped_count(record.members.size(), "member");
  if (!plan.parameters.empty()) setting += ", " + grouped_count(record.members.size() / seeds, "point");
  if (!plan.seeds.empty())
    setting += ", " + grouped_count(seeds, "seed") + " of " + listed(plan.seed_of, "and");
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
  const std::string html =
      paragraph(grouped_count(reasons.size(), "member") + " failed, and stand in none of the figures.");
  const std::size_t all = reasons.size();
  if (all > most) {
    reasons.resize(most);
    reasons.push_back(std::to_string(all - most) + " more");
  }
  return section("Failures", html + output::notes_list(reasons));
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
  const std::string note =
      energy_note(record.results.outcomes[worst->number].figures, worst->settings->scene);
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
  const struct {
    const char* heading;
    std::string (*of)(const StudyRecord&);
  } sections[] = {{"Peaks", peaks_section},
                  {"Weibull distribution", weibull_section},
                  {"How the mean settles", convergence_section},
                  {"Curves", curves_section},
                  {"Where it cracks", cracks_section},
                  {"Sensitivities", sensitivity_section},
                  {"Size effect", size_section},
                  {"Failures", failures_section},
                  {"Notes", notes_section}};
  std::string html = header(record) + output::warnings_section(record.doubts);
  for (const auto& one : sections) html += output::standing(one.heading, [&] { return one.of(record); });
  return output::page(record.study.plan.title,
                      html + section("Study", output::folded("The study file", study_toml)));
}

void write_study_report(const StudyFolder& folder, const Study& study, const std::vector<Member>& members,
                        const StudyResults& results, std::vector<std::string> doubts) {
  const auto done = std::find_if(results.outcomes.begin(), results.outcomes.end(),
                                 [](const auto& outcome) { return outcome.state == MemberState::done; });
  const auto first = done == results.outcomes.end() ? 0 : done - results.outcomes.begin();
  const Settings& settings = *members[static_cast<std::size_t>(first)].settings;
  StudyRecord record{study, members, results, settings.scene, {}, std::move(doubts)};
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

// Sections on what the results depend on.

namespace app {
namespace {

using output::rounded;
using output::section;

constexpr std::size_t least_members = 8;  ///< for a sensitivity
constexpr std::size_t most_charts = 6;
constexpr double good_fit = 0.5;  ///< share of the variance below which a law explains little

/// Pairs of a parameter and a figure, of the members that are done.
struct Pairs {
  std::vector<double> x, y;
};

/// @param i  of the parameter; words are numbered in the order of their levels.
Pairs pairs_of(const StudyRecord& record, std::size_t i, const std::vector<double>& figure) {
  const StudyParameter& parameter = record.study.plan.parameters[i];
  Pairs pairs;
  for (const Member& member : record.members) {
    if (!std::isfinite(figure[member.number])) continue;
    const Value& value = member.values[i];
    const auto level = std::find(parameter.levels.begin(), parameter.levels.end(), value);
    pairs.x.push_back(is_number(parameter) ? number_of(parameter, value)
                                           : static_cast<double>(level - parameter.levels.begin()));
    pairs.y.push_back(figure[member.number]);
  }
  return pairs;
}

std::string probability(double p) {
  if (!std::isfinite(p)) return "\u2013";
  return p < 0.001 ? "< 0.001" : rounded(p, 2);
}

std::vector<std::string> cells(const Pairs& pairs, bool ordered) {
  const double r = ordered ? rank_correlation(pairs.x, pairs.y) : std::nan("");
  const double index = first_order_index(pairs.x, pairs.y);
  return {std::isfinite(r) ? rounded(r, 2) : "\u2013", probability(significance_of(r, pairs.x.size())),
          std::isfinite(index) ? rounded(index, 2) : "\u2013"};
}

bool has_levels(const StudyParameter& parameter) {
  return parameter.is_range() || parameter.levels.size() > 1;
}

/// Peak stress against each of the first parameters that are numbers, two beside each other.
std::string influence_charts(const StudyRecord& record) {
  std::vector<std::string> charts;
  const auto& parameters = record.study.plan.parameters;
  for (std::size_t i = 0; i < parameters.size() && charts.size() < most_charts; ++i) {
    if (!has_levels(parameters[i]) || !is_number(parameters[i])) continue;
    Pairs pairs = pairs_of(record, i, record.results.peak_stress());
    const ReadableUnit unit = readable_unit(parameters[i]);
    for (double& x : pairs.x) x *= unit.per_si;
    for (double& y : pairs.y) y *= 1e-6;
    charts.push_back(
        output::chart_figure(influence_chart(pairs.x, pairs.y, {parameters[i].name, unit.name, false, true},
                                             {"Peak stress", "MPa"}),
                             480, 300, ""));
  }
  return output::in_pairs(charts);
}

std::string sensitivity_table(const StudyRecord& record, const std::string& name,
                              const std::vector<double>& figure) {
  std::vector<std::vector<std::string>> rows;
  const auto& parameters = record.study.plan.parameters;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!has_levels(parameters[i])) continue;
    rows.push_back({parameters[i].name});
    for (std::string& cell : cells(pairs_of(record, i, figure), is_number(parameters[i])))
      rows.back().push_back(std::move(cell));
  }
  return output::number_table({name, "Rank correlation", "p", "First-order index"}, rows);
}

constexpr const char* sensitivity_caption =
    "Rank correlation: 1 where the figure rises whenever the parameter does, -1 where it falls (Spearman). "
    "p: how "
    "often members without any dependence have a correlation of at least that amount. First-order index: "
    "share of "
    "the variance that the parameter explains on its own (Sobol), estimated from these members; near 0, and "
    "now "
    "and then below it, for one without influence. What the indices lack to 1 is the random numbers, and "
    "parameters that act together.";

/// The parameter that is the size, where one is: of width and height, or of one of them.
const StudyParameter* size_of(const StudyPlan& plan, std::size_t& place) {
  for (std::size_t i = 0; i < plan.parameters.size(); ++i)
    for (const Field& field : plan.parameters[i].fields)
      if ((field.key == "generate.width" || field.key == "generate.height") &&
          is_number(plan.parameters[i])) {
        place = i;
        return &plan.parameters[i];
      }
  return nullptr;
}

std::string verdict(const SizeEffect& fit) {
  if (fit.bounded || !(fit.determination > 0))
    return "The members show no size at which plasticity gives way to fracture: the law fits nowhere "
           "between, so "
           "neither of its parameters means much.";
  if (fit.determination < good_fit)
    return "The law explains less than half of the variance of the peaks: take its parameters with care.";
  return "The law explains most of the variance of the peaks.";
}

}  // namespace

std::string sensitivity_section(const StudyRecord& record) {
  const auto& parameters = record.study.plan.parameters;
  if (record.results.count(MemberState::done) < least_members ||
      std::none_of(parameters.begin(), parameters.end(), has_levels))
    return "";
  return section("Sensitivities",
                 influence_charts(record) +
                     sensitivity_table(record, "Peak stress", record.results.peak_stress()) +
                     sensitivity_table(record, "Strain at the peak", record.results.peak_strain()) +
                     output::remarks(paragraph(sensitivity_caption)));
}

std::string size_section(const StudyRecord& record) {
  std::size_t place = 0;
  if (size_of(record.study.plan, place) == nullptr) return "";
  const Pairs pairs = pairs_of(record, place, record.results.peak_stress());
  if (std::set<double>(pairs.x.begin(), pairs.x.end()).size() < 2) return "";
  const SizeEffect fit = fit_size_effect(pairs.x, pairs.y);
  const std::string facts =
      output::facts_table({{"Strength of small specimens, B f", rounded(1e-6 * fit.plastic), "MPa"},
                           {"Transition size D", rounded(1e3 * fit.transition), "mm"},
                           {"Variance explained", output::percent(fit.determination)}});
  return section("Size effect",
                 output::side_by_side(
                     "lead",
                     output::chart_figure(size_chart(pairs.x, pairs.y, fit), 590, 400,
                                          "Ba\u017eant's law, strength = B f / sqrt(1 + size / D), by least "
                                          "squares. " +
                                              verdict(fit)),
                     facts));
}

}  // namespace app
