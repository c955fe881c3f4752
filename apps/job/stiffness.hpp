/// The effective stiffness of a specimen, measured and told.
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "apps/settings/assignment.hpp"
#include "apps/settings/settings.hpp"
#include "libmpm/material/stiffness_bounds.hpp"
#include "libmpm/run/effective_stiffness.hpp"
#include "specimen/body/specimen.hpp"

namespace app {

/// A tensor in a few numbers.
struct Moduli {
  mpm::PlaneModuli plane;  ///< of the nearest isotropic tensor
  mpm::ElasticConstants constants;
  double anisotropy = 0;  ///< distance from that tensor over the norm of its own [-]
};

/// Under one condition at the edges.
struct BoundaryStiffness {
  mpm::EffectiveStiffness effective;
  Moduli moduli;
  double wall_time = 0;  ///< [s]
};

/// A phase that is there.
struct MixedPhase {
  std::string name;
  double share = 0;  ///< of the area [-]
  double young = 0, poisson = 0;
};

struct StiffnessReport {
  std::string name;  ///< what the user calls the specimen
  int cols = 0, rows = 0;
  double pixel_size = 0;  ///< [m]
  std::string cell;       ///< "pixel", "2 x 2"
  mpm::Plane plane = mpm::Plane::strain;
  std::vector<MixedPhase> phases;
  std::array<BoundaryStiffness, 3> boundaries;  ///< by mpm::Boundary
  mpm::StiffnessBounds bounds;
  std::vector<std::string> doubts;  ///< see specimen::doubts_of()
};

/// The words of a condition: "uniform_stress".
[[nodiscard]] const char* boundary_word(mpm::Boundary boundary);
inline constexpr std::array<mpm::Boundary, 3> all_boundaries{
    mpm::Boundary::uniform_stress, mpm::Boundary::periodic, mpm::Boundary::uniform_strain};

/// @param specimen  of whole cells.   @throws Rejected, mpm::Error for what has no stiffness.
[[nodiscard]] StiffnessReport measure_stiffness(const std::string& name, const specimen::Specimen& specimen,
                                                const Settings& settings);

/// Of the phases only what is elastic matters.   @throws Rejected (Exit::usage) for what has no effect.
void refuse_strengths(const std::vector<Assignment>& given);

/// SI units in the names of the keys.
[[nodiscard]] nlohmann::ordered_json stiffness_json(const StiffnessReport& report);

/// The same as tables for people.
[[nodiscard]] std::string stiffness_text(const StiffnessReport& report);

/// What the figures need to be understood, one sentence each.
[[nodiscard]] std::vector<std::string> stiffness_notes(const StiffnessReport& report);

}  // namespace app
