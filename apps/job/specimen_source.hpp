/// From settings to the specimen, whatever its source, and what generate and convert leave of it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/settings/settings.hpp"
#include "apps/system/terminal.hpp"
#include "specimen/body/specimen.hpp"
#include "specimen/pack/grading.hpp"
#include "specimen/picture/picture.hpp"

namespace app {

/// Make the settings say all there is about the source: a list of ellipses is read in and kept, a file or
/// picture is pinned by its SHA-256.
/// @throws Rejected when the file cannot be read or has another hash than the one expected.
void settle_source(Settings& settings);

struct Prepared {
  specimen::Specimen specimen;
  std::vector<std::string> notes;                   ///< what was guessed, one sentence each
  specimen::Segmented segmentation;                 ///< of a picture, before rings were drawn; else empty
  specimen::Raster<specimen::Rgb> photograph = {};  ///< what the mask covers of one; else empty
  specimen::Raster<std::uint8_t> uncertain = {};    ///< of that, 1 where the phase is in doubt; or empty
  double uncertain_share = specimen::not_known;     ///< of a picture that strokes taught [-]
  std::string model = {};                           ///< what strokes taught, as a file holds it; or empty
};

/// Generate, draw, convert or read the specimen of settled settings.
/// @param before_pixels  is told the size of a picture before it is read.   @throws specimen::Error,
/// Rejected.
[[nodiscard]] Prepared prepare_specimen(const Settings& settings, specimen::SizeListener before_pixels = {});

/// Convert a picture that is there already; specimen.picture and specimen.sha256 of the settings tell what it
/// is called, and the SHA-256 of its pixels.   @throws specimen::Error.
[[nodiscard]] Prepared prepare_specimen(specimen::Picture picture, const Settings& settings);

/// Whether a place of the specimen lies in a cut; x, y from its lower left corner [m].
[[nodiscard]] bool is_cut_out(double x, double y, const std::vector<Cut>& cuts);

/// Endings of the names of files that can be written: .h5 and those of label pictures.
/// @throws Rejected (Exit::usage) for another ending, and for a file that would overwrite `input`.
void check_output(const std::string& path, const std::string& input);

/// Write by the ending of the name: .h5 with a preview picture beside it, or the labels as a picture.
/// @param photograph, uncertain  as of Prepared: beside a .h5 the photograph is drawn too, once as it is and
/// once under the mask.
/// @return the names of the files.
std::vector<std::string> write_specimen_output(const std::string& path, const specimen::Specimen& specimen,
                                               const specimen::Raster<specimen::Rgb>& photograph = {},
                                               const specimen::Raster<std::uint8_t>& uncertain = {});

/// The figures: as JSON on `out`, or in words on `err`; notes and file names with them.
void report_specimen(Console& console, bool as_json, const Prepared& prepared, nlohmann::ordered_json figures,
                     const std::vector<std::string>& files);

}  // namespace app
