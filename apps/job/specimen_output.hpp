/// What generate and convert leave: a specimen file or a label picture, and the figures of the specimen.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/system/console.hpp"
#include "apps/job/specimen_source.hpp"
#include "specimen/pack/grading.hpp"

namespace app {

/// Endings of the names of files that can be written: .h5 and those of label pictures.
/// @throws Rejected (Exit::usage) for another ending, and for a file that would overwrite `input`.
void check_output(const std::string& path, const std::string& input);

/// Write by the ending of the name: .h5 with a preview picture beside it, or the labels as a picture.
/// @return the names of the files.
std::vector<std::string> write_specimen_output(const std::string& path, const specimen::Specimen& specimen);

/// The figures: as JSON on `out`, or in words on `err`; notes and file names with them.
void report_specimen(Console& console, bool as_json, const Prepared& prepared, nlohmann::ordered_json figures,
                     const std::vector<std::string>& files);

}  // namespace app
