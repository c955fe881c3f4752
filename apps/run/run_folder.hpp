/// What a run leaves on disk: one folder that explains itself.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/report/error_estimate.hpp"
#include "libmpm/scene/result.hpp"
#include "libmpm/scene/scene.hpp"
#include "specimen/body/specimen.hpp"

/// A run, as the files of its folder need it: finished, or looked at on its way.
struct RunRecord {
  const specimen::Specimen& specimen;  ///< what was broken; its mask has the shape of the scene's labels
  const mpm::Scene& scene;             ///< as it was solved
  const mpm::Result& result;
  std::string scene_toml;                     ///< the resolved scene, every default written out
  std::string scene_hash;                     ///< SHA-256 of scene_toml, lower-case hexadecimal
  std::string title;                          ///< the user's own words; escaped wherever it is shown
  std::vector<std::string> notes;             ///< what was guessed or cut short, one sentence each
  output::ErrorEstimate error_estimate = {};  ///< of the peak; without sources when none was asked for
  bool goes_on = false;                       ///< the run is not over yet
};

/// Write a run folder, creating it where it is missing:
///   curve.csv      history, SI units in the names of the columns
///   result.h5      history, failure maps and scalars (mpm::write_result)
///   specimen.h5    what was broken (specimen::write_specimen)
///   summary.json   summary() of the run
///   scene.toml     the resolved scene
///   specimen.png   preview of the mask
///   damage_025.png ... damage_150.png            damage at 25 ... 150 % of the peak strain, in greys
///   damage_025_colour.png ... damage_150_colour.png   the same over the colours of the phases
///   deformed.png, deformed_colour.png            with moving points: where they are at the end
///   curve.png      stress against strain
///   report.html    all of it on one page that needs no network
/// Frames of the points are written there before, while the run goes on: see apps/run/frame_folder.hpp; so are
/// its checkpoints: see apps/run/checkpoint_folder.hpp.
/// A damage picture beyond the strain that the run reached is left out, and report and summary say so.
/// Every file is written to a temporary name beside it, then renamed: no half-written file carries a final
/// name. Files of an earlier run of the same names are replaced; pictures that this run has not are removed,
/// and so are maps that mesopix export has made of that run. What cannot be made again from the rest comes
/// first, and every file is tried, whatever became of the others.
/// @throws NotWritten (apps/system/attempts.hpp) with the files that are missing, when the disk fails.
void write_run(const std::filesystem::path& folder, const RunRecord& record);

/// Key figures of a run in SI units, as summary.json holds them; figures that are not finite are null in
/// its text.
[[nodiscard]] nlohmann::json summary(const RunRecord& record);
