#include "apps/drawing/damage_stages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/text/text.hpp"

namespace output {
namespace {

double largest_strain(const mpm::Result& result) {
  double largest = 0;
  for (const mpm::HistoryRow& row : result.history)
    if (std::isfinite(row.strain)) largest = std::max(largest, row.strain);
  return largest;
}

DamageStage stage_at(const mpm::Result& result, int percent) {
  DamageStage stage{percent, percent / 100.0 * result.peak_strain, 0, 0};
  const auto strain = static_cast<float>(stage.strain);
  for (Eigen::Index i = 0; i < result.failure_strain.size(); ++i) {
    const bool failed = result.failure_strain.data()[i] <= strain;
    const auto mode = static_cast<mpm::FailureMode>(result.failure_mode.data()[i]);
    stage.tension += failed && mode == mpm::FailureMode::tension;
    stage.shear += failed && mode == mpm::FailureMode::shear;
    stage.shear += result.crush_strain.size() > 0 && result.crush_strain.data()[i] <= strain;
  }
  return stage;
}

}  // namespace

DamageStages damage_stages(const mpm::Result& result) {
  DamageStages stages;
  const bool has_peak = std::isfinite(result.peak_strain) && result.peak_strain > 0;
  stages.reached = has_peak ? largest_strain(result) / result.peak_strain : 0;
  for (const int percent : stage_percents)
    if (percent <= 100 * stages.reached * (1 + 1e-6))  // the last row may miss a round strain by round-off
      stages.drawn.push_back(stage_at(result, percent));
    else
      stages.missing.push_back(percent);
  return stages;
}

std::string missing_note(const DamageStages& stages) {
  if (stages.missing.empty()) return "";
  if (stages.reached == 0) return "The run has no peak stress, so no picture of damage was drawn.";
  std::vector<std::string> percents;
  for (const int percent : stages.missing) percents.push_back(fmt::format("{} %", percent));
  return fmt::format("The run ended at {:.0f} % of the peak strain: there is no picture of damage at {}.",
                     std::floor(100 * stages.reached * (1 + 1e-6)), listed(percents));
}

std::string picture_name(int percent, bool colour) {
  return fmt::format("damage_{:03}{}.png", percent, colour ? "_colour" : "");
}

}  // namespace output
