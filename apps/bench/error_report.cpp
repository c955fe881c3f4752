#include "apps/bench/error_study.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include "apps/text/version.hpp"
#include "apps/text/words.hpp"

#include "apps/drawing/chart.hpp"
#include "apps/drawing/drawing_files.hpp"
#include "apps/report/key_figures.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/report/run_words.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/markup.hpp"

namespace app::bench {
namespace {

using output::escape;

constexpr std::array tolerances{0.05, 0.01, 0.001};
constexpr double chart_width = 640, chart_height = 440;  // [px]
constexpr const char* error_title = "Error against run time";

/// "0.83 %", "12 %", "3.1 × 10⁻¹² %".
std::string error_text(double error) { return output::rounded(100 * error, 2) + " %"; }
std::string order_text(double order) {
  return std::isfinite(order) ? output::with_decimals(order, 1) : std::string("none");
}

/// "12 ms", "3.4 s".
std::string time_text(double seconds) {
  return seconds < 1 ? output::rounded(1e3 * seconds, 2) + " ms" : output::rounded(seconds, 3) + " s";
}

/// "1/64 of the width", "0.5 mm".
std::string size_text(const Method& method, double size) {
  if (!method.unit.empty()) return output::concise(size) + " " + method.unit;
  return fmt::format("1/{:.0f}", 1 / size);
}

std::string way_text(const Cheapest& way) {
  return fmt::format("{}, {} {}", way.method->name, way.method->refined,
                     size_text(*way.method, way.sample->size));
}

/// What a run costs, as an axis.
struct Cost {
  const char* name;
  output::Axis axis;
  double (*of)(const Sample&);
};
const Cost wall_time{
    "wall time", {"Wall time", "s", true}, [](const Sample& sample) { return sample.wall_time; }};
const Cost point_updates{"point-updates", {"Point-updates", "", true}, [](const Sample& sample) {
                           return static_cast<double>(sample.point_updates);
                         }};

output::Chart chart_of(const ProblemResult& result, const Cost& cost) {
  output::Chart chart{fmt::format("Error against {}: {}", cost.name, result.problem.title),
                      cost.axis,
                      {"Error", "", true},
                      {},
                      {}};
  for (std::size_t i = 0; i < result.methods.size(); ++i) {
    const MethodResult& method = result.methods[i];
    output::Series series{
        method.method->name, {}, {}, output::ink_of_series(i), i / output::series_inks % 2 == 1, true};
    for (const Sample& sample : method.samples) {
      series.x.push_back(cost.of(sample));
      series.y.push_back(sample.error);
      if (sample.in_front) chart.markers.push_back({cost.of(sample), sample.error, ""});
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

std::vector<std::string> table_row(const MethodResult& result) {
  const Method& method = *result.method;
  std::string errors;
  for (const Sample& sample : result.samples)
    errors +=
        (errors.empty() ? "" : "  →  ") + (sample.trouble.empty() ? error_text(sample.error) : "stopped");
  return {method.name,
          method.refined + " " + size_text(method, method.sizes.front()) + " … " +
              size_text(method, method.sizes.back()),
          errors, order_text(result.order), time_text(result.samples.back().wall_time)};
}

std::string troubles_of(const ProblemResult& result) {
  std::string text;
  for (const MethodResult& method : result.methods)
    for (const Sample& sample : method.samples)
      if (!sample.trouble.empty())
        text += output::paragraph(fmt::format("{}, {} {}, stopped: {}.", method.method->name,
                                              method.method->refined, size_text(*method.method, sample.size),
                                              sample.trouble));
  return text;
}

std::string problem_html(const ProblemResult& result) {
  const Problem& problem = result.problem;
  std::vector<std::vector<std::string>> rows;
  for (const MethodResult& method : result.methods) rows.push_back(table_row(method));
  std::string answer = "Right answer: " + problem.answer;
  if (problem.reference) answer += fmt::format("; it took {}", time_text(result.reference_time));
  return output::section(
      problem.title,
      output::paragraph(output::capitalised(problem.quantity) + ". " + answer + ".") +
          output::chart_figure(chart_of(result, wall_time), chart_width, chart_height,
                               "Along a line the problem is refined. A black dot: no other run is "
                               "both faster and more exact.") +
          "<details><summary>The same against the number of point-updates, which no machine "
          "changes</summary>\n" +
          output::chart_figure(chart_of(result, point_updates), chart_width, chart_height,
                               "Black dots: the runs that are in front by wall time.") +
          "</details>\n" + output::number_table({"", "From … to", "Error", "Order", "Finest takes"}, rows) +
          output::remarks(output::paragraph(problem.remark) + troubles_of(result)));
}

/// "GIMP MUSL FLIP, cell 1/32, in 12 ms", or how near it came.
std::string cheapest_text(const ProblemResult& result, double tolerance) {
  const Cheapest way = cheapest_within(result, tolerance);
  if (way.sample != nullptr) return way_text(way) + ": " + time_text(way.sample->wall_time);
  const Cheapest best = most_exact(result);
  return best.sample == nullptr ? "none" : "none; the best is " + error_text(best.sample->error);
}

std::string cheapest_table(const std::vector<ProblemResult>& results) {
  std::vector<std::string> head{"Problem"};
  for (const double tolerance : tolerances)
    head.push_back("Error of " + output::concise(100 * tolerance) + " %");
  std::string rows;
  for (const ProblemResult& result : results) {
    rows += fmt::format("<tr><th scope=\"row\">{}</th>", escape(result.problem.title));
    for (const double tolerance : tolerances)
      rows += fmt::format("<td>{}</td>", escape(cheapest_text(result, tolerance)));
    rows += "</tr>\n";
  }
  return output::table("claims", head, rows);
}

}  // namespace

std::string error_html(const std::vector<ProblemResult>& results) {
  std::string html = output::heading(
      error_title,
      fmt::format(
          "Problems with a known answer, and concrete against a slow and fine run, solved in many ways by "
          "mesopix {}. Each run had one thread and the machine to itself; its time is that of its time "
          "loop. Order: the power of the size with which the error falls; none where fewer than three runs "
          "came to their end, or the error does not fall from each to the next, for then it does not follow "
          "the size.",
          version()));
  for (const ProblemResult& result : results) html += problem_html(result);
  return output::page(error_title, html + output::section("The cheapest way", cheapest_table(results)));
}

std::string error_png(const ProblemResult& result) {
  return output::png_of(output::lay_out(chart_of(result, wall_time), chart_width, chart_height), 2, 12);
}

std::string error_csv(const std::vector<ProblemResult>& results) {
  std::string csv = "problem,method,refined,size,unit,error,wall_time_s,point_updates,order,front,trouble\n";
  for (const ProblemResult& result : results)
    for (const MethodResult& method : result.methods)
      for (const Sample& sample : method.samples)
        csv += fmt::format("{},\"{}\",{},{},{},{},{},{},{},{},\"{}\"\n", result.problem.name,
                           method.method->name, method.method->refined, output::exact(sample.size),
                           method.method->unit, output::exact(sample.error), output::exact(sample.wall_time),
                           sample.point_updates, output::exact(method.order), sample.in_front ? 1 : 0,
                           sample.trouble);
  return csv;
}

std::string error_text(const std::vector<ProblemResult>& results) {
  std::string text;
  for (const ProblemResult& result : results)
    for (const double tolerance : tolerances)
      text += fmt::format("{:13} {:>5} %   {}\n", result.problem.name, output::concise(100 * tolerance),
                          cheapest_text(result, tolerance));
  return text;
}

}  // namespace app::bench
