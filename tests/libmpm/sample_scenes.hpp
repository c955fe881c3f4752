/// Small scenes that several tests share.
#pragma once

#include <cmath>

#include "libmpm/scene/scene.hpp"

namespace samples {

inline constexpr std::uint8_t aggregate = 1;
inline constexpr std::uint8_t mortar = 2;
inline constexpr std::uint8_t itz = 3;

/// Void and the three phases of Table 1 by label, everything mortar.
inline mpm::Scene mortar_block(int rows, int cols, double pixel_size = 0.5e-3) {
  mpm::Scene scene;
  scene.labels.setConstant(rows, cols, mortar);
  scene.pixel_size = pixel_size;
  scene.phases = {std::nullopt};
  for (const auto& phase : mpm::concrete_phases()) scene.phases.emplace_back(phase);
  return scene;
}

/// The same with round aggregates in a staggered order, each with a ring of ITZ pixels.
inline mpm::Scene small_concrete(int rows = 60, int cols = 60) {
  mpm::Scene scene = mortar_block(rows, cols);
  const double pitch = 20;
  for (int row = 0; row < rows; ++row) {
    for (int col = 0; col < cols; ++col) {
      const double y = row - std::floor(row / pitch) * pitch - pitch / 2;
      const double shifted = col + (static_cast<int>(row / pitch) % 2) * pitch / 2;
      const double x = shifted - std::floor(shifted / pitch) * pitch - pitch / 2;
      const double radius = std::hypot(x, y);
      if (radius < 7)
        scene.labels(row, col) = aggregate;
      else if (radius < 8.2)
        scene.labels(row, col) = itz;
    }
  }
  return scene;
}

/// All phases elastic.
inline mpm::Scene unbreakable(mpm::Scene scene) {
  for (auto& phase : scene.phases)
    if (phase) phase->tensile_scale = phase->cohesion = mpm::Phase::unbreakable;
  return scene;
}

/// Loaded fast enough for a test: tension to a strain at which small_concrete has lost most of its strength.
inline mpm::Scene pulled(mpm::Scene scene) {
  scene.loading.velocity = 0.05;
  scene.loading.stop_strain = 3e-4;
  scene.history_rows = 200;
  return scene;
}

}  // namespace samples
