/// All problems of the bench of errors.
#pragma once

#include <string>
#include <vector>

#include "apps/bench/error_study.hpp"
#include "apps/reproduce/trial.hpp"

namespace app::bench {

[[nodiscard]] Problem bar_problem();           ///< vibration of a bar
[[nodiscard]] Problem manufactured_problem();  ///< large deformation made up beforehand
[[nodiscard]] Problem inclusion_problem();     ///< Goodier's disc
[[nodiscard]] Problem hole_problem();          ///< Kirsch's hole
[[nodiscard]] Problem layers_problem();        ///< Reuss' modulus
[[nodiscard]] Problem flight_problem();        ///< constant strain: none, on points that cross cells
[[nodiscard]] Problem spin_problem();          ///< angular momentum
[[nodiscard]] Problem collision_problem();     ///< energy of two discs

/// The paper's tension test: peak stress.
/// @param settings  given to every run, e.g. to make the specimen small.
[[nodiscard]] Problem tension_problem(const std::vector<reproduce::Setting>& settings = {});

/// Young's modulus of the random specimen.
[[nodiscard]] Problem modulus_problem(const std::vector<reproduce::Setting>& settings = {});

[[nodiscard]] std::vector<Problem> all_problems();

/// Those of these names, or all for none.   @throws Rejected (Exit::usage) for a name that is not there.
[[nodiscard]] std::vector<Problem> select_problems(const std::vector<std::string>& names);

}  // namespace app::bench
