/// A figure of the paper, or a few that show one experiment: which runs it needs and what it makes of them.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/reproduce/claim.hpp"
#include "apps/reproduce/trial.hpp"

namespace app::reproduce {

/// How much is run.
struct Study {
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
  std::function<std::vector<Trial>(const Study&)> trials;
  /// Runs that depend on what the first ones gave; may be empty.
  std::function<std::vector<Trial>(const Study&, const Outcomes&)> more_trials;
  /// @pre all trials are done.
  std::function<Section(const Study&, const Outcomes&)> evaluate;
};

/// A run of the random specimen: packing and strengths of a seed.
[[nodiscard]] Trial square_trial(const Study& study, const std::string& scene, int seed,
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

}  // namespace app::reproduce
