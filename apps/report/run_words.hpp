/// The choices of a run in words, for people and for summary.json.
/// What loads the specimen, and what stress and strain mean with it, in words.
#pragma once

#include <string>

#include "libmpm/scene/result.hpp"
#include "libmpm/scene/scene.hpp"

namespace output {

[[nodiscard]] std::string word_of(mpm::Direction direction);  ///< "tension"
[[nodiscard]] std::string word_of(mpm::Platen platen);        ///< "smooth"
[[nodiscard]] std::string word_of(mpm::Plane plane);          ///< "plane strain"
[[nodiscard]] std::string word_of(mpm::Precision precision);  ///< "double"
[[nodiscard]] std::string word_of(mpm::CrackClosure law);     ///< "unilateral"
[[nodiscard]] std::string word_of(mpm::SolverMethod method);
[[nodiscard]] std::string word_of(mpm::Kinematics kinematics);  ///< "moving"
[[nodiscard]] std::string word_of(mpm::LoadingPath path);
[[nodiscard]] std::string word_of(mpm::StopReason reason);    ///< "drop"
[[nodiscard]] std::string phrase_of(mpm::StopReason reason);  ///< "its duration was over"

[[nodiscard]] bool has_platens(const mpm::Scene& scene);

/// "tension", "compression"; without platens "impact" where there is a wall, else "flight".
[[nodiscard]] std::string name_of_loading(const mpm::Scene& scene);

/// "compression at 0.2 m/s, smooth platens", "impact at 20 m/s, smooth wall at the bottom".
[[nodiscard]] std::string setting_of_loading(const mpm::Scene& scene);

[[nodiscard]] std::string name_of_strain(const mpm::Scene& scene);    ///< "platen strain", "nominal strain"
[[nodiscard]] std::string name_of_stress(const mpm::Scene& scene);    ///< "stress", "stress on the walls"
[[nodiscard]] std::string meaning_of_curve(const mpm::Scene& scene);  ///< what both are, in a sentence or two
[[nodiscard]] std::string meaning_of_energy(const mpm::Scene& scene);  ///< where the energy goes

/// Why the largest stress of a run that is over is no peak, and what to do; empty where it is one, and for a
/// flight without walls, which has none.
[[nodiscard]] std::string no_peak_text(const mpm::Result& result, const mpm::Scene& scene);

/// "small strain", "moving points (GIMP, MUSL, FLIP)".
[[nodiscard]] std::string name_of_kinematics(const mpm::Scene& scene);

}  // namespace output
