/// Names of phases as the formats of meshes allow them.
#pragma once

#include <string>
#include <vector>

namespace exchange {

/// Names of sets for Abaqus and CalculiX, which know no upper and lower case: capitals, digits and
/// underscores, a letter first, at most 80 characters; "fly ash 2" becomes FLY_ASH_2. No two are the same: a
/// name that is taken gets a number behind it.
[[nodiscard]] std::vector<std::string> set_names(const std::vector<std::string>& phases);

/// Names of physical groups for Gmsh, which stand between quotes on one line: only quotes and control
/// characters are replaced, by underscores. At most 120 bytes; no two are the same.
[[nodiscard]] std::vector<std::string> group_names(const std::vector<std::string>& phases);

}  // namespace exchange
