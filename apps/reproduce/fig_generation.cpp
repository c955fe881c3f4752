// Figures 1 and 2: the specimen, and how long it takes to make one.
#include <chrono>
#include <cmath>

#include "apps/drawing/picture_parts.hpp"
#include "apps/job/job.hpp"
#include "apps/job/specimen_source.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/reproduce/figure.hpp"
#include "apps/text/figures.hpp"
#include "specimen/picture/picture.hpp"

namespace app::reproduce {
namespace {

/// Of the paper.
constexpr double paper_aggregates = 73, paper_aggregate_points = 40614, paper_mortar_points = 49386,
                 paper_itz_points = 2628, paper_seconds = 600;
constexpr double tolerance = 0.01;  ///< of a count that counts as the same

struct Made {
  specimen::Specimen specimen;
  double seconds = 0;
  double aggregates = 0, aggregate_points = 0, mortar_points = 0, itz_points = 0;
};

Made make(const Effort& effort, int seed) {
  const Settings settings = settings_of(square_trial(effort, "generation", seed));
  const auto start = std::chrono::steady_clock::now();
  Made made;
  made.specimen = prepare_specimen(settings).specimen;
  made.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto pixels = specimen::count_labels(made.specimen.mask);
  made.aggregates = static_cast<double>(made.specimen.inclusions.size());
  made.aggregate_points = static_cast<double>(pixels[specimen::phase::aggregate]);
  made.mortar_points = static_cast<double>(pixels[specimen::phase::mortar]);
  made.itz_points = static_cast<double>(build_scene(made.specimen, settings).extra_points.size());
  return made;
}

/// The mask, and the extra ITZ points on it.
std::string picture(const specimen::Specimen& specimen) {
  const specimen::LabelledMask& mask = specimen.mask;
  const int factor = output::file_magnification(mask.labels.rows, mask.labels.cols);
  auto pixels = output::magnified(specimen::preview(mask), factor);
  for (const specimen::Ring& ring : specimen.rings)
    for (const specimen::Point& vertex : ring.vertices) {
      const int col = static_cast<int>(std::floor(vertex.x / mask.pixel_size * factor));
      const int row = pixels.rows - 1 - static_cast<int>(std::floor(vertex.y / mask.pixel_size * factor));
      for (int side = 0; side < 4; ++side)  // 2 x 2, or a point would hardly be seen
        if (pixels.contains(row - side / 2, col + side % 2))
          pixels(row - side / 2, col + side % 2) = specimen::phase_colour(specimen::phase::itz);
    }
  std::vector<output::LegendEntry> legend;
  for (const std::uint8_t label : {specimen::phase::aggregate, specimen::phase::mortar, specimen::phase::itz})
    legend.push_back(
        {specimen::phase_colour(label), label == specimen::phase::itz ? "ITZ points" : mask.phases[label]});
  return output::image(pixels, "The specimen with its extra ITZ points", "") +
         output::legend("below", legend);
}

std::string milliseconds(double seconds) { return output::rounded(1e3 * seconds, 2) + " ms"; }
std::string whole(double number) { return output::grouped(std::llround(number)); }

std::string table(const Made& made, double seconds) {
  const double total = made.aggregate_points + made.mortar_points + made.itz_points;
  const double paper_total = paper_aggregate_points + paper_mortar_points + paper_itz_points;
  return output::number_table(
      {"", "the paper", "this run"},
      {{"Aggregates", whole(paper_aggregates), whole(made.aggregates)},
       {"Points in the aggregate", whole(paper_aggregate_points), whole(made.aggregate_points)},
       {"Points in the mortar", whole(paper_mortar_points), whole(made.mortar_points)},
       {"Extra points in the ITZ", whole(paper_itz_points), whole(made.itz_points)},
       {"Points in all", whole(paper_total), whole(total)},
       {"Time", output::concise(paper_seconds / 60) + " min", milliseconds(seconds)}});
}

std::string points_text(double aggregate, double mortar, double itz) {
  return whole(aggregate) + " + " + whole(mortar) + " + " + whole(itz) + " points";
}

Claim count_claim(const Made& made) {
  const auto near = [](double ours, double paper) { return std::abs(ours / paper - 1) <= tolerance; };
  const std::vector<bool> holds{
      near(made.aggregates, paper_aggregates), near(made.aggregate_points, paper_aggregate_points),
      near(made.mortar_points, paper_mortar_points), near(made.itz_points, paper_itz_points)};
  Claim claim{"specimen",
              "2",
              whole(paper_aggregates) +
                  " aggregates fill 45 % of the square; aggregate, mortar and ITZ have " +
                  points_text(paper_aggregate_points, paper_mortar_points, paper_itz_points) + ".",
              whole(made.aggregates) + " aggregates; " +
                  points_text(made.aggregate_points, made.mortar_points, made.itz_points) + ".",
              verdict_of(holds),
              ""};
  claim.why = claim.verdict == Verdict::agrees
                  ? "Every count is within 1 % of the paper's. The larger number is the mortar: the paper's "
                    "first two names are swapped, as 45 % of 90 000 points are aggregate."
                  : "Not every count is within 1 % of the paper's, which gives no sizes of the aggregates.";
  return claim;
}

Claim time_claim(double seconds) {
  const bool holds = seconds <= paper_seconds;
  return {"generation-time",
          "1",
          "A specimen is made in " + output::concise(paper_seconds / 60) + " minutes.",
          "Made in " + milliseconds(seconds) + ".",
          holds ? Verdict::agrees : Verdict::disagrees,
          holds
              ? "It takes one part in " + output::rounded(paper_seconds / seconds, 1) +
                    " of the paper's time: most random places are accepted or refused by one look at the gap."
              : "It took longer than the paper's time."};
}

Section evaluate_generation(const Effort& effort, const TrialResults&) {
  const Made made = make(effort, 1);
  std::vector<double> seconds, aggregates;
  for (int seed = 1; seed <= effort.specimens; ++seed) {
    const Made other = make(effort, seed);
    seconds.push_back(other.seconds);
    aggregates.push_back(other.aggregates);
  }
  const Spread time = spread_of(seconds), count = spread_of(aggregates);
  const std::string text =
      "Random ellipses are placed largest first, at an exact gap, until they fill the share of the paper; "
      "their "
      "sizes follow a Fuller curve, as the paper gives none. " +
      counted(effort.specimens, "specimen") + " took " + output::rounded(time.low, 2) + " to " +
      output::rounded(time.high, 2) + " s each and have " + whole(count.low) + " to " + whole(count.high) +
      " aggregates.";
  return {
      output::paragraph(text) + output::side_by_side("even", picture(made.specimen), table(made, time.mean)),
      {{"aggregates", made.aggregates},
       {"aggregate_points", made.aggregate_points},
       {"mortar_points", made.mortar_points},
       {"itz_points", made.itz_points},
       {"seconds", reproduce::json_of(time)},
       {"aggregates_of_specimens", reproduce::json_of(count)}},
      {time_claim(time.mean), count_claim(made)}};
}

}  // namespace

Figure generation_figure() {
  return {{"1", "2"},
          "The specimen",
          [](const Effort&) { return std::vector<Trial>(); },
          {},
          evaluate_generation};
}

}  // namespace app::reproduce
