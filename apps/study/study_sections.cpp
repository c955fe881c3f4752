#include "apps/study/study_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include "apps/text/words.hpp"

#include "apps/drawing/ticks.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/report/run_words.hpp"
#include "apps/statistics/statistics.hpp"
#include "apps/study/study_charts.hpp"
#include "apps/study/study_values.hpp"
#include "apps/text/figures.hpp"

namespace app {
namespace {

using output::Fact;
using output::rounded;
using output::section;

constexpr std::size_t most_rows = 20;       ///< of a table by points
constexpr std::size_t least_for_shape = 5;  ///< values for a histogram and a Weibull fit
constexpr double good_half_width = 0.02;    ///< of the mean, that a reader may ask for
constexpr std::size_t most_mean_curves = 5;

bool has_one_point(const StudyRecord& record) { return record.study.plan.parameters.empty(); }

/// In MPa, of those that are done.
std::vector<double> stresses(const StudyRecord& record) {
  std::vector<double> values = finite_of(record.results.peak_stress());
  for (double& value : values) value *= 1e-6;
  return values;
}

output::StrainUnit unit_of(const StudyRecord& record) {
  double largest = 0;
  for (const double strain : finite_of(record.results.peak_strain())) largest = std::max(largest, strain);
  return output::strain_unit(largest);
}

std::vector<double> strains(const StudyRecord& record) {
  std::vector<double> values = finite_of(record.results.peak_strain());
  const double per_strain = unit_of(record).per_strain;
  for (double& value : values) value *= per_strain;
  return values;
}

std::string stress_name(const StudyRecord& record) {
  return output::has_platens(record.scene) ? "peak stress" : "peak " + output::name_of_stress(record.scene);
}

std::vector<Fact> facts_of(const std::string& name, const std::vector<double>& values,
                           const std::string& unit) {
  const MeanEstimate estimate = mean_estimate(values);
  const Spread spread = spread_of(values);
  return {{"Mean " + name, rounded(estimate.mean, 4), unit},
          {"95 % confidence interval of it", "± " + rounded(estimate.half_width), unit},
          {"Standard deviation", rounded(estimate.deviation), unit},
          {"Coefficient of variation", rounded(100 * estimate.deviation / estimate.mean), "%"},
          {"Least, largest", rounded(spread.low) + ", " + rounded(spread.high), unit}};
}

std::string one_point_peaks(const StudyRecord& record) {
  const std::vector<double> stress = stresses(record), strain = strains(record);
  std::vector<Fact> facts = facts_of(stress_name(record), stress, "MPa");
  for (Fact& fact : facts_of("strain at the peak", strain, unit_of(record).name)) facts.push_back(fact);
  facts.insert(facts.begin(),
               {"Members", output::grouped(static_cast<std::int64_t>(stress.size())), "members"});
  if (stress.size() < least_for_shape) return output::facts_table(facts);
  return output::side_by_side(
      "lead",
      output::chart_figure(histogram_chart(stress, output::capitalised(stress_name(record)), "MPa"), 590, 360,
                           "Members by their peak."),
      output::facts_table(facts));
}

/// The first member of each point.
std::vector<const Member*> points(const StudyRecord& record) {
  std::vector<const Member*> first;
  for (const Member& member : record.members)
    if (member.point == first.size()) first.push_back(&member);
  return first;
}

std::vector<std::vector<double>> by_point(const StudyRecord& record, const std::vector<double>& values) {
  std::vector<std::vector<double>> groups(points(record).size());
  for (const Member& member : record.members)
    if (std::isfinite(values[member.number])) groups[member.point].push_back(values[member.number]);
  return groups;
}

/// "loading.velocity (m/s)".
std::string title_of(const StudyParameter& parameter) {
  const std::string unit = is_number(parameter) ? readable_unit(parameter).name : "";
  return parameter.name + (unit.empty() ? "" : " (" + unit + ")");
}

std::string cell_of(const StudyParameter& parameter, const Value& value) {
  return is_number(parameter)
             ? output::concise(readable_unit(parameter).per_si * number_of(parameter, value), 5)
             : text_of(parameter, value);
}

/// The scatter is left out where points have one member each.
std::vector<std::string> point_head(const StudyRecord& record, const output::StrainUnit& unit) {
  const std::size_t seeds = record.study.plan.seeds.size();
  std::vector<std::string> head{"Point"};
  for (const StudyParameter& parameter : record.study.plan.parameters) head.push_back(title_of(parameter));
  if (seeds > 1) head.emplace_back("Members");
  head.emplace_back(seeds > 1 ? "Mean peak (MPa)" : "Peak (MPa)");
  if (seeds > 1) head.insert(head.end(), {"95 % interval (± MPa)", "Deviation (MPa)"});
  if (seeds >= least_for_shape) head.emplace_back("Weibull modulus");
  head.push_back((seeds > 1 ? "Mean strain (" : "Strain (") + unit.name + ")");
  return head;
}

std::vector<std::string> point_row(const StudyRecord& record, const Member& point,
                                   const std::vector<double>& stress, const std::vector<double>& strain,
                                   const output::StrainUnit& unit) {
  const std::size_t seeds = record.study.plan.seeds.size();
  const MeanEstimate estimate = mean_estimate(stress);
  const bool shape = stress.size() >= least_for_shape && spread_of(stress).low > 0;
  std::vector<std::string> row{std::to_string(point.point)};
  for (std::size_t i = 0; i < point.values.size(); ++i)
    row.push_back(cell_of(record.study.plan.parameters[i], point.values[i]));
  if (seeds > 1) row.push_back(std::to_string(stress.size()));
  row.push_back(rounded(1e-6 * estimate.mean));
  if (seeds > 1) {
    row.push_back(rounded(1e-6 * estimate.half_width));
    row.push_back(stress.size() > 1 ? rounded(1e-6 * estimate.deviation) : "\u2013");
  }
  if (seeds >= least_for_shape) row.push_back(shape ? rounded(fit_weibull(stress).modulus) : "\u2013");
  row.push_back(rounded(unit.per_strain * spread_of(strain).mean));
  return row;
}

std::string peaks_by_point(const StudyRecord& record) {
  const auto stress = by_point(record, record.results.peak_stress());
  const auto strain = by_point(record, record.results.peak_strain());
  const output::StrainUnit unit = unit_of(record);
  std::vector<std::vector<std::string>> rows;
  for (const Member* point : points(record))
    if (rows.size() < most_rows)
      rows.push_back(point_row(record, *point, stress[point->point], strain[point->point], unit));
  std::string html = output::number_table(point_head(record, unit), rows);
  if (stress.size() > most_rows)
    html += output::remarks(output::paragraph(
        fmt::format("The first {} of {} points; all members stand in table.csv.", most_rows, stress.size())));
  return html;
}

std::string shape_text(const WeibullFit& fit, double distance) {
  const double critical = critical_distance(fit.count);
  return fmt::format(
      "The largest distance between the members and the line is {} (Kolmogorov and Smirnov); {} members of "
      "the distribution exceed {} in 5 of 100 cases, and fewer where it was fitted to them. So the peaks {}. "
      "Errors are standard errors.",
      rounded(distance, 2), fit.count, rounded(critical, 2),
      distance < critical ? "may well follow it" : "do not follow it");
}

}  // namespace

std::string peaks_section(const StudyRecord& record) {
  if (record.results.count(MemberState::done) == 0) return "";
  const std::string without = without_peak_text(record.results);
  const std::string note = without.empty() ? "" : output::paragraph(output::capitalised(without) + ".");
  if (record.results.without_peak() == record.results.count(MemberState::done)) return section("Peaks", note);
  return section("Peaks", note + (has_one_point(record) ? one_point_peaks(record) : peaks_by_point(record)));
}

std::string weibull_section(const StudyRecord& record) {
  const std::vector<double> values = stresses(record);
  if (!has_one_point(record) || values.size() < least_for_shape || !(spread_of(values).low > 0)) return "";
  const WeibullFit fit = fit_weibull(values);
  if (!std::isfinite(fit.modulus)) return "";
  const double distance =
      largest_distance(values, [&](double x) { return weibull_distribution(x, fit.scale, fit.modulus); });
  const std::string facts = output::facts_table(
      {{"Weibull modulus", rounded(fit.modulus) + " ± " + rounded(fit.modulus * fit.modulus_error(), 2)},
       {"Scale", rounded(fit.scale, 4), "MPa"},
       {"5 % of the members are below", rounded(fit.quantile(0.05), 4), "MPa"},
       {"Standard error of that", "± " + rounded(fit.quantile(0.05) * fit.log_error(0.05), 2), "MPa"}});
  return section(
      "Weibull distribution of the peaks",
      output::side_by_side("lead",
                           output::chart_figure(weibull_chart(values, fit, stress_name(record), "MPa"), 590,
                                                400, shape_text(fit, distance)),
                           facts));
}

std::string convergence_section(const StudyRecord& record) {
  const std::vector<double> values = stresses(record);
  if (!has_one_point(record) || values.size() < 3) return "";
  const MeanEstimate estimate = mean_estimate(values);
  const std::string needed = fmt::format(
      "With {} members the mean is known to ± {}. To know it to ± {} takes about {}.", values.size(),
      output::percent(estimate.relative_half_width()), output::percent(good_half_width, 0),
      output::grouped(static_cast<std::int64_t>(values_needed(estimate, good_half_width))));
  return section(
      "How the mean settles",
      output::chart_figure(convergence_chart(values, output::capitalised(stress_name(record)), "MPa"), 590,
                           300, needed));
}

std::string curves_section(const StudyRecord& record) {
  const auto first = points(record);
  std::vector<std::vector<Curve>> groups(first.size());
  for (const Member& member : record.members)
    groups[member.point].push_back(record.results.curves[member.number]);
  if (record.results.count(MemberState::done) == 0) return "";
  const bool means = groups.size() <= most_mean_curves;
  std::vector<std::string> names;
  for (const Member* point : first) {
    std::string name;
    for (std::size_t i = 0; i < point->values.size(); ++i)
      name += (name.empty() ? "" : ", ") + text_of(record.study.plan.parameters[i], point->values[i]);
    names.push_back(name.empty() ? "mean" : "mean, " + name);
  }
  if (!means) {  // their means would hide each other
    std::vector<Curve> all;
    for (const auto& group : groups) all.insert(all.end(), group.begin(), group.end());
    groups = {all};
    names = {"mean of all"};
  }
  return section(
      "Curves",
      output::chart_figure(
          curves_chart(names, groups, output::capitalised(output::name_of_stress(record.scene)),
                       output::capitalised(output::name_of_strain(record.scene))),
          590, 420,
          "Means and bands go as far as all members do. " + output::meaning_of_curve(record.scene)));
}

bool varies_pixels(const StudyPlan& plan) {
  for (const StudyParameter& parameter : plan.parameters)
    for (const Field& field : parameter.fields) {
      const std::string leaf = leaf_of(field.key), group = group_of(field.key);
      if (group == "specimen" || leaf == "width" || leaf == "height" || leaf == "pixel_size" ||
          leaf == "pixels" || leaf == "crop")
        return true;
    }
  return false;
}

}  // namespace app
