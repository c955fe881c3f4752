/// A figure of the paper, or a few of one experiment: the runs it needs, its claims, what it makes of both.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/reproduce/trial.hpp"
#include "apps/statistics/statistics.hpp"

namespace app::reproduce {

enum class Verdict {
  agrees,
  disagrees,
  depends,  ///< holds in some of the cases that were run, or with another value of a parameter
};

struct Claim {
  std::string id;        ///< "peaks-rise-with-m"
  std::string figure;    ///< of the paper: "12"
  std::string paper;     ///< in our words
  std::string measured;  ///< made from the numbers of the run
  Verdict verdict = Verdict::disagrees;
  std::string why;  ///< how the verdict follows from the numbers
};

[[nodiscard]] std::string word_of(Verdict verdict);  ///< "agrees", "disagrees", "depends"

/// Of a claim that was tested in several cases: holds in all, in none, in some.   @pre at least one case.
[[nodiscard]] Verdict verdict_of(const std::vector<bool>& holds);

/// Of a claim about a random thing: holds in at least 80 % of the cases, in at most 20 %, or between.
[[nodiscard]] Verdict verdict_of_share(double share);

/// How much is run.
struct Effort {
  int specimens = 20;  ///< random specimens of figure 5, and strength fields of figures 8 to 11, >= 1
  int repeats = 3;     ///< random specimens per point of figures 12 to 14, >= 1
  std::vector<Setting> square;  ///< added to every run of the random specimen, e.g. to make it small
  std::vector<Setting> pair;    ///< added to every run of the two aggregates
  std::vector<double> pixel_sizes{1, 0.5, 0.25, 0.125,
                                  0.0625};  ///< of the objectivity figure, falling, >= 2 [mm]
};

/// What a figure contributes to the report.
// NOLINTNEXTLINE(bugprone-exception-escape): json's moves cannot throw, its assertions look as if they could
struct Section {
  std::string html;     ///< below the heading
  nlohmann::json data;  ///< its numbers, SI units in the keys
  std::vector<Claim> claims;
};

struct Figure {
  std::vector<std::string> ids;  ///< as a user names them: "8", "9", ...
  std::string title;
  std::function<std::vector<Trial>(const Effort&)> trials;
  /// Runs that depend on what the first ones gave; may be empty.
  std::function<std::vector<Trial>(const Effort&, const TrialResults&)> more_trials;
  /// @pre all trials are done.
  std::function<Section(const Effort&, const TrialResults&)> evaluate;
};

/// A run of the random specimen: packing and strengths of a seed.
[[nodiscard]] Trial square_trial(const Effort& effort, const std::string& scene, int seed,
                                 const std::vector<Setting>& settings = {}, bool keep_maps = false);

[[nodiscard]] Figure generation_figure();      ///< 1, 2
[[nodiscard]] Figure weibull_figure();         ///< 3
[[nodiscard]] Figure curves_figure();          ///< 5
[[nodiscard]] Figure damage_figure();          ///< 6, 7
[[nodiscard]] Figure two_aggregates_figure();  ///< 8 ... 11
[[nodiscard]] Figure modulus_figure();         ///< 12
[[nodiscard]] Figure strength_figure();        ///< 13
[[nodiscard]] Figure cohesion_figure();        ///< 14
[[nodiscard]] Figure objectivity_figure();     ///< beyond the paper
[[nodiscard]] Figure inertia_figure();         ///< beyond the paper

/// Peaks of two aggregates in the paper: [Pa], [-].
struct PaperBand {
  double least_stress = 1.40e6, largest_stress = 2.09e6, least_strain = 45.92e-6, largest_strain = 103.21e-6;
};
[[nodiscard]] bool in_paper_band(double stress, double strain);

[[nodiscard]] std::string megapascals(double stress);  ///< 3.43e6 -> "3.43 MPa"
[[nodiscard]] std::string microstrain(double strain);  ///< 149e-6 -> "149 microstrain"

/// Mean and standard deviation: "3.43 ± 0.05 MPa".
[[nodiscard]] std::string megapascals(const Spread& stress);
[[nodiscard]] std::string microstrain(const Spread& strain);

/// "one random specimen", "20 random specimens".
[[nodiscard]] std::string counted(int count, const std::string& noun);

/// Spread as JSON: mean, standard_deviation, least, largest.
[[nodiscard]] nlohmann::json json_of(const Spread& spread);

/// What the colours of the pictures mean, for the phases of a mask.
[[nodiscard]] std::string damage_legend(const specimen::LabelledMask& mask);

/// Damage at shares of the strain at the peak [%]; one that the run did not reach is left out.
/// @pre the maps of the outcome are kept.
[[nodiscard]] std::string damage_pictures(const TrialResult& outcome, const std::vector<int>& percents,
                                          const std::string& caption = "");

}  // namespace app::reproduce
