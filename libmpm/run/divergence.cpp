#include "libmpm/run/divergence.hpp"

#include <cmath>
#include <cstdio>

#include "libmpm/solver/lattice/cell_limit.hpp"

namespace mpm {
namespace {

std::string rounded(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

/// Rounded down, so that what is said to be safe is.
double two_digits_below(double value) {
  const double unit = std::pow(10, std::floor(std::log10(value)) - 1);
  return std::floor(value / unit + 1e-9) * unit;
}

std::string cure(const Scene& scene, const Plan& plan, const Divergence& divergence) {
  const std::string text =
      "the time step of " + rounded(divergence.dt, 4) + " s is too long for this specimen; ";
  const double limit = divergence.moving ? Phase::unbreakable : cell_limit(scene, plan);
  if (divergence.dt < limit) return text + "try a smaller solver.cfl";
  return text + "try a smaller solver.cfl: " + rounded(two_digits_below(scene.cfl * limit / plan.dt), 2) +
         " is safe for each of its cells";
}

}  // namespace

std::string divergence_text(const Scene& scene, const Plan& plan, const Divergence& divergence) {
  std::string text = divergence.what + " at step " + std::to_string(divergence.step) + " (time " +
                     rounded(divergence.time, 4) + " s)";
  if (!divergence.point.empty()) text += ", worst at " + divergence.point;
  return text + ": " + cure(scene, plan, divergence);
}

}  // namespace mpm
