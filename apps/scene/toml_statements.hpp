/// A TOML text without the statements that are none, so that the others can be looked at too.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/text/complaint.hpp"

namespace app {

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
