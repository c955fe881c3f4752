/// What is known of the stiffness of a mixture from the shares of its phases alone; and the isotropic
/// material nearest to a tensor.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "libmpm/scene/phase.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {

/// Moduli of an isotropic material in the plane: stiffness of area, C_xxxx - shear, and of shape.
struct PlaneModuli {
  double bulk = 0;   ///< k [Pa], >= 0
  double shear = 0;  ///< G [Pa], >= 0
};

[[nodiscard]] PlaneModuli plane_moduli(const Phase& phase, Plane plane);
/// The tensor of these moduli [Pa]; see stiffness(const Phase&, Plane).
[[nodiscard]] Eigen::Matrix3d stiffness(const PlaneModuli& moduli);

/// The material that has these moduli under the plane assumption.
struct ElasticConstants {
  double young = 0;    ///< E [Pa]
  double poisson = 0;  ///< nu [-]
};
/// Zeros for a material without stiffness.
[[nodiscard]] ElasticConstants elastic_constants(const PlaneModuli& moduli, Plane plane);

struct NearestIsotropic {
  PlaneModuli moduli;
  double distance = 0;  ///< norm of the difference over that of the tensor [-]; 0 = isotropic
};
/// The isotropic tensor nearest to one in the Frobenius norm of the fourth-order tensor, whose components
/// with a shear index count twice each (Kelvin's notation).
/// @param stiffness  [Pa], from (e_xx, e_yy, gamma_xy) to (s_xx, s_yy, s_xy).
/// Source: Moakher, Norris, J. Elasticity 85 (2006) 215-263.
[[nodiscard]] NearestIsotropic nearest_isotropic(const Eigen::Matrix3d& stiffness);

/// A phase of a mixture. Void has no moduli.
struct PhaseShare {
  double share = 0;  ///< of the area [-]
  PlaneModuli moduli;
};
/// Of the pixels of a scene; phases without pixels are left out.   @pre the scene is valid.
[[nodiscard]] std::vector<PhaseShare> phase_shares(const Scene& scene);

/// Bounds on the moduli, from the lowest to the highest. Reuss and Voigt hold for every tensor as a quadratic
/// form, Hashin and Shtrikman's for mixtures that are isotropic in the plane and much finer than the
/// specimen. With void the lower ones are zero.
struct StiffnessBounds {
  PlaneModuli reuss, hashin_shtrikman_lower, hashin_shtrikman_upper, voigt;
};
/// @param phases  whose shares add up to 1.
/// Source: Hill, J. Mech. Phys. Solids 11 (1963) 357-372; Hashin, J. Mech. Phys. Solids 13 (1965) 119-134, in
/// the plane; with the extreme moduli of all phases, Walpole, J. Mech. Phys. Solids 17 (1969) 235-251.
[[nodiscard]] StiffnessBounds stiffness_bounds(const std::vector<PhaseShare>& phases);

}  // namespace mpm
