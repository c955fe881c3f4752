#include "apps/live/progress_line.hpp"

#include <fmt/format.h>

#include "apps/report/run_words.hpp"
#include "apps/system/terminal.hpp"

namespace app {
namespace {

std::string strain_now(double strain) {
  return strain < 0.01 ? fmt::format("{:.0f}e-6", 1e6 * strain) : fmt::format("{:.2f} %", 100 * strain);
}

std::string time_left(const mpm::Progress& progress) {
  if (progress.fraction <= 0) return "";
  const double seconds = progress.wall_time * (1 - progress.fraction) / progress.fraction;
  if (seconds < 100) return fmt::format("   {:.0f} s left", seconds);
  return fmt::format("   {:.0f} min left", seconds / 60);
}

}  // namespace

std::string progress_text(const mpm::Scene& scene, const mpm::Progress& progress) {
  const mpm::HistoryRow& row = progress.row;
  return fmt::format("{:3.0f} %   {} {}   {} {:.2f} MPa   {} failed{}", 100 * progress.fraction,
                     output::has_platens(scene) ? "strain" : output::name_of_strain(scene),
                     strain_now(row.strain), output::name_of_stress(scene), 1e-6 * row.stress,
                     row.tension_failures + row.shear_failures, time_left(progress));
}

void ProgressLine::show(const mpm::Progress& progress) {
  if (!enabled_ || (drawn_ && progress.wall_time - last_ < 0.1)) return;
  terminal_ << wipe_line << progress_text(scene_, progress) << std::flush;
  drawn_ = true;
  last_ = progress.wall_time;
}

ProgressLine::~ProgressLine() {
  if (drawn_) terminal_ << wipe_line << std::flush;
}

}  // namespace app
