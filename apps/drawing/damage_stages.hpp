/// The strains at which damage is shown.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "libmpm/scene/result.hpp"

namespace output {

/// Where pictures are taken [% of the peak strain].
inline constexpr std::array stage_percents{25, 50, 75, 100, 125, 150};

struct DamageStage {
  int percent = 0;           ///< of the peak strain
  double strain = 0;         ///< of the platens [-]
  std::int64_t tension = 0;  ///< pixels whose point had failed in tension by then
  std::int64_t shear = 0;    ///< the same in shear; ones crushed after cracking count in both
};

struct DamageStages {
  std::vector<DamageStage> drawn;  ///< those that the run reached
  std::vector<int> missing;        ///< those that it did not [%]
  double reached = 0;              ///< largest strain over the peak strain [-]
};

/// Stages of a run; none are drawn where there is no peak strain.
[[nodiscard]] DamageStages damage_stages(const mpm::Result& result);

/// One sentence about the stages that are missing; empty when none is.
[[nodiscard]] std::string missing_note(const DamageStages& stages);

/// "damage_025.png", "damage_025_colour.png".
[[nodiscard]] std::string picture_name(int percent, bool colour);

}  // namespace output
