/// The scenes of data/paper, which the program carries in itself.
#pragma once

#include <string>
#include <vector>

namespace app::reproduce {

struct PaperScene {
  std::string name;  ///< "tension"
  std::string text;  ///< TOML
};

/// In alphabetical order.
[[nodiscard]] const std::vector<PaperScene>& paper_scenes();

/// @pre there is one of that name.
[[nodiscard]] const PaperScene& paper_scene(const std::string& name);

/// "data/paper/tension.toml": where the file lies in the sources.
[[nodiscard]] std::string path_of_scene(const std::string& name);

}  // namespace app::reproduce
