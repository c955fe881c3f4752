/// Scenes as texts: resolved ones, drafts, what sets them apart, and their JSON Schema.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <vector>

#include "apps/scene/scene_file.hpp"
#include "apps/settings/settings.hpp"
#include "apps/text/quantity.hpp"
#include "libmpm/scene/scene.hpp"

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

/// The same as values alone, for digests: a line "key = value" for each setting that has an effect, sorted
/// by key; numbers exact and in SI units, files by their names without folders. No wording changes it, be it
/// that of the help or of units, and no order of the schema.
[[nodiscard]] std::string scene_values(const Settings& settings, Extent extent);

/// What resolve() makes of the scene that scene_text() writes: every setting that has an effect was given.
[[nodiscard]] Resolved as_written(Settings settings);

/// In draft 7, which the editors' TOML plug-ins read. It tells types, words, units and the ranges that a
/// schema can express (of texts with a unit only their sign); what depends on other keys it cannot.
[[nodiscard]] nlohmann::ordered_json scene_schema();

/// What a person who begins knows already.
struct DraftWish {
  std::string picture;   ///< that the specimen is made from
  std::string width;     ///< of the picture, "40 mm"; empty = as its file says
  std::string specimen;  ///< file that it is read from; neither: random aggregates
  mpm::Direction direction = mpm::Direction::tension;
  std::string test;    ///< of a laboratory, see test_scenes(), in place of all of these; empty = none
  std::string file;    ///< that the scene is to be kept in
  std::string schema;  ///< file of the JSON Schema, which the scene then names; empty = none
};

/// A scene that runs in seconds: the settings that a first run is about, and as comments all others that
/// would have an effect, with their defaults and what is allowed. Paths are written relative to the folder of
/// the scene.
/// @throws Rejected for a picture that does not tell its scale, and a file that cannot be read.
[[nodiscard]] std::string scene_draft(const DraftWish& wish);

/// A setting that is not the same in all scenes.
struct SceneDifference {
  std::string key;                  ///< "loading.velocity"
  std::vector<std::string> values;  ///< as the scene files write them, by scene; empty = not there
};

/// Settings that differ between resolved scenes, sorted by key.
/// @param scenes  texts of scene files.   @throws Rejected (Exit::data) for a text that is no TOML.
[[nodiscard]] std::vector<SceneDifference> scene_differences(const std::vector<std::string>& scenes);

}  // namespace app
