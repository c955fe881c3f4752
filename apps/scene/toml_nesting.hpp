/// How deep a TOML text nests, looked at before it is parsed: the parser calls itself for each level.
#pragma once

#include <string>

namespace app {

/// @throws Rejected (Exit::data) with the place of a key of more than 16 parts ("a.b.c" has 3), or of a list
/// or table within more than 32 others. In a text that is no TOML it may find less, but never past what a
/// parser accepts.
void check_nesting(const std::string& text, const std::string& path);

}  // namespace app
