/// Records of a solver during a run: the energy ledger, and the time and place of failures.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "libmpm/scene/result.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/archive.hpp"
#include "libmpm/solver/plan.hpp"

namespace mpm {

/// Energy ledger after some steps, for the history. Forces act on the specimen, upwards positive.
struct Ledger {
  double time = 0;                 ///< at the beginning of the last step [s]
  double platen_displacement = 0;  ///< at this time [m], absolute value
  double force_top = 0;            ///< [N/m]
  double force_bottom = 0;         ///< [N/m]
  double platen_work = 0;          ///< [J/m]
  double kinetic = 0;              ///< [J/m]
  double elastic = 0;              ///< [J/m]
  double released = 0;             ///< [J/m]
  double damped = 0;               ///< [J/m]
  double left = 0;                 ///< energy of the points that left through open edges [J/m]
  std::int64_t tension_failures = 0;
  std::int64_t shear_failures = 0;
  std::int64_t left_points = 0;
  std::int64_t carrying_points = 0;  ///< that still have some stiffness
  std::vector<double> gauges;        ///< readings, in the order of the scene [m]
  std::int64_t diverged_at = -1;     ///< step at which a value became not-a-number; -1 = none
  std::string trouble;               ///< another fault, with the step and the point; empty = none
};

/// Counts and energies so far.
struct Tally {
  double platen_work = 0;  ///< [J/m]
  double released = 0;     ///< [J/m]
  double damped = 0;       ///< [J/m]
  std::int64_t tension_failures = 0, shear_failures = 0;
};

/// Failure maps; see Result.
struct FailureMaps {
  PixelField<float> failure_strain, crush_strain;
  PixelField<std::uint8_t> failure_mode;
  std::vector<float> extra_failure_strain;
  std::vector<std::uint8_t> extra_failure_mode;

  void copy_to(Result& result) const;
};
[[nodiscard]] FailureMaps empty_maps(const Scene& scene, const Plan& plan);

/// The maps in the archive of a run.
/// @param maps  of the shape that the scene gives them.
template <class Archive, class Maps>
void pass_maps(Archive& archive, Maps& maps) {
  archive.block(maps.failure_strain);
  archive.block(maps.failure_mode);
  archive.block(maps.crush_strain);
  archive.block(maps.extra_failure_strain);
  archive.block(maps.extra_failure_mode);
  if constexpr (Archive::reads) {
    const auto is_mode = [](std::uint8_t mode) {
      return mode <= static_cast<std::uint8_t>(FailureMode::shear);
    };
    const std::uint8_t* first = maps.failure_mode.data();
    if (!std::all_of(first, first + maps.failure_mode.size(), is_mode) ||
        !std::all_of(maps.extra_failure_mode.begin(), maps.extra_failure_mode.end(), is_mode))
      archive.fail("a failure without a mode");
  }
}

}  // namespace mpm
