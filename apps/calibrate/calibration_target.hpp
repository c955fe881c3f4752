/// What a calibration aims at, and how far off runs are.
/// What one set of parameters gave.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "apps/run/seed_runs.hpp"

namespace app {

/// Columns "strain" (or "strain_%", "strain_microstrain") and "stress_MPa" (or _Pa, _kPa, _GPa) of a table
/// with a header and cells between commas; further columns are skipped, so that curve.csv of a run will do.
/// Empty lines and lines that begin with # are skipped too.
/// @throws Rejected (Exit::data) with every mistake at its line and column, (Exit::io) when the file cannot
/// be read.
[[nodiscard]] Curve read_target_curve(const std::string& path);

/// The same from text; `path` is for the messages.
[[nodiscard]] Curve parse_target_curve(const std::string& text, const std::string& path);

/// Of a stress-strain curve.
struct Peak {
  double stress = 0;  ///< [Pa]
  double strain = 0;  ///< [-]
};

/// A peak, its stress or strain alone, or a whole curve.
struct Target {
  std::optional<double> peak_stress;  ///< [Pa], > 0
  std::optional<double> peak_strain;  ///< [-], > 0
  Curve curve;                        ///< empty where a peak is aimed at

  /// The peak of the curve in its place: aimed at first, since a curve says nothing of peaks far from it.
  [[nodiscard]] Target peak_of_curve() const;
};

/// Mean of peak stresses and of peak strains.   @pre there is a run.
[[nodiscard]] Peak mean_peak(const std::vector<SeedRun>& runs);

/// Stress at a strain of the curve that runs have in the mean [Pa]: each is stretched to the mean peak, so
/// that peaks at different strains do not wear each other down.   @pre each run has a peak.
[[nodiscard]] double mean_stress_at(const std::vector<SeedRun>& runs, double strain);

/// Numbers that runs are compared by.
using Figures = Eigen::VectorXd;

/// Of runs: for a peak the natural logarithms of what is aimed at of the mean peak [Pa, -], for a curve the
/// stresses of the mean curve over the peak stress of the target, at 200 strains evenly from its first to its
/// last.   @pre runs have peaks; for a curve they go on to its last strain.
[[nodiscard]] Figures figures_of(const Target& target, const std::vector<SeedRun>& runs);

/// Those of the target itself.
[[nodiscard]] Figures figures_of(const Target& target);

[[nodiscard]] double mean_square(const Figures& figures, const Figures& wanted);

/// Root mean square of the difference of the figures of runs and target: relative error of a peak, error of
/// stresses over the peak stress for a curve.
[[nodiscard]] double misfit(const Target& target, const std::vector<SeedRun>& runs);

/// The scene whose runs reach all of a curve and little beyond; unchanged where a peak is aimed at.
[[nodiscard]] mpm::Scene scene_for(const Target& target, mpm::Scene scene);

struct Evaluation {
  std::vector<double> factors;  ///< one a parameter
  double misfit = 0;            ///< [-], see misfit()
  Peak peak;                    ///< mean of the seeds that reached one; 0 where a run was of no use
  Figures figures;              ///< what the misfit compares; empty where a run was of no use
  bool coarse = false;          ///< of the search for the peak that goes before a fit to a curve
};

}  // namespace app
