#include "apps/reproduce/claim.hpp"

#include <algorithm>

namespace app::reproduce {

std::string word_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::agrees:
      return "agrees";
    case Verdict::disagrees:
      return "disagrees";
    case Verdict::depends:
      return "depends";
  }
  return {};
}

Verdict verdict_of(const std::vector<bool>& holds) {
  const auto count = std::count(holds.begin(), holds.end(), true);
  if (count == static_cast<std::ptrdiff_t>(holds.size())) return Verdict::agrees;
  return count == 0 ? Verdict::disagrees : Verdict::depends;
}

Verdict verdict_of_share(double share) {
  if (share >= 0.8) return Verdict::agrees;
  return share > 0.2 ? Verdict::depends : Verdict::disagrees;
}

}  // namespace app::reproduce
