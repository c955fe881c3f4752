/// What the readers of TOML files share.
#pragma once

#include <toml++/toml.h>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "apps/text/complaint.hpp"
#include "apps/text/quantity.hpp"

namespace app {

/// Before a text is parsed, since the parser calls itself for each level.
/// @throws Rejected (Exit::data) with the place of a key of more than 16 parts ("a.b.c" has 3), or of a list
/// or table within more than 32 others. In a text that is no TOML it may find less, but never past what a
/// parser accepts.
void check_nesting(const std::string& text, const std::string& path);

/// @param path  for the messages.   @throws Rejected (Exit::data) with the place where it is no TOML.
[[nodiscard]] toml::table parse_toml(const std::string& text, const std::string& path);

/// Where something begins in the file of that path.
[[nodiscard]] Place place_of(const toml::source_region& source, const std::string& path);

/// A single value or a list of them; nullopt for a table or a date.
[[nodiscard]] std::optional<Value> value_of(const toml::node& node);

/// Whether a place is nearer to the beginning of its file.
[[nodiscard]] bool stands_before(const Place& a, const Place& b);

/// What remains of a text, and what had to go.
struct Parseable {
  std::string text;                   ///< lines that went are empty, so that places stay what they are
  std::string left_out;               ///< those lines
  std::vector<Complaint> complaints;  ///< one about each statement that went
};

/// Leave out one statement after the other until what remains can be parsed. Below the head of a table that
/// is wrong all goes up to the next head, since nobody knows whose keys they are. Where it comes to no end
/// with twenty of them, or the text is larger than a person writes, nothing remains.
/// @param parse  throws Rejected with the place where a text is no TOML.
[[nodiscard]] Parseable parseable(std::string text, const std::function<void(const std::string&)>& parse);

}  // namespace app
