/// A run that was never computed but could have been: for tests of what is written about runs.
#pragma once

#include "apps/report/run_record.hpp"

/// Owner of what a RunRecord refers to.
struct FakeRun {
  specimen::Specimen specimen;
  mpm::Scene scene;
  mpm::Result result;
  std::string scene_toml;

  [[nodiscard]] RunRecord record() const;
};

/// A tension test of a square of 150 mm with round aggregates, `pixels` a side, cracked across at mid-height.
/// @param end_percent  where it stopped [% of the peak strain].
[[nodiscard]] FakeRun tension_run(int pixels, int end_percent = 280);

/// A mask of given rows of digits (labels), pixels of 1 mm, nothing failed, no history.
[[nodiscard]] FakeRun still_run(const std::vector<std::string>& rows);

/// A flight at 15 m/s against a rough wall at the bottom, after which everything is 20 mm higher up and the
/// half above the crack 10 mm more; points of the first column have left.
[[nodiscard]] FakeRun impact_run(int pixels);

/// The same under compression with crack closure: shear failures, crushed points, extra ITZ points.
[[nodiscard]] FakeRun compression_run(int pixels);
