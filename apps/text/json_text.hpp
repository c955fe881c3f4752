/// JSON as the program writes it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace app {

/// Indented, and ended by a line break. Bytes that are no UTF-8 are replaced, control characters are escaped,
/// those above 0x7E too: a terminal would obey them.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json);

}  // namespace app
