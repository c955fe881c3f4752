/// Collects what a case measures, and whether all of it is as it must be.
#pragma once

#include <string>

#include "apps/bench/stability_case.hpp"

namespace app::bench {

class Judge {
 public:
  /// Something that is seen and must hold.
  Judge& must(bool holds, const std::string& seen);
  /// A figure that is shown and bound to nothing.
  Judge& note(const std::string& seen);
  /// |value / exact - 1| <= tolerance; not-a-number fails.
  Judge& near(const std::string& what, double value, double exact, double tolerance);
  /// value <= limit; not-a-number fails.
  Judge& below(const std::string& what, double value, double limit);

  /// Holds when something was judged and all of it held.
  [[nodiscard]] Finding finding() const;

 private:
  Judge& add(const std::string& seen);

  bool holds_ = true;
  bool judged_ = false;
  std::string seen_;
};

}  // namespace app::bench
