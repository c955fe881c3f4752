/// What sets scenes apart.
#pragma once

#include <string>
#include <vector>

namespace app {

/// A setting that is not the same in all scenes.
struct SceneDifference {
  std::string key;                  ///< "loading.velocity"
  std::vector<std::string> values;  ///< as the scene files write them, by scene; empty = not there
};

/// Settings that differ between resolved scenes, sorted by key.
/// @param scenes  texts of scene files.   @throws Rejected (Exit::data) for a text that is no TOML.
[[nodiscard]] std::vector<SceneDifference> scene_differences(const std::vector<std::string>& scenes);

}  // namespace app
