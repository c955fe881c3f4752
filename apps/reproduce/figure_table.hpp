/// All figures that can be reproduced.
#pragma once

#include <string>
#include <vector>

#include "apps/reproduce/figure.hpp"

namespace app::reproduce {

/// In the order of the paper. A new figure is one more line here.
[[nodiscard]] const std::vector<Figure>& figures();

/// Figures of these ids, each once, in the order of the paper; all of them for no id.
/// @throws Rejected (Exit::usage) for an id that no figure has, naming all that there are.
[[nodiscard]] std::vector<const Figure*> select_figures(const std::vector<std::string>& ids);

/// "Figure 12", "Figures 8 to 11", "Figures 6 and 7".
[[nodiscard]] std::string name_of(const Figure& figure);

}  // namespace app::reproduce
