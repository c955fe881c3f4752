/// One line on the terminal that tells how far a run is.
#pragma once

#include <ostream>
#include <string>

#include "libmpm/run/simulate.hpp"
#include "libmpm/scene/scene.hpp"

namespace app {

/// "42 %   strain 168e-6   stress 3.41 MPa   1234 failed   12 s left", "... nominal strain 2.31 %   stress on
/// the walls 3.41 MPa ..." without platens.
[[nodiscard]] std::string progress_text(const mpm::Scene& scene, const mpm::Progress& progress);

/// Draws the line anew, at most ten times a second, and wipes it at the end.
class ProgressLine {
 public:
  /// The scene must outlive the line.
  ProgressLine(std::ostream& terminal, const mpm::Scene& scene, bool enabled)
      : terminal_(terminal), scene_(scene), enabled_(enabled) {}
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const mpm::Progress& progress);

 private:
  std::ostream& terminal_;
  const mpm::Scene& scene_;
  bool enabled_;
  bool drawn_ = false;
  double last_ = 0;  ///< wall time of the last drawing [s]
};

}  // namespace app
