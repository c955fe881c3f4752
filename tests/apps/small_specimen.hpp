/// A specimen that is broken in no time.
#pragma once

#include "apps/settings/settings.hpp"
#include "specimen/body/specimen.hpp"

namespace test {

/// A square of mortar with a square aggregate in it, 12 x 12 pixels of 1 mm.
inline specimen::Specimen small_specimen() {
  specimen::Specimen specimen;
  specimen.itz.mode = specimen::ItzMode::none;
  specimen.mask.pixel_size = 1e-3;
  specimen.mask.labels = {12, 12};
  for (int row = 0; row < 12; ++row)
    for (int col = 0; col < 12; ++col) {
      const bool inside = row >= 4 && row < 8 && col >= 4 && col < 8;
      specimen.mask.labels(row, col) = inside ? specimen::phase::aggregate : specimen::phase::mortar;
    }
  return specimen;
}

/// Tension, so slow that waves matter little, with strengths that scatter so little that peaks hardly jump.
inline app::Settings small_settings() {
  app::Settings settings;
  for (mpm::Phase& phase : settings.phases) phase.weibull_modulus = 6;
  settings.scene.loading.velocity = 0.02;
  settings.scene.loading.stop_strain = 5e-4;
  return settings;
}

}  // namespace test
