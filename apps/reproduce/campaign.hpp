/// All runs of the figures that were asked for, and the page and numbers that they leave.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/command/command.hpp"
#include "apps/reproduce/figure.hpp"
#include "apps/system/job_pool.hpp"

namespace app::reproduce {

/// In the order of the paper. A new figure is one more line here.
[[nodiscard]] const std::vector<Figure>& figures();

/// Figures of these ids, each once, in the order of the paper; all of them for no id.
/// @throws Rejected (Exit::usage) for an id that no figure has, naming all that there are.
[[nodiscard]] std::vector<const Figure*> select_figures(const std::vector<std::string>& ids);

/// "Figure 12", "Figures 8 to 11", "Figures 6 and 7".
[[nodiscard]] std::string name_of(const Figure& figure);

struct FigureResult {
  const Figure* figure = nullptr;
  bool done = false;  ///< false: interrupted before its runs were
  Section section;
};

struct Reproduction {
  std::vector<FigureResult> figures;
  TrialResults outcomes;
  Effort effort;
  int workers = 1;
  double wall_time = 0;  ///< [s]
  bool interrupted = false;
};

/// What the runs of figures take, where that is long: "128 runs of up to ... points and ... steps, which take
/// about 4 min here, 2 at a time". A second round counts as much as the first one. Measured within seconds;
/// empty for short ones.   @param workers  as of reproduce_figures().   @throws Rejected, mpm::Error.
[[nodiscard]] std::string announcement(const std::vector<const Figure*>& figures, const Effort& effort,
                                       int workers);

/// @param workers  runs at a time, each on one thread.   @throws the exceptions of run_trial.
[[nodiscard]] Reproduction reproduce_figures(const std::vector<const Figure*>& figures, const Effort& effort,
                                             int workers, const Watch& watch);

/// Claims of the figures that are done, in their order.
[[nodiscard]] std::vector<Claim> claims_of(const Reproduction& reproduction);

/// report.html: claims and verdicts, then each figure; one page that needs no network.
[[nodiscard]] std::string report_html(const Reproduction& reproduction);

/// reproduction.json: claims, the numbers of each figure, every run with its command.
[[nodiscard]] nlohmann::json report_json(const Reproduction& reproduction);

/// "6 agree with this run, 2 disagree and 1 depend on a choice or on chance".
[[nodiscard]] std::string verdict_counts(const std::vector<Claim>& claims);

}  // namespace app::reproduce

namespace app {

[[nodiscard]] CommandPointer reproduce_command(CLI::App& program);

}  // namespace app
