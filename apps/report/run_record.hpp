/// A run as its files and pages need it, and how wrong its peak may be.
#pragma once

#include <algorithm>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "libmpm/scene/result.hpp"
#include "libmpm/scene/scene.hpp"
#include "specimen/body/specimen.hpp"

namespace output {

/// What one choice of the numerics adds.
struct ErrorSource {
  std::string name;          ///< "loading rate"
  std::string compared;      ///< what a second run did otherwise: "0.025 m/s"
  double peak_stress = 0;    ///< of that run [Pa]
  double peak_strain = 0;    ///< of that run [-]
  double stress_error = 0;   ///< estimated, of the peak stress over it [-]
  double strain_error = 0;   ///< estimated, of the peak strain over it [-]
  double wall_time = 0;      ///< of the time loop of that run [s]
  bool peak_reached = true;  ///< by that run; else the errors are lower bounds
};

struct ErrorEstimate {
  std::vector<ErrorSource> sources;  ///< empty: none was asked for

  /// Sums over the sources: they may all point the same way.
  [[nodiscard]] double stress_error() const { return sum(&ErrorSource::stress_error); }  ///< [-]
  [[nodiscard]] double strain_error() const { return sum(&ErrorSource::strain_error); }  ///< [-]
  [[nodiscard]] double wall_time() const { return sum(&ErrorSource::wall_time); }        ///< [s]

  /// Whether a run that was compared with ended before its peak, so that the errors may be larger.
  [[nodiscard]] bool is_least() const {
    return std::any_of(sources.begin(), sources.end(),
                       [](const ErrorSource& source) { return !source.peak_reached; });
  }

 private:
  [[nodiscard]] double sum(double ErrorSource::*value) const {
    double total = 0;
    for (const ErrorSource& source : sources) total += source.*value;
    return total;
  }
};

}  // namespace output

/// What a run is, whatever comes of it.
struct RunSubject {
  const specimen::Specimen& specimen;  ///< what is broken; its mask has the shape of the scene's labels
  const mpm::Scene& scene;             ///< as it is solved
  std::string scene_toml;              ///< the resolved scene, every default written out
  std::string scene_hash;              ///< SHA-256 of scene_toml, lower-case hexadecimal
  std::string title;                   ///< the user's own words; escaped wherever it is shown
  std::vector<std::string> notes;      ///< what was guessed or cut short, one sentence each
};

/// A run, as the files of its folder need it: finished, or looked at on its way.
struct RunRecord : RunSubject {
  const mpm::Result& result;
  output::ErrorEstimate error_estimate = {};  ///< of the peak; without sources when none was asked for
  bool goes_on = false;                       ///< the run is not over yet
};

/// What result.h5, summary.json, the report and the frames name as the run that they are of.
/// @param scene_toml  the resolved scene.   @param scene  as it is solved, with its specimen.
/// @return SHA-256 of both but the number of threads, which changes no bit, in lower-case hexadecimal.
[[nodiscard]] std::string run_digest(const std::string& scene_toml, const mpm::Scene& scene);

/// Key figures of a run in SI units, as summary.json holds them; figures that are not finite are null in
/// its text.
[[nodiscard]] nlohmann::json summary(const RunRecord& record);
