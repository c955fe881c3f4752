/// Lists of tables in a scene, as [[supports]]: each item has the same keys, which are settings of their own
/// with a number in their names, as supports[2].from.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/settings/schema.hpp"

namespace app {

struct SceneList {
  std::string name;                   ///< "supports"
  std::string item;                   ///< "a support"
  std::string help;                   ///< a sentence
  std::vector<std::string> required;  ///< keys of each item that have no default
  /// Settings of an item, by its number from 0.
  std::vector<Field> (*fields)(std::size_t index) = nullptr;
  std::size_t (*size)(const Settings& settings) = nullptr;  ///< number of items
};

/// In the order in which they are written.
[[nodiscard]] const std::vector<SceneList>& scene_lists();

/// Items that a list may have.
inline constexpr std::size_t most_items = 1000;

/// nullptr = there is none of that name.
[[nodiscard]] const SceneList* find_list(std::string_view name);

/// Setting of an item by its whole key, "supports[2].from".
[[nodiscard]] std::optional<Field> find_item_field(std::string_view key);

/// Whether it is a list without items, as of a setting that is not given.
[[nodiscard]] bool is_empty_list(const Value& value);

/// Keys of an item of a list.
[[nodiscard]] std::vector<std::string> item_keys(const SceneList& list);

}  // namespace app
