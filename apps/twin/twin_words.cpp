#include "apps/twin/twin_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/text/words.hpp"

namespace app {
namespace {

constexpr double millimetre = 1e-3;

std::string fixed(double value, int decimals) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, decimals) : "-";
}

std::string mm(double length) { return fmt::format("{:.4g} mm", length / millimetre); }

std::string percent(double share) { return fmt::format("{:.1f} %", 100 * share); }

/// Without a sign before nought.
std::string with_sign(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  const std::string text = fmt::format("{:+.{}f}", value, decimals);
  return text.find_first_of("123456789") == std::string::npos ? text.substr(1) : text;
}

/// @param unit  of the figure in SI units, as shown.
FigureRow figure_row(const std::string& name, const specimen::FigureMisfit& misfit, double unit,
                     int decimals) {
  const auto text = [&](double value) { return fixed(value / unit, decimals); };
  const double difference = misfit.difference() / unit;
  return {name,
          text(misfit.original),
          text(misfit.mean),
          text(misfit.deviation),
          text(misfit.least) + " to " + text(misfit.largest),
          with_sign(difference, decimals)};
}

CurveRow curve_row(const std::string& name, const specimen::CurveMisfit& misfit, double unit, int decimals) {
  const auto text = [&](double value) { return fixed(value / unit, decimals); };
  const bool judged = std::isfinite(misfit.largest);
  return {name, text(misfit.original), text(misfit.mean), text(misfit.largest),
          !judged           ? ""
          : misfit.within() ? "within the twins"
                            : "farther than any twin"};
}

FigureRow direction_row(const TwinTask& task, const specimen::Misfit& misfit) {
  constexpr double degree = std::numbers::pi / 180;
  const double original = task.descriptors.orientation.direction;
  const double difference = std::remainder(misfit.direction - original, std::numbers::pi);
  return {"Direction of the long axes (degrees)",
          fixed(original / degree, 0),
          fixed(misfit.direction / degree, 0),
          "-",
          "-",
          with_sign(difference / degree, 0)};
}

std::string border_note(const TwinTask& task) {
  const specimen::AggregateSample& sample = task.descriptors.sample;
  const bool made_cut = task.plan.cut;
  if (sample.cut == 0)
    return "the border cuts no aggregate, so that it is taken for a wall; aggregates of the twins " +
           std::string(made_cut ? "are cut all the same, as was asked for" : "lie whole inside too");
  std::string text = fmt::format("the border cuts {}, with {} of the aggregate area; ",
                                 counted(sample.cut, "aggregate"), percent(sample.cut_share));
  if (sample.whole() > 0)
    text += fmt::format("sizes and shapes are those of {}, weighted against that loss; ",
                        counted(sample.whole(), "whole one"));
  if (sample.parts > 0)
    text += fmt::format(
        "{} of the cut ones, of which more is seen than the largest whole one has, count{} with "
        "what is seen, and a larger picture would tell more; ",
        sample.parts, sample.parts == 1 ? "s" : "");
  return text + (made_cut ? "the border of the twins cuts aggregates too"
                          : "twins have theirs whole, as was asked for");
}

std::string direction_note(const TwinTask& task) {
  const specimen::Orientation& found = task.descriptors.orientation;
  const std::string test =
      fmt::format("Rayleigh test on doubled angles: {}",
                  found.probability < 0.001 ? "p < 0.001" : fmt::format("p = {:.3f}", found.probability));
  return task.plan.oriented
             ? fmt::format(
                   "long axes point to {:.0f} degrees with strength {:.2f} ({}): twins keep their directions",
                   found.direction * 180 / std::numbers::pi, found.strength, test)
             : fmt::format("long axes have no direction in common ({}): those of the twins are random", test);
}

std::string gap_note(const TwinTask& task) {
  const double usual = specimen::usual_gap(task.descriptors);
  const std::string measured =
      fmt::format("all but one in twenty aggregates of the original keep {} to their neighbours", mm(usual));
  return task.plan.gap == usual ? measured + ", as those of the twins do"
                                : measured + ", those of the twins " + mm(task.plan.gap);
}

std::int64_t count_relaxed(const std::vector<TwinRecord>& twins) {
  return std::count_if(twins.begin(), twins.end(), [](const TwinRecord& twin) { return twin.relaxed; });
}

int most_lost(const std::vector<TwinRecord>& twins) {
  int most = 0;
  for (const TwinRecord& twin : twins) most = std::max(most, twin.lost);
  return most;
}

}  // namespace

