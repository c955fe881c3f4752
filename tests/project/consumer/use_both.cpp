// Breaks a specimen: both libraries are in one program, and both say what a user did wrong.
#include <libmpm/run/simulate.hpp>
#include <libmpm/scene/error.hpp>
#include <specimen/body/error.hpp>
#include <specimen/body/specimen.hpp>
#include <specimen/file/specimen_file.hpp>

#include <algorithm>

namespace {

mpm::Scene scene_of(const specimen::LabelledMask& mask) {
  mpm::Scene scene;
  scene.labels.resize(mask.labels.rows, mask.labels.cols);
  std::copy(mask.labels.data.begin(), mask.labels.data.end(), scene.labels.data());
  scene.pixel_size = mask.pixel_size;
  scene.phases.emplace_back();
  for (const mpm::Phase& phase : mpm::concrete_phases()) scene.phases.emplace_back(phase);
  return scene;
}

}  // namespace

int main() {
  const specimen::Ellipse stone{0.01, 0.01, 6e-3, 4e-3, 0};
  const auto made = specimen::make_specimen(specimen::draw_ellipses({stone}, 0.02, 0.02, 0.5e-3), {}, {});
  mpm::Scene scene = scene_of(made.mask);
  scene.loading.velocity = 0.5;
  if (!(mpm::simulate(scene).peak_stress > 1e5)) return 1;

  int refusals = 0;
  try {
    (void)specimen::read_specimen("nowhere.h5");
  } catch (const specimen::Error& error) {
    refusals += !error.field.empty();
  }
  scene.pixel_size = 0;
  try {
    mpm::validate(scene);
  } catch (const mpm::Error& error) {
    refusals += !error.field.empty();
  }
  return refusals == 2 ? 0 : 2;
}
