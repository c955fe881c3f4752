/// Cutting up what people write.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace app {

/// The text without the blanks and tabs at its ends.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The text as a whole number; nullopt unless it is one from its first letter to its last.
[[nodiscard]] std::optional<std::int64_t> whole_number(std::string_view text);

}  // namespace app
