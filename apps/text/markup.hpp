/// Text for HTML and XML, and JSON as the program writes it.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace output {

/// Text that shows itself, in an element or between quotes: & < > " ' are escaped, control characters and
/// bytes that are no UTF-8 become U+FFFD.
[[nodiscard]] std::string escape(std::string_view text);

/// Bytes in the letters of RFC 4648.
[[nodiscard]] std::string base64(std::string_view bytes);

/// Bytes as the address of an embedded picture: "data:image/png;base64,...".
[[nodiscard]] std::string png_address(std::string_view png);

}  // namespace output

namespace app {

/// Indented, and ended by a line break. Bytes that are no UTF-8 are replaced, control characters are escaped,
/// those above 0x7E too: a terminal would obey them.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& json);

}  // namespace app
