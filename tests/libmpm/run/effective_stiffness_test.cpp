#include "libmpm/run/effective_stiffness.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

#include "libmpm/material/stiffness_bounds.hpp"
#include "libmpm/scene/phase.hpp"

namespace effective_stiffness_test {

using mpm::Boundary;
using mpm::EffectiveStiffness;
using mpm::Scene;

constexpr Boundary all[] = {Boundary::uniform_stress, Boundary::periodic, Boundary::uniform_strain};
constexpr int pixel = 0;  ///< for points per cell

/// A block of label 1, with label 2 of another phase and label 0 of void.
Scene block(int rows, int cols, int cells = pixel) {
  Scene scene;
  scene.labels = mpm::PixelField<std::uint8_t>::Constant(rows, cols, 1);
  scene.pixel_size = 0.5e-3;
  scene.phases = {std::nullopt, mpm::Phase{.name = "one", .young = 20e9, .poisson = 0.2, .density = 2400},
                  mpm::Phase{.name = "two", .young = 40e9, .poisson = 0.2, .density = 2400}};
  scene.pixel_cells = cells == pixel;
  scene.points_per_cell = std::max(1, cells);
  return scene;
}

/// Discs of label `of` at random places, going on at the opposite edge.
Scene with_discs(Scene scene, std::uint8_t of, unsigned seed) {
  std::mt19937 random(seed);
  const auto rows = static_cast<int>(scene.labels.rows());
  const auto cols = static_cast<int>(scene.labels.cols());
  for (int disc = 0; disc < rows * cols / 250; ++disc) {
    const int row = static_cast<int>(random() % static_cast<unsigned>(rows));
    const int col = static_cast<int>(random() % static_cast<unsigned>(cols));
    const int radius = 3 + static_cast<int>(random() % 5U);
    for (int y = -radius; y <= radius; ++y)
      for (int x = -radius; x <= radius; ++x)
        if (x * x + y * y <= radius * radius)
          scene.labels((row + y + rows) % rows, (col + x + cols) % cols) = of;
  }
  return scene;
}

Eigen::Matrix3d of(const Scene& scene, Boundary boundary) {
  const EffectiveStiffness found = effective_stiffness(scene, boundary);
  EXPECT_TRUE(found.solved);
  return found.stiffness;
}

double difference(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) { return (a - b).norm() / b.norm(); }

/// Least eigenvalue of a - b over the norm of a, for tensors as quadratic forms [-].
double excess(const Eigen::Matrix3d& a, const Eigen::Matrix3d& b) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(a - b).eigenvalues().minCoeff() / a.norm();
}

TEST(EffectiveStiffness, AUniformSpecimenHasTheTensorOfItsPhase) {
  for (const mpm::Plane plane : {mpm::Plane::strain, mpm::Plane::stress})
    for (const int cells : {pixel, 1, 2, 3})
      for (const auto& [rows, cols] : {std::pair{1, 1}, {2, 5}, {17, 22}, {36, 25}, {33, 7}}) {
        const int k = std::max(1, cells);
        Scene scene = block(k * rows, k * cols, cells);
        scene.plane = plane;
        for (const Boundary boundary : all)
          EXPECT_LT(difference(of(scene, boundary), mpm::stiffness(*scene.phases[1], plane)), 1e-8)
              << cells << " " << rows << " " << cols;
      }
}

/// The exact tensor of layers across y. Source: Milton, The Theory of Composites (2002), ch. 9.
Eigen::Matrix3d laminate(const Scene& scene) {
  double one_over = 0;
  double ratio = 0;
  double rest = 0;
  double shear = 0;
  for (Eigen::Index row = 0; row < scene.labels.rows(); ++row) {
    const Eigen::Matrix3d c = mpm::stiffness(*scene.phases[scene.labels(row, 0)], scene.plane);
    const double share = 1 / static_cast<double>(scene.labels.rows());
    one_over += share / c(1, 1);
    ratio += share * c(0, 1) / c(1, 1);
    rest += share * (c(0, 0) - c(0, 1) * c(0, 1) / c(1, 1));
    shear += share / c(2, 2);
  }
  Eigen::Matrix3d c = Eigen::Matrix3d::Zero();
  c(0, 0) = rest + ratio * ratio / one_over;
  c(0, 1) = c(1, 0) = ratio / one_over;
  c(1, 1) = 1 / one_over;
  c(2, 2) = 1 / shear;
  return c;
}

