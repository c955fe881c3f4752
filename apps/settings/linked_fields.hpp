/// Fields that do more than set one member: what the user leaves to the program follows from the kinematics,
/// see follow_kinematics().
#pragma once

#include "apps/settings/schema.hpp"

namespace app {

[[nodiscard]] Field kinematics_field();
[[nodiscard]] Field cell_field();             ///< one word for two members of the scene
[[nodiscard]] Field points_per_cell_field();  ///< what it was called before
[[nodiscard]] Field damping_field();

}  // namespace app
