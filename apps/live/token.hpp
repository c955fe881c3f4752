/// A secret that only those know who were told.
#pragma once

#include <string>
#include <string_view>

namespace app {

/// 128 bits of the system's own randomness as 32 hexadecimal digits.   @throws std::system_error without it.
[[nodiscard]] std::string random_token();

/// In a time that does not depend on where they differ.
[[nodiscard]] bool same_secret(std::string_view given, std::string_view secret);

}  // namespace app
