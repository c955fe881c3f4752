/// Where specimen and solver meet: what is solved, made from what the user asked for.
#pragma once

#include <string>
#include <vector>

#include "apps/job/specimen_source.hpp"
#include "apps/settings/settings.hpp"
#include "apps/system/terminal.hpp"
#include "apps/text/complaint.hpp"
#include "libmpm/scene/scene.hpp"
#include "specimen/body/specimen.hpp"

namespace app {

struct Job {
  Settings settings;
  specimen::Specimen specimen;
  mpm::Scene scene;
  std::vector<std::string> notes;  ///< on the way there, one sentence each
};

/// The one way from settled settings to what is solved: the specimen is prepared, cropped to whole cells,
/// made into a scene, and that is validated. Each stage is a function of its own below, for who shares a
/// specimen or looks at one stage after the other.
/// @throws Rejected, and the errors of the libraries, for what cannot be solved.
[[nodiscard]] Job make_job(Settings settings);

/// The same from a specimen of whole cells that is there already.
[[nodiscard]] Job make_job(Settings settings, Prepared cells);

/// The same from the start; notes are said as soon as they are known.
[[nodiscard]] Job make_job(Settings settings, Console& console);

/// The specimen of settled settings, cropped to whole cells, with a note where something was cut.
/// @throws Rejected, specimen::Error.
[[nodiscard]] Prepared prepare_cells(const Settings& settings);

/// The same of a specimen that is there already.   @throws Rejected when nothing is left.
[[nodiscard]] Prepared fit_to_cells(Prepared prepared, const Settings& settings);

/// Cut rows at the top and columns at the right that do not fill a cell of the grid.
/// @return a sentence about what was cut, none where nothing was.   @throws Rejected when nothing is left.
[[nodiscard]] std::vector<std::string> crop_to_cells(specimen::Specimen& specimen, int points_per_cell);

/// About a flight, which without platens is all that moves the specimen, and which it needs.
[[nodiscard]] std::vector<Complaint> flight_complaints(const mpm::Loading& loading);

/// The scene of a specimen whose sides are whole numbers of cells.
/// @throws Rejected for a phase of the specimen without material, a material without such a phase, and an
/// edge at a platen that is void throughout.
[[nodiscard]] mpm::Scene build_scene(const specimen::Specimen& specimen, const Settings& settings);

/// The same without a test to put it to: what the stiffness of a specimen of whole cells depends on, and no
/// more. Its edges may be void.
/// @throws Rejected as build_scene(), and for an ITZ of points, which are no pixels; mpm::Error.
[[nodiscard]] mpm::Scene build_elastic_scene(const specimen::Specimen& specimen, const Settings& settings);

}  // namespace app