TEST(EffectiveStiffness, PeriodicLayersAreExactWhateverTheirThickness) {
  for (const mpm::Plane plane : {mpm::Plane::strain, mpm::Plane::stress}) {
    Scene scene = block(23, 14);
    scene.plane = plane;
    scene.phases[2]->poisson = 0.35;
    for (const int row : {3, 4, 5, 11, 22}) scene.labels.row(row).setConstant(2);
    EXPECT_LT(difference(of(scene, Boundary::periodic), laminate(scene)), 1e-9);
  }
}

TEST(EffectiveStiffness, LayersWithoutPoissonsEffectAreThoseOfVoigtAndReuss) {
  Scene scene = block(24, 24);
  for (const int label : {1, 2}) scene.phases[static_cast<std::size_t>(label)]->poisson = 0;
  scene.labels.topRows(12).setConstant(2);
  for (const Boundary boundary : all) {
    const Eigen::Matrix3d c = of(scene, boundary);
    if (boundary != Boundary::uniform_stress) {
      EXPECT_NEAR(c(0, 0), 30e9, 30e3);
    }
    if (boundary != Boundary::uniform_strain) {
      EXPECT_NEAR(c(1, 1), 80e9 / 3, 27e3);
    }
  }
}

TEST(EffectiveStiffness, StressPeriodicStrainStandInThisOrderBetweenReussAndVoigt) {
  for (const int cells : {pixel, 2}) {
    Scene scene = with_discs(block(62, 74, cells), 2, 3);
    scene.phases[2]->young = 500e9;
    scene.phases[2]->poisson = 0.3;
    const mpm::StiffnessBounds bounds = stiffness_bounds(phase_shares(scene));
    std::vector<Eigen::Matrix3d> rising{stiffness(bounds.reuss)};
    for (const Boundary boundary : all) rising.push_back(of(scene, boundary));
    rising.push_back(stiffness(bounds.voigt));
    for (std::size_t i = 1; i < rising.size(); ++i)
      EXPECT_GT(excess(rising[i], rising[i - 1]), 1e-6) << cells << " " << i;
  }
}

/// The same cells of 2 x 2 points, assembled in full by other means, and Eigen's decomposition.
Eigen::Matrix3d assembled_periodic(const Scene& scene) {
  const auto rows = static_cast<int>(scene.labels.rows()) / 2;
  const auto cols = static_cast<int>(scene.labels.cols()) / 2;
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(2 * rows * cols, 2 * rows * cols);
  Eigen::MatrixXd load = Eigen::MatrixXd::Zero(2 * rows * cols, 3);
  Eigen::Matrix3d mean = Eigen::Matrix3d::Zero();
  for (int row = 0; row < rows; ++row)
    for (int col = 0; col < cols; ++col) {
      for (int point = 0; point < 4; ++point) {
        const int pixel_row = 2 * row + point / 2;  // from below
        const std::uint8_t label = scene.labels(2 * rows - 1 - pixel_row, 2 * col + point % 2);
        const Eigen::Matrix3d c = mpm::stiffness(*scene.phases[label], scene.plane);
        const double x = 0.25 + 0.5 * (point % 2);
        const double y = 0.25 + 0.5 * (point / 2);
        Eigen::Matrix<double, 3, Eigen::Dynamic> b =
            Eigen::Matrix<double, 3, Eigen::Dynamic>::Zero(3, 2 * rows * cols);
        for (int node = 0; node < 4; ++node) {
          const int at = 2 * ((row + node / 2) % rows * cols + (col + node % 2) % cols);
          const double dx = (node % 2 == 0 ? -1 : 1) * (node / 2 == 0 ? 1 - y : y);
          const double dy = (node / 2 == 0 ? -1 : 1) * (node % 2 == 0 ? 1 - x : x);
          b.block<3, 2>(0, at) += (Eigen::Matrix<double, 3, 2>() << dx, 0, 0, dy, dy, dx).finished();
        }
        stiffness += 0.25 * b.transpose() * c * b;
        load -= 0.25 * b.transpose() * c;
        mean += 0.25 * c;
      }
    }
  const Eigen::MatrixXd u = stiffness.completeOrthogonalDecomposition().solve(load);
  return (mean - load.transpose() * u) / (rows * cols);
}