std::vector<FigureRow> figure_rows(const TwinTask& task, const specimen::Misfit& misfit) {
  std::vector<FigureRow> rows{
      figure_row("Aggregate fraction (%)", misfit.fraction, 0.01, 2),
      figure_row("Median diameter, by area (mm)", misfit.median_diameter, millimetre, 2),
      figure_row("Mean aspect ratio, by area", misfit.mean_aspect, 1, 3),
      figure_row("Strength of the direction", misfit.strength, 1, 3)};
  if (task.plan.oriented) rows.push_back(direction_row(task, misfit));
  rows.push_back(figure_row("Mean distance to the nearest neighbour (mm)", misfit.mean_gap, millimetre, 2));
  rows.push_back(figure_row("Aggregate boundary over area (1/mm)", misfit.specific_perimeter, 1e3, 4));
  return rows;
}

std::vector<CurveRow> curve_rows(const specimen::Misfit& misfit) {
  return {curve_row("Size curve, largest difference (% of the area)", misfit.sizes, 0.01, 1),
          curve_row("Size curve, mean difference (mm)", misfit.sizes_mean, millimetre, 2),
          curve_row("Nearest neighbours, largest difference (%)", misfit.gaps, 0.01, 1),
          curve_row("S2, root mean square (%)", misfit.s2_rms, 0.01, 2),
          curve_row("S2, largest difference (%)", misfit.s2_largest, 0.01, 2),
          curve_row("S2 along x, root mean square (%)", misfit.s2_along_x_rms, 0.01, 2),
          curve_row("S2 along y, root mean square (%)", misfit.s2_along_y_rms, 0.01, 2)};
}

std::vector<std::string> twin_notes(const TwinTask& task, const std::vector<TwinRecord>& twins) {
  constexpr std::size_t few = 30;
  const specimen::Descriptors& original = task.descriptors;
  std::vector<std::string> notes{border_note(task), direction_note(task), gap_note(task)};
  if (original.sample.aggregates.size() < few)
    notes.push_back(fmt::format("sizes and shapes are those of {} only: their tails are not known",
                                counted(std::ssize(original.sample.aggregates), "aggregate")));
  if (original.merged > 0)
    notes.push_back(
        fmt::format("{} of the original {} so far from convex that each may be several that touch; "
                    "--split-touching cuts a picture's at their necks",
                    counted(original.merged, "aggregate"), original.merged == 1 ? "is" : "are"));
  if (original.void_fraction > 0)
    notes.push_back(percent(original.void_fraction) +
                    " of the original are voids, which twins do not have: there is mortar in their place; "
                    "--crop leaves out what "
                    "lies outside of the concrete");
  if (const std::int64_t relaxed = count_relaxed(twins); relaxed > 0)
    notes.push_back(fmt::format("{} did not fit by plain placement; overlaps were pushed apart",
                                counted(relaxed, "twin")));
  if (const int lost = most_lost(twins); lost > 0)
    notes.push_back(fmt::format("up to {} of a twin are smaller than its pixels and left out",
                                counted(lost, "aggregate")));
  return notes;
}

std::string twins_text(const TwinTask& task, std::size_t count) {
  const specimen::TwinPlan& plan = task.plan;
  return fmt::format("{} of {}, {} x {}, pixels of {}, seed{}",
                     counted(static_cast<std::int64_t>(count), "twin"), task.name, mm(plan.width),
                     mm(plan.height), mm(plan.pixel_size),
                     count == 1 ? fmt::format(" {}", task.seed)
                                : fmt::format("s {} to {}", task.seed, task.seed + count - 1));
}

std::vector<std::string> misfit_lines(const TwinTask& task, const specimen::Misfit& misfit) {
  std::vector<std::string> lines{fmt::format("  {:<46} {:>9} {:>9} {:>9}  {:<18} {}", "", "original", "twins",
                                             "scatter", "range", "off by")};
  for (const FigureRow& row : figure_rows(task, misfit))
    lines.push_back(fmt::format("  {:<46} {:>9} {:>9} {:>9}  {:<18} {}", row.name, row.original, row.mean,
                                row.deviation, row.range, row.difference));
  lines.push_back(fmt::format("  {:<46} {:>9} {:>9} {:>9}", "off the mean of the (other) twins", "original",
                              "twins", "farthest"));
  for (const CurveRow& row : curve_rows(misfit))
    lines.push_back(fmt::format("  {:<46} {:>9} {:>9} {:>9}  {}", row.name, row.original, row.mean,
                                row.largest, row.verdict));
  return lines;
}

}  // namespace app
