#include "apps/settings/settings.hpp"

#include <algorithm>

#include "specimen/pack/grading.hpp"

namespace app {
namespace {

bool keeps_place(const mpm::Scene& scene) { return scene.kinematics == mpm::Kinematics::small_strain; }

void choose_cell(mpm::Scene& scene) {
  scene.pixel_cells = keeps_place(scene);
  scene.points_per_cell = scene.pixel_cells ? 1 : 2;
}

void choose_damping(mpm::Scene& scene) { scene.local_damping = keeps_place(scene) ? 0.2 : 0; }

}  // namespace

mpm::Scene default_scene() {
  mpm::Scene scene;
  choose_cell(scene);
  choose_damping(scene);
  return scene;
}

void follow_kinematics(Settings& settings) {
  if (settings.automatic_cell) choose_cell(settings.scene);
  if (settings.automatic_damping) choose_damping(settings.scene);
}

Source source_of(const Settings& settings) {
  const SpecimenChoice& choice = settings.specimen;
  if (!choice.file.empty()) return Source::file;
  if (!choice.picture.empty()) return Source::picture;
  if (!choice.ellipses.empty() || !choice.ellipse_list.empty()) return Source::ellipses;
  return Source::generated;
}

specimen::PackingOptions packing_options(const Settings& settings) {
  specimen::PackingOptions options = settings.packing;
  const GradingChoice& choice = settings.grading;
  options.grading = choice.classes.empty()
                        ? specimen::named_grading(choice.name, choice.d_min, choice.d_max, choice.walraven)
                        : choice.classes;
  return options;
}

mpm::Phase& phase_named(Settings& settings, std::string_view name) {
  auto& phases = settings.phases;
  const auto found =
      std::find_if(phases.begin(), phases.end(), [&](const mpm::Phase& phase) { return phase.name == name; });
  if (found != phases.end()) return *found;
  phases.emplace_back().name = name;
  return phases.back();
}

}  // namespace app
