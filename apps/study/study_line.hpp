/// One line on the terminal that tells how far a study is.
#pragma once

#include <chrono>
#include <string>

#include "apps/system/console.hpp"
#include "apps/study/study_run.hpp"
#include "apps/system/terminal_line.hpp"

namespace app {

/// "12 of 100 members   1 failed   35 s left".
/// @param elapsed  since the first of them was begun [s].
[[nodiscard]] std::string study_text(const StudyTally& tally, double elapsed);

class StudyLine {
 public:
  explicit StudyLine(Console& console) : line_(console.err, console.err_is_terminal && !console.quiet) {}

  void show(const StudyTally& tally) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    line_.show(study_text(tally, elapsed.count()));
  }

 private:
  TerminalLine line_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace app
