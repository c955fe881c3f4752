/// The figures of a specimen, for people and for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "specimen/body/specimen.hpp"
#include "specimen/pack/grading.hpp"

namespace app {

/// SI units in the names of the keys; a figure that does not exist is null.
/// @param target  grading that was asked for; empty when none was.
[[nodiscard]] nlohmann::ordered_json specimen_json(const specimen::Specimen& specimen,
                                                   const specimen::Grading& target);

/// Of the JSON: sizes and source, in a line without its end.
[[nodiscard]] std::string specimen_heading(const nlohmann::ordered_json& figures);

/// The same as a few lines of text, made from the JSON.
[[nodiscard]] std::string specimen_text(const nlohmann::ordered_json& figures);

}  // namespace app
