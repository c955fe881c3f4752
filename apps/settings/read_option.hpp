/// Options that are no settings of the scene, read by the codecs of those.
#pragma once

#include <string>

#include "apps/settings/codec.hpp"
#include "apps/text/complaint.hpp"
#include "apps/text/value.hpp"

namespace app {

/// @param option  "--tolerance".   @throws Rejected (Exit::usage) for a text that the codec refuses.
template <class Codec>
[[nodiscard]] auto read_option(const char* option, const std::string& text, const Codec& codec) {
  try {
    return codec.read(from_command_line(Kind::integer, text));
  } catch (const Mistake& mistake) {
    throw Rejected(Exit::usage, complaint(option, text, mistake.allowed, mistake.cure));
  }
}

}  // namespace app
