/// What the readers of TOML files share.
#pragma once

#include <toml++/toml.h>

#include <optional>
#include <string>

#include "apps/text/complaint.hpp"
#include "apps/text/value.hpp"

namespace app {

/// @param path  for the messages.   @throws Rejected (Exit::data) with the place where it is no TOML.
[[nodiscard]] toml::table parse_toml(const std::string& text, const std::string& path);

/// Where something begins in the file of that path.
[[nodiscard]] Place place_of(const toml::source_region& source, const std::string& path);

/// A single value or a list of them; nullopt for a table or a date.
[[nodiscard]] std::optional<Value> value_of(const toml::node& node);

/// Whether a place is nearer to the beginning of its file.
[[nodiscard]] bool stands_before(const Place& a, const Place& b);

}  // namespace app
