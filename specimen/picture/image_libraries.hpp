/// Which libraries read and segment pictures.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace specimen {

/// Names and versions, asked of the libraries that are loaded: {"OpenCV", "4.6.0"}.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> image_libraries();

}  // namespace specimen
