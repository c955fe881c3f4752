/// A scene to begin with.
#pragma once

#include <filesystem>
#include <string>

#include "libmpm/scene/scene.hpp"

namespace app {

/// What a person who begins knows already.
struct DraftWish {
  std::string picture;   ///< that the specimen is made from
  std::string width;     ///< of the picture, "40 mm"; empty = as its file says
  std::string specimen;  ///< file that it is read from; neither: random aggregates
  mpm::Direction direction = mpm::Direction::tension;
  std::string file;    ///< that the scene is to be kept in
  std::string schema;  ///< file of the JSON Schema, which the scene then names; empty = none
};

/// A scene that runs in seconds: the settings that a first run is about, and as comments all others that
/// would have an effect, with their defaults and what is allowed. Paths are written relative to the folder of
/// the scene.
/// @throws Rejected for a picture that does not tell its scale, and a file that cannot be read.
[[nodiscard]] std::string scene_draft(const DraftWish& wish);

}  // namespace app
