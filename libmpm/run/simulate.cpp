#include "libmpm/run/simulate.hpp"

#include <algorithm>
#include <utility>

#include "libmpm/run/run.hpp"
#include "libmpm/scene/error.hpp"
#include "libmpm/solver/lattice/lattice_solver.hpp"
#include "libmpm/solver/moving/moving_solver.hpp"
#include "libmpm/solver/plan.hpp"
#include "libmpm/solver/quasi_static/quasi_static_solver.hpp"

namespace mpm {
namespace {

const auto never = [] { return false; };

template <class Real>
Result run_moving(const Scene& scene, const Plan& plan, Run& run, MovingStart start) {
  MovingSolver<Real> solver(scene, plan, std::move(start));
  (void)run.drive(solver, true, never);
  return run.end(solver);
}

/// From small strain to the end, whatever the points do on the way.
template <class Real>
Result run_lattice(const Scene& scene, const Plan& plan, Run& run, LatticeSolver<Real>& solver) {
  const bool automatic = scene.kinematics == Kinematics::automatic;
  if (!run.drive(solver, false, [&] { return automatic && solver.outgrows(scene.handover); }))
    return run.end(solver);
  return run_moving<Real>(scene, plan, run, solver.hand_over());
}

template <class Real>
Result run_from_the_start(const Scene& scene, const Plan& plan, const RunHooks& hooks) {
  Run run(scene, plan, hooks);
  if (scene.kinematics == Kinematics::moving)
    return run_moving<Real>(scene, plan, run, pictured_start(scene, plan));
  LatticeSolver<Real> solver(scene, plan);
  return run_lattice(scene, plan, run, solver);
}

[[noreturn]] void refuse(const std::string& why, const std::string& cure) {
  throw FileError("checkpoint", why, "", cure);
}

/// Nothing of the archive may be left, and all of it must have been as it can be.
void close(ArchiveReader& archive) {
  archive.finish();
  if (!archive.ok()) refuse("holds " + archive.fault(), "resume from an earlier one, or start again");
}

/// Without waves, from the start or from an archive.
Result run_quasi_static(const Scene& scene, const Plan& plan, const RunHooks& hooks,
                        const Checkpoint* checkpoint) {
  Run run(scene, plan, hooks);
  QuasiStaticSolver solver(scene, plan);
  if (checkpoint != nullptr) {
    ArchiveReader archive(checkpoint->state);
    run.restore(archive, checkpoint->wall_time);
    solver.restore(archive);
    close(archive);
  }
  (void)run.drive(solver, false, never);
  return run.end(solver);
}

template <class Real>
Result run_from(const Checkpoint& checkpoint, const Scene& scene, const Plan& plan, const RunHooks& hooks) {
  Run run(scene, plan, hooks);
  ArchiveReader archive(checkpoint.state);
  run.restore(archive, checkpoint.wall_time);
  if (checkpoint.moving) {
    MovingStart no_points;
    no_points.maps = empty_maps(scene, plan);
    MovingSolver<Real> solver(scene, plan, std::move(no_points));
    solver.restore(archive);
    close(archive);
    (void)run.drive(solver, true, never);
    return run.end(solver);
  }
  LatticeSolver<Real> solver(scene, plan);
  solver.restore(archive);
  close(archive);
  return run_lattice(scene, plan, run, solver);
}

void check_that_it_fits(const Scene& scene, const Checkpoint& checkpoint) {
  const char* cure = "resume with the scene that the run was started with";
  if (checkpoint.precision != scene.precision) refuse("has another precision than the scene", cure);
  if (checkpoint.specimen != specimen_digest(scene)) refuse("has another specimen than the scene", cure);
  const bool may_move = scene.kinematics != Kinematics::small_strain;
  const bool may_stay = scene.kinematics != Kinematics::moving;
  if (!(checkpoint.moving ? may_move : may_stay)) refuse("has other kinematics than the scene", cure);
}

/// The scene on the instruction set of the checkpoint, whose bits no other gives.
Scene on_the_same_instructions(const Scene& scene, const Checkpoint& checkpoint) {
  Scene same = scene;
  const auto available = available_kernels();
  const bool runs = std::any_of(available.begin(), available.end(), [&](const kernels::Kernels* kernels) {
    return kernels->name == checkpoint.instruction_set;
  });
  if (!runs)
    refuse("needs a processor that supports " + checkpoint.instruction_set,
           "resume on the machine of the run; with solver.instruction_set = \"baseline\" a run resumes "
           "anywhere");
  if (!scene.instruction_set.empty() && scene.instruction_set != checkpoint.instruction_set)
    refuse("has the instruction set " + checkpoint.instruction_set,
           "resume with the scene that the run was started with");
  same.instruction_set = checkpoint.instruction_set;
  return same;
}

}  // namespace

Result simulate(const Scene& scene, const RunHooks& hooks) { return simulate(scene, plan(scene), hooks); }

Result simulate(const Scene& scene, const Plan& plan, const RunHooks& hooks) {
  if (scene.method == SolverMethod::quasi_static) return run_quasi_static(scene, plan, hooks, nullptr);
  return scene.precision == Precision::single ? run_from_the_start<float>(scene, plan, hooks)
                                              : run_from_the_start<double>(scene, plan, hooks);
}

Result resume(const Scene& scene, const Checkpoint& checkpoint, const RunHooks& hooks) {
  const Plan planned = plan(scene);
  check_that_it_fits(scene, checkpoint);
  const Scene same = on_the_same_instructions(scene, checkpoint);
  if (scene.method == SolverMethod::quasi_static) return run_quasi_static(same, planned, hooks, &checkpoint);
  return scene.precision == Precision::single ? run_from<float>(checkpoint, same, planned, hooks)
                                              : run_from<double>(checkpoint, same, planned, hooks);
}

}  // namespace mpm
