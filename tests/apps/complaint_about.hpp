/// What a codec says of a value.
#pragma once

#include <string>

#include "apps/text/complaint.hpp"
#include "apps/text/quantity.hpp"

namespace app {

/// "accepted", or what is allowed and the cure.
template <class Codec>
std::string complaint_about(const Codec& codec, const Value& value) {
  try {
    (void)codec.read(value);
    return "accepted";
  } catch (const Mistake& mistake) {
    return mistake.allowed + (mistake.cure.empty() ? "" : "; " + mistake.cure);
  }
}

}  // namespace app
