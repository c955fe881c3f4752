#include "apps/study/study_line.hpp"

#include <fmt/format.h>

namespace app {

std::string study_text(const StudyTally& tally, double elapsed) {
  std::string text = fmt::format("{} of {} members", tally.before + tally.done + tally.failed, tally.all);
  if (tally.failed > 0) text += fmt::format("   {} failed", tally.failed);
  const std::size_t now = tally.done + tally.failed;
  if (now == 0) return text;
  const double seconds = elapsed * static_cast<double>(tally.open()) / static_cast<double>(now);
  if (seconds < 100) return text + fmt::format("   {:.0f} s left", seconds);
  return text + fmt::format("   {:.0f} min left", seconds / 60);
}

}  // namespace app