TEST(EffectiveStiffness, IsThatOfAnAssembledMatrix) {
  for (const mpm::Plane plane : {mpm::Plane::strain, mpm::Plane::stress}) {
    Scene scene = block(18, 14, 2);
    scene.plane = plane;
    scene.phases[2]->poisson = 0.4;
    std::mt19937 random(5);
    for (auto& label : scene.labels.reshaped()) label = static_cast<std::uint8_t>(1 + random() % 2U);
    EXPECT_LT(difference(of(scene, Boundary::periodic), assembled_periodic(scene)), 1e-9);
  }
}

TEST(EffectiveStiffness, APeriodicSpecimenMayBeginAnywhere) {
  const Scene scene = with_discs(block(41, 53), 2, 1);
  const Eigen::Matrix3d expected = of(scene, Boundary::periodic);
  for (const auto& [down, right] : {std::pair{1, 0}, {0, 1}, {17, 29}}) {
    Scene moved = scene;
    for (Eigen::Index row = 0; row < 41; ++row)
      for (Eigen::Index col = 0; col < 53; ++col)
        moved.labels((row + down) % 41, (col + right) % 53) = scene.labels(row, col);
    EXPECT_LT(difference(of(moved, Boundary::periodic), expected), 1e-9);
  }
}

TEST(EffectiveStiffness, TurnsWithThePicture) {
  const Scene scene = with_discs(block(41, 53), 2, 1);
  Scene turned = scene;
  turned.labels = scene.labels.transpose().rowwise().reverse().eval();  // a quarter to the right
  for (const Boundary boundary : all) {
    const Eigen::Matrix3d c = of(scene, boundary);
    Eigen::Matrix3d expected = c;
    std::swap(expected(0, 0), expected(1, 1));
    expected(0, 2) = expected(2, 0) = -c(1, 2);
    expected(1, 2) = expected(2, 1) = -c(0, 2);
    EXPECT_LT(difference(of(turned, boundary), expected), 1e-9);
  }
}

/// Where the phases share their shear modulus, that of area follows from their shares alone. Source: Hill,
/// J. Mech. Phys. Solids 12 (1964) 199-212.
TEST(EffectiveStiffness, NearsTheExactOneOfACheckerboardOfOneShearModulus) {
  double before = 0;
  for (const int size : {16, 32, 64}) {
    Scene scene = block(size, size);
    for (const auto& [label, poisson] : {std::pair{1, 0.0}, {2, 0.45}}) {
      mpm::Phase& phase = *scene.phases[static_cast<std::size_t>(label)];
      phase.poisson = poisson;
      phase.young = 2 * 10e9 * (1 + poisson);
    }
    scene.labels.topLeftCorner(size / 2, size / 2).setConstant(2);
    scene.labels.bottomRightCorner(size / 2, size / 2).setConstant(2);
    const auto [one, two] = std::pair{plane_moduli(*scene.phases[1], scene.plane).bulk,
                                      plane_moduli(*scene.phases[2], scene.plane).bulk};
    const double exact = 1 / (0.5 / (one + 10e9) + 0.5 / (two + 10e9)) - 10e9;
    const mpm::NearestIsotropic found = mpm::nearest_isotropic(of(scene, Boundary::periodic));
    const double error = found.moduli.bulk / exact - 1;
    EXPECT_GT(error, 0);  // displacements that are not exact make it stiffer
    EXPECT_LT(error, 0.02);
    if (before > 0) {
      EXPECT_LT(error, 0.5 * before);
    }
    before = error;
  }
}

/// One small disc: what it adds is its share times a closed form. Source: Christensen, Mechanics of Composite
/// Materials (1979), ch. II.
TEST(EffectiveStiffness, ADiscOrAHoleChangesItAsInTheClosedForm) {
  for (const std::uint8_t label : {std::uint8_t{2}, std::uint8_t{0}}) {
    Scene scene = block(125, 125);
    scene.phases[2]->young = 200e9;
    for (int row = 0; row < 125; ++row)
      for (int col = 0; col < 125; ++col)
        if (std::hypot(row - 62, col - 62) < 12.5) scene.labels(row, col) = label;
    const std::vector<mpm::PhaseShare> shares = phase_shares(scene);
    const mpm::PlaneModuli matrix = shares[label == 0 ? 1 : 0].moduli;
    const mpm::PhaseShare disc = shares[label == 0 ? 0 : 1];
    const double k = matrix.bulk;
    const double g = matrix.shear;
    const double bulk = disc.share * (disc.moduli.bulk - k) * (k + g) / (disc.moduli.bulk + g);
    const double zeta = g * k / (k + 2 * g);
    const double shear = disc.share * (disc.moduli.shear - g) * (g + zeta) / (disc.moduli.shear + zeta);
    const double interaction = 3 * disc.share;  // with its images
    for (const Boundary boundary : all) {
      const mpm::PlaneModuli found = mpm::nearest_isotropic(of(scene, boundary)).moduli;
      EXPECT_NEAR((found.bulk - k) / bulk, 1, interaction + 0.04);
      EXPECT_NEAR((found.shear - g) / shear, 1, interaction + 0.04);
    }
  }
}

