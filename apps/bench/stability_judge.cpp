#include "apps/bench/stability_judge.hpp"

#include <fmt/format.h>

#include <cmath>

namespace app::bench {

Judge& Judge::add(const std::string& seen) {
  if (!seen_.empty()) seen_ += "; ";
  seen_ += seen;
  return *this;
}

Judge& Judge::note(const std::string& seen) { return add(seen); }

Judge& Judge::must(bool holds, const std::string& seen) {
  judged_ = true;
  holds_ = holds_ && holds;
  return add(holds ? seen : "NOT AS IT MUST BE: " + seen);
}

Judge& Judge::near(const std::string& what, double value, double exact, double tolerance) {
  const double off = std::abs(value / exact - 1);
  return must(off <= tolerance, fmt::format("{} {:.5g}, exact {:.5g}, off by {:.1e} (at most {:.0e})", what,
                                            value, exact, off, tolerance));
}

Judge& Judge::below(const std::string& what, double value, double limit) {
  return must(value <= limit, fmt::format("{} {:.3g} (at most {:.3g})", what, value, limit));
}

Finding Judge::finding() const { return {holds_ && judged_, seen_}; }

}  // namespace app::bench
