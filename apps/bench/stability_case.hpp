/// A case of the bench of limits: what is done, and what must come of it.
#pragma once

#include <functional>
#include <string>

namespace app::bench {

/// What a case found.
struct Finding {
  bool holds = false;
  std::string seen;  ///< the figures that were measured, in words
};

struct StabilityCase {
  std::string name;              ///< as it is asked for, e.g. "contrast"
  std::string group;             ///< heading under which it stands
  std::string must;              ///< what must happen, in words
  std::function<Finding()> run;  ///< on the thread that calls; what it throws is a failure
};

}  // namespace app::bench
