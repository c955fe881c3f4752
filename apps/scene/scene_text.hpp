/// The resolved scene: every setting that has an effect, written out as TOML.
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "apps/settings/settings.hpp"
#include "apps/text/value.hpp"

namespace app {

/// Which tables to write.
enum class Extent {
  specimen,  ///< what the specimen is made from: provenance of a specimen file
  whole,
};

/// A path as a scene in that folder writes it.   @param value  a text: relative to the current folder, or
/// absolute.
[[nodiscard]] Value relative_to(const std::filesystem::path& folder, const Value& value);

/// Text that parse_scene and resolve turn into the same settings: complete, commented, the same on every
/// machine.
/// @param folder  paths are written relative to it, where the text is to be kept.
[[nodiscard]] std::string scene_text(const Settings& settings, Extent extent,
                                     const std::filesystem::path& folder);

}  // namespace app
