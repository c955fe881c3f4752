/// All that is wrong with a scene or a study, in one go.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/drawing/drawing.hpp"
#include "apps/text/complaint.hpp"

namespace app {

struct CheckedFile {
  std::string file;
  std::vector<Complaint> complaints;  ///< in the order of the file; none: it can be solved
  bool readable = true;
  std::string what;                       ///< what it is, in one line; where nothing is wrong
  std::vector<std::string> notes;         ///< on the specimen, one sentence each
  std::optional<output::Drawing> set_up;  ///< of a scene in which nothing is wrong
};

/// Read the file, make its specimen and plan its run; of a study, those of its scene and of all members.
/// Nothing is solved, and nothing thrown for what the file says. What follows from other mistakes is left
/// out.
[[nodiscard]] CheckedFile check_file(const std::string& path);

/// For editors: a list with file, line and column (from 1), key, value, problem (the whole message), allowed
/// and cure, each null where there is none.
[[nodiscard]] nlohmann::ordered_json complaints_json(const std::vector<CheckedFile>& files);

}  // namespace app
