/// The problems whose answer is known in closed form.
#pragma once

#include "apps/bench/error_study.hpp"

namespace app::bench {

[[nodiscard]] Problem bar_problem();           ///< vibration of a bar
[[nodiscard]] Problem manufactured_problem();  ///< large deformation made up beforehand
[[nodiscard]] Problem inclusion_problem();     ///< Goodier's disc
[[nodiscard]] Problem hole_problem();          ///< Kirsch's hole
[[nodiscard]] Problem layers_problem();        ///< Reuss' modulus
[[nodiscard]] Problem flight_problem();        ///< constant strain: none, on points that cross cells
[[nodiscard]] Problem spin_problem();          ///< angular momentum
[[nodiscard]] Problem collision_problem();     ///< energy of two discs

}  // namespace app::bench
