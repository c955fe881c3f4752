/// Stiffness of a specimen as a whole: means of stress over means of strain.
///
/// The tensor that a specimen shows depends on what is done at its edges. Uniform stress gives a lower bound
/// on it as a quadratic form, uniform strain an upper one; a periodic specimen lies between them, and the
/// larger the specimen, the nearer they are. Source: Hill, J. Mech. Phys. Solids 11 (1963) 357-372; Hazanov,
/// Huet, J. Mech. Phys. Solids 42 (1994) 1995-2011.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "libmpm/scene/scene.hpp"

namespace mpm {

/// What is done at the edges, the softest first.
enum class Boundary {
  uniform_stress,  ///< tractions sigma n
  periodic,        ///< opposite edges move alike, but for the mean strain
  uniform_strain,  ///< displacements epsilon x
};

struct EffectiveStiffness {
  Eigen::Matrix3d stiffness;  ///< from mean strains (e_xx, e_yy, gamma_xy) to mean stresses [Pa]; symmetric
  /// Whether the specimen can be in balance under each component of a uniform stress (s_xx, s_yy, s_xy):
  /// nothing can pull at void. Rows of what it cannot carry are zero. Otherwise all true.
  std::array<bool, 3> carried{true, true, true};
  /// Hill's condition: mean of the product of stress and strain less the product of their means, over the
  /// largest energy of all loadings [-].
  double energy_error = 0;
  std::int64_t iterations = 0;  ///< of conjugate gradients, all loadings together
  bool solved = true;           ///< false: equilibrium was not found as exactly as it should be
};

/// The points intact, without inertia. Of the scene only the pixels, phases, plane, cells and the instruction
/// set matter.   @pre the scene has no extra points.   @throws Error for an invalid scene.
[[nodiscard]] EffectiveStiffness effective_stiffness(const Scene& scene, Boundary boundary);

}  // namespace mpm
