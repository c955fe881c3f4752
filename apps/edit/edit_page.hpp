/// The page on which a person teaches a picture.
#pragma once

#include <string>
#include <string_view>

#include "apps/settings/settings.hpp"

namespace app {

/// The page: it asks its server alone, for "now", "photo", "mask" and "strokes", and posts to "add",
/// "remove", "undo", "redo", "set", "make" and "stop".
/// @param name  of the picture.
[[nodiscard]] std::string edit_page(const std::string& name, const Settings& settings);

/// A setting as a person writes it: "auto", "1 mm2", "true".
[[nodiscard]] std::string text_of_setting(std::string_view key, const Settings& settings);

}  // namespace app
