/// What a run leaves on disk: one folder that explains itself.
#pragma once

#include <filesystem>

#include "apps/report/run_record.hpp"

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
/// Frames of the points are written there before, while the run goes on: see apps/run/frame_folder.hpp; so
/// are its checkpoints: see apps/run/checkpoint_folder.hpp. A damage picture beyond the strain that the run
/// reached is left out, and report and summary say so. Every file is written to a temporary name beside it,
/// then renamed: no half-written file carries a final name. Files of an earlier run of the same names are
/// replaced; pictures that this run has not are removed, and so are maps that mesopix export has made of that
/// run. What cannot be made again from the rest comes first, and every file is tried, whatever became of the
/// others.
/// @throws NotWritten (apps/system/files.hpp) with the files that are missing, when the disk fails.
void write_run(const std::filesystem::path& folder, const RunRecord& record);

/// All of them but result.h5, which stays as it is, and the maps.   @throws as write_run().
void write_run_again(const std::filesystem::path& folder, const RunRecord& record);

/// The first act of a run in the folder of an earlier one: the new scene takes the place of the old, and then
/// all results go, and the new specimen takes the place of the old. Whenever it is cut off, the folder holds
/// one run, or results that check_one_run() refuses. Does nothing where there are no results.
/// @throws mpm::FileError; then the old results are as they were, or some of them are gone; specimen::Error.
void retire_results(const std::filesystem::path& folder, const std::string& scene_toml,
                    const specimen::Specimen& specimen);
