// What the features cost, as text, page and table.
#include <fmt/format.h>

#include "apps/bench/feature_study.hpp"
#include "apps/text/html.hpp"
#include "apps/report/key_figures.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/text/text.hpp"

namespace app::bench {
namespace {

constexpr const char* title = "What features cost";

double nanoseconds(double seconds) { return 1e9 * seconds; }

std::string agreement_text(const FeatureCost& cost) {
  if (!cost.same_failures) return "NO: other points fail";
  return (cost.agrees() ? "to " : "NO: off by ") + output::rounded(cost.difference, 1);
}

}  // namespace

std::string feature_text(const std::vector<FeatureCost>& costs) {
  std::string text = fmt::format("{:24} {:14} {:>8} {:>8} {:>8}   {}\n", "feature", "kinematics", "without",
                                 "with", "costs", "results agree");
  for (const FeatureCost& cost : costs)
    text += fmt::format("{:24} {:14} {:8.2f} {:8.2f} {:+8.2f}   {}\n", cost.feature, cost.kinematics,
                        nanoseconds(cost.time_without), nanoseconds(cost.time_with),
                        nanoseconds(cost.time_with - cost.time_without), agreement_text(cost));
  return text + "times in ns a point and step, on one core\n";
}

std::string feature_html(const std::vector<FeatureCost>& costs) {
  std::vector<std::vector<std::string>> rows;
  for (const FeatureCost& cost : costs)
    rows.push_back({cost.feature + ", " + cost.kinematics, cost.scene,
                    output::with_decimals(nanoseconds(cost.time_without), 2),
                    output::with_decimals(nanoseconds(cost.time_with), 2),
                    output::percent(cost.time_with / cost.time_without - 1), agreement_text(cost)});
  return output::page(
      title,
      fmt::format(
          "<header>\n<h1>{}</h1>\n<p class=\"setting\">Runs by mesopix {} of the paper's specimen that do "
          "without a feature, and the same runs with the feature compiled in all the same.</p>\n</header>\n",
          title, output::escape(output::version())) +
          output::section(
              "Nanoseconds a point and step, on one core",
              output::number_table({"Feature", "Left out where", "Without", "With", "Costs", "Results agree"},
                                   rows) +
                  "<div class=\"remarks\">\n" +
                  output::paragraph(
                      "Medians of runs that took turns. Results agree when the same points fail in the "
                      "same way and the stress differs by rounding, over its peak.") +
                  "</div>\n"));
}

std::string feature_csv(const std::vector<FeatureCost>& costs) {
  std::string csv = "feature,kinematics,scene,without_s,with_s,difference,same_failures,agrees\n";
  for (const FeatureCost& cost : costs)
    csv += fmt::format("{},{},{},{},{},{},{:d},{:d}\n", cost.feature, cost.kinematics, cost.scene,
                       output::exact(cost.time_without), output::exact(cost.time_with),
                       output::exact(cost.difference), cost.same_failures, cost.agrees());
  return csv;
}

}  // namespace app::bench
