/// From settings to the specimen, whatever its source.
#pragma once

#include <string>
#include <vector>

#include "apps/settings/settings.hpp"
#include "specimen/picture/picture.hpp"
#include "specimen/body/specimen.hpp"

namespace app {

/// Make the settings say all there is about the source: a list of ellipses is read in and kept, a file or
/// picture is pinned by its SHA-256.
/// @throws Rejected when the file cannot be read or has another hash than the one expected.
void settle_source(Settings& settings);

struct Prepared {
  specimen::Specimen specimen;
  std::vector<std::string> notes;       ///< what was guessed, one sentence each
  specimen::LabelledMask segmentation;  ///< of a picture, before rings were drawn; else empty
};

/// Generate, draw, convert or read the specimen of settled settings.   @throws specimen::Error, Rejected.
[[nodiscard]] Prepared prepare_specimen(const Settings& settings);

/// Convert a picture that is there already; specimen.picture and specimen.sha256 of the settings tell what it
/// is called, and the SHA-256 of its pixels.   @throws specimen::Error.
[[nodiscard]] Prepared prepare_specimen(specimen::Picture picture, const Settings& settings);

}  // namespace app
