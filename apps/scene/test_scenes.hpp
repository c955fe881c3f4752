/// The tests of a laboratory as scenes to begin with: what mesopix scene init --test writes.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace app {

/// A test of concrete with its usual sizes.
struct TestScene {
  std::string name;   ///< "three-point-bending"
  std::string title;  ///< "Three-point bending of a notched beam"
  /// Keys of settings with what the command line would say; of lists, as supports[1].at.
  std::vector<std::pair<std::string, std::string>> settings;
};

/// In the order in which the help names them.
[[nodiscard]] const std::vector<TestScene>& test_scenes();

/// @throws Rejected (Exit::usage) for a name that is none of them.
[[nodiscard]] const TestScene& test_scene_named(const std::string& name);

}  // namespace app