TEST(EffectiveStiffness, FindsEquilibriumAtAnyContrast) {
  for (const double young : {20e15, 20e18, 20e3, 20.0}) {
    Scene scene = with_discs(block(45, 52), 2, 4);
    scene.phases[2]->young = young;
    for (const Boundary boundary : all) {
      const EffectiveStiffness found = effective_stiffness(scene, boundary);
      EXPECT_TRUE(found.solved) << young;
      EXPECT_LT(found.energy_error, 1e-3) << young;
      EXPECT_TRUE(found.stiffness.allFinite());
    }
  }
}

TEST(EffectiveStiffness, TakesFewIterationsWhateverTheSize) {
  for (const auto& [rows, cols] : {std::pair{64, 64}, {127, 129}, {97, 61}, {200, 30}})
    for (const Boundary boundary : all) {
      const EffectiveStiffness found = effective_stiffness(with_discs(block(rows, cols), 2, 2), boundary);
      EXPECT_LE(found.iterations, 45) << rows << " " << cols;
      EXPECT_LT(found.energy_error, 1e-6);  // Hill's condition
    }
}

TEST(EffectiveStiffness, AHoleInsideIsNoObstacle) {
  Scene scene = block(30, 40);
  scene.labels.block(8, 9, 14, 21).setConstant(0);
  scene.labels.block(12, 14, 5, 8).setConstant(1);  // and a piece that floats in it
  double before = 0;
  for (const Boundary boundary : all) {
    const EffectiveStiffness found = effective_stiffness(scene, boundary);
    EXPECT_TRUE(found.solved);
    EXPECT_EQ(found.carried, (std::array<bool, 3>{true, true, true}));
    const double young = mpm::nearest_isotropic(found.stiffness).moduli.shear;
    EXPECT_GT(young, before);
    EXPECT_LT(young, 8.4e9);
    before = young;
  }
}

TEST(EffectiveStiffness, NothingPullsAtVoid) {
  Scene scene = block(24, 24);
  scene.labels.block(10, 23, 2, 1).setConstant(0);  // at the right edge
  const EffectiveStiffness stress = effective_stiffness(scene, Boundary::uniform_stress);
  EXPECT_EQ(stress.carried, (std::array<bool, 3>{false, true, false}));
  EXPECT_GT(stress.stiffness(1, 1), 15e9);
  EXPECT_EQ(stress.stiffness(0, 0), 0);
  EXPECT_EQ(stress.stiffness(2, 2), 0);
  EXPECT_EQ(stress.stiffness(0, 1), 0);
  EXPECT_GT(of(scene, Boundary::periodic)(0, 0), 15e9);
}

TEST(EffectiveStiffness, PiecesApartCarryNothingAcross) {
  Scene scene = block(24, 24);
  scene.labels.middleRows(10, 3).setConstant(0);
  const EffectiveStiffness stress = effective_stiffness(scene, Boundary::uniform_stress);
  EXPECT_EQ(stress.carried, (std::array<bool, 3>{false, false, false}));
  EXPECT_EQ(stress.stiffness.norm(), 0);
  const EffectiveStiffness periodic = effective_stiffness(scene, Boundary::periodic);
  EXPECT_TRUE(periodic.solved);
  EXPECT_LT(periodic.stiffness(1, 1), 1e-6 * periodic.stiffness(0, 0));
  const double along = scene.phases[1]->young / (1 - 0.04) * 21 / 24;
  EXPECT_NEAR(periodic.stiffness(0, 0), along, 1e-6 * along);
}

}  // namespace effective_stiffness_test
