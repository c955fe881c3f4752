/// Commands that a message tells the user to give.
#pragma once

#include <string>

namespace app {

/// An argument as a shell takes it, in quotes where it needs them.
[[nodiscard]] std::string shell_word(const std::string& text);

}  // namespace app
