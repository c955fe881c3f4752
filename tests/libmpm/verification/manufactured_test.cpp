// Large deformation with a solution made up beforehand: the order of convergence, with and without points
// that cross cells.
#include "libmpm/problems/waves.hpp"

#include <gtest/gtest.h>

#include "tests/libmpm/moving_scenes.hpp"
#include "tests/libmpm/verification/order.hpp"

namespace manufactured_test {

using samples::Method;

double error(const Method& method, int cells, double amplitude) {
  const auto outcome = mpm::problems::deform_as_made_up(method, cells, amplitude);
  EXPECT_EQ(outcome.trouble, "");
  return outcome.error;
}

double order(const Method& method, double amplitude, const std::vector<int>& grids) {
  std::vector<double> sizes, errors;
  for (const int cells : grids) {
    sizes.push_back(1.0 / cells);
    errors.push_back(error(method, cells, amplitude));
  }
  const double result = samples::fitted_order(sizes, errors);
  if (samples::figures)
    std::printf("A %.4f %-16s error %.2e .. %.2e order %.2f\n", amplitude, method.name().c_str(),
                errors.front(), errors.back(), result);
  return result;
}

// Without USF, to which the kick of the body force does wrong.
std::vector<Method> methods(mpm::Shape shape) {
  std::vector<Method> all;
  for (const auto scheme : {mpm::Scheme::usl, mpm::Scheme::musl})
    for (const auto transfer : {mpm::Transfer::flip, mpm::Transfer::apic})
      all.push_back({shape, scheme, transfer, 1});
  return all;
}

// While no point crosses a cell every shape is of second order.
TEST(Manufactured, SmallDeformationIsOfSecondOrderWithEveryShape) {
  for (const auto shape : samples::all_shapes())
    for (const Method& method : methods(shape)) EXPECT_GT(order(method, 1e-4, {8, 16}), 1.9) << method.name();
}

// Displacements of 0.05 take points over up to two cells. The gradient of linear shapes jumps there, by an
// amount that does not fall with the cell: no convergence. Smooth shapes keep close to second order with
// FLIP; APIC smooths with a viscosity of about c h, so that it falls to first order, at a smaller error on
// coarse grids. Source: Steffen, Kirby, Berzins, IJNME 76 (2008), on the errors of quadrature and of
// crossing.
TEST(Manufactured, LinearShapesDoNotConvergeOnceTheyCrossCells) {
  EXPECT_LT(order({mpm::Shape::linear, mpm::Scheme::musl}, 0.05, {8, 16, 32}), 0.6);
  EXPECT_LT(order({mpm::Shape::linear, mpm::Scheme::musl, mpm::Transfer::apic}, 0.05, {8, 16, 32}), 0.6);
}
TEST(Manufactured, GimpConvergesOverCells) {
  EXPECT_GT(order({mpm::Shape::gimp, mpm::Scheme::musl}, 0.05, {8, 16, 32}), 1.7);
  EXPECT_GT(order({mpm::Shape::gimp, mpm::Scheme::usl}, 0.05, {8, 16}), 1.5);
  EXPECT_GT(order({mpm::Shape::gimp, mpm::Scheme::musl, mpm::Transfer::apic}, 0.05, {8, 16, 32}), 0.9);
}
TEST(Manufactured, BSplinesConvergeOverCells) {
  EXPECT_GT(order({mpm::Shape::bspline, mpm::Scheme::musl}, 0.05, {8, 16, 32}), 1.7);
  EXPECT_GT(order({mpm::Shape::bspline, mpm::Scheme::usl}, 0.05, {8, 16}), 1.5);
  EXPECT_GT(order({mpm::Shape::bspline, mpm::Scheme::musl, mpm::Transfer::apic}, 0.05, {8, 16, 32}), 0.9);
}

}  // namespace manufactured_test
