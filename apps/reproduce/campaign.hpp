/// All runs of the figures that were asked for, and what the figures make of them.
#pragma once

#include <functional>
#include <vector>

#include "apps/reproduce/figure.hpp"

namespace app::reproduce {

struct FigureResult {
  const Figure* figure = nullptr;
  bool done = false;  ///< false: interrupted before its runs were
  Section section;
};

struct Reproduction {
  std::vector<FigureResult> figures;
  Outcomes outcomes;
  Study study;
  int workers = 1;
  double wall_time = 0;  ///< [s]
  bool interrupted = false;
};

struct CampaignWatch {
  std::function<void(std::size_t done, std::size_t all)> run_done;  ///< by one thread at a time
  std::function<bool()> go_on;                                      ///< asked by all threads
};

/// @param workers  runs at a time, each on one thread.   @throws the exceptions of run_trial.
[[nodiscard]] Reproduction reproduce_figures(const std::vector<const Figure*>& figures, const Study& study,
                                             int workers, const CampaignWatch& watch);

/// Claims of the figures that are done, in their order.
[[nodiscard]] std::vector<Claim> claims_of(const Reproduction& reproduction);

}  // namespace app::reproduce
