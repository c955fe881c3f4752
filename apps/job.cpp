#include "apps/job.hpp"

#include "apps/scene_builder.hpp"

namespace app {

Prepared prepare_cells(const Settings& settings) {
  Prepared prepared = prepare_specimen(settings);
  for (std::string& note : crop_to_cells(prepared.specimen, settings.scene.points_per_cell))
    prepared.notes.push_back(std::move(note));
  return prepared;
}

Job prepare_job(Settings settings, Console& console) {
  Prepared prepared = prepare_cells(settings);
  for (const std::string& note : prepared.notes) console.say("note: " + note);
  mpm::Scene scene = build_scene(prepared.specimen, settings);
  mpm::validate(scene);
  return {std::move(settings), std::move(prepared.specimen), std::move(scene), std::move(prepared.notes)};
}

}  // namespace app
