/// The choices of a run in words, for people and for summary.json.
#pragma once

#include <string>

#include "libmpm/scene/result.hpp"
#include "libmpm/scene/scene.hpp"

namespace output {

[[nodiscard]] std::string word_of(mpm::Direction direction);    ///< "tension"
[[nodiscard]] std::string word_of(mpm::Platen platen);          ///< "smooth"
[[nodiscard]] std::string word_of(mpm::Plane plane);            ///< "plane strain"
[[nodiscard]] std::string word_of(mpm::Precision precision);    ///< "double"
[[nodiscard]] std::string word_of(mpm::CrackClosure law);       ///< "unilateral"
[[nodiscard]] std::string word_of(mpm::Kinematics kinematics);  ///< "moving"
[[nodiscard]] std::string word_of(mpm::StopReason reason);      ///< "drop"
[[nodiscard]] std::string phrase_of(mpm::StopReason reason);    ///< "the stress had dropped"

[[nodiscard]] std::string capitalised(std::string text);         ///< "tension" -> "Tension"
[[nodiscard]] std::string phase_word(const std::string& phase);  ///< "itz" -> "ITZ", others as they are

}  // namespace output
