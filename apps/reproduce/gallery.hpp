/// Pictures of damage on the page.
#pragma once

#include <string>
#include <vector>

#include "apps/reproduce/trial.hpp"

namespace app::reproduce {

/// What the colours of the pictures mean, for the phases of a mask.
[[nodiscard]] std::string damage_legend(const specimen::LabelledMask& mask);

/// Damage at shares of the strain at the peak [%]; one that the run did not reach is left out.
/// @pre the maps of the outcome are kept.
[[nodiscard]] std::string damage_pictures(const Outcome& outcome, const std::vector<int>& percents,
                                          const std::string& caption = "");

/// Pictures beside each other.
[[nodiscard]] std::string gallery(const std::string& pictures_html);

}  // namespace app::reproduce
