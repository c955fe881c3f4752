/// What is solved, made from what the user asked for.
#pragma once

#include <string>
#include <vector>

#include "apps/system/console.hpp"
#include "apps/settings/settings.hpp"
#include "apps/job/specimen_source.hpp"
#include "libmpm/scene/scene.hpp"
#include "specimen/body/specimen.hpp"

namespace app {

struct Job {
  Settings settings;
  specimen::Specimen specimen;
  mpm::Scene scene;
  std::vector<std::string> notes;  ///< on the way there, one sentence each
};

/// The specimen of settled settings, cropped to whole cells, with a note where something was cut.
/// @throws Rejected, specimen::Error.
[[nodiscard]] Prepared prepare_cells(const Settings& settings);

/// The same of a specimen that is there already.   @throws Rejected when nothing is left.
[[nodiscard]] Prepared fit_to_cells(Prepared prepared, const Settings& settings);

/// A specimen of whole cells and its scene.
/// @throws Rejected, and the errors of the libraries, for what cannot be solved.
[[nodiscard]] Job make_job(Settings settings, Prepared cells);

/// Both in one; notes are said.
[[nodiscard]] Job prepare_job(Settings settings, Console& console);

}  // namespace app
