/// The JSON Schema of scenes, for editors that complete and check TOML.
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace app {

/// In draft 7, which the editors' TOML plug-ins read. It tells types, words, units and the ranges that a
/// schema can express (of texts with a unit only their sign); what depends on other keys it cannot.
[[nodiscard]] nlohmann::ordered_json scene_schema();

}  // namespace app
