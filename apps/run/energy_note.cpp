#include "apps/run/energy_note.hpp"

#include <fmt/format.h>

#include "apps/report/load_words.hpp"

namespace app {
namespace {

/// Share of the energy put in that the ledger may miss without a word. Points that move lose more to the
/// grid, and can lose it all in the end where rubble is ground.
double tolerated_energy_error(const mpm::Scene& scene) {
  return scene.kinematics == mpm::Kinematics::small_strain ? 0.01 : 0.1;
}

/// What keeps more of the energy than the scene does.
std::string less_dissipation(const mpm::Scene& scene) {
  const mpm::Motion& motion = scene.motion;
  if (motion.transfer == mpm::Transfer::apic || motion.flip_ratio < 1)
    return "motion.transfer = \"flip\" with motion.flip_ratio = 1 loses less";
  if (motion.scheme == mpm::Scheme::usl) return "motion.scheme = \"musl\" or \"usf\" loses less";
  return "a smaller solver.cfl loses less";
}

}  // namespace

std::string energy_note(const mpm::Result& result, const mpm::Scene& scene) {
  if (!(result.energy_error > tolerated_energy_error(scene))) return {};
  const std::string put_in = output::has_platens(scene) ? "the platen work" : "the energy of the flight";
  if (scene.damage.crack_closure == mpm::CrackClosure::clipped)
    return fmt::format(
        "the ledger of energies is off by {:.2g} % of {}; damage.crack_closure = \"clipped\" "
        "does not keep energy, \"unilateral\" does",
        100 * result.energy_error, put_in);
  if (scene.kinematics == mpm::Kinematics::small_strain)
    return fmt::format("the ledger of energies is off by {:.2g} % of {}; try a smaller solver.cfl",
                       100 * result.energy_error, put_in);
  return fmt::format(
      "{:.2g} % of {} was lost to numerical dissipation, as moving points average velocities "
      "through the grid; {}",
      100 * result.energy_error, put_in, less_dissipation(scene));
}

}  // namespace app
