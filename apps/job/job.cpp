#include "apps/job/job.hpp"

#include "apps/job/scene_builder.hpp"

namespace app {

Prepared fit_to_cells(Prepared prepared, const Settings& settings) {
  for (std::string& note : crop_to_cells(prepared.specimen, settings.scene.points_per_cell))
    prepared.notes.push_back(std::move(note));
  return prepared;
}

Prepared prepare_cells(const Settings& settings) {
  return fit_to_cells(prepare_specimen(settings), settings);
}

Job make_job(Settings settings, Prepared cells) {
  mpm::Scene scene = build_scene(cells.specimen, settings);
  mpm::validate(scene);
  return {std::move(settings), std::move(cells.specimen), std::move(scene), std::move(cells.notes)};
}

Job prepare_job(Settings settings, Console& console) {
  Prepared prepared = prepare_cells(settings);
  for (const std::string& note : prepared.notes) console.say("note: " + note);
  return make_job(std::move(settings), std::move(prepared));
}

}  // namespace app
