/// What the program says when it refuses.
#pragma once

#include <string>

#include "apps/text/complaint.hpp"

namespace test {

/// All complaints that a call throws, a line each; "nothing" when it returns.
template <class Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const app::Rejected& rejected) {
    return rejected.what();
  }
  return "nothing";
}

}  // namespace test
