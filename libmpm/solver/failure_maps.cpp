#include "libmpm/solver/failure_maps.hpp"

#include <limits>

namespace mpm {

FailureMaps empty_maps(const Scene& scene, const Plan& plan) {
  FailureMaps maps;
  if (plan.features.check == kernels::Check::none) return maps;
  const float never = std::numeric_limits<float>::quiet_NaN();
  maps.failure_strain.setConstant(scene.labels.rows(), scene.labels.cols(), never);
  maps.failure_mode.setZero(scene.labels.rows(), scene.labels.cols());
  if (plan.features.crack_closure) maps.crush_strain = maps.failure_strain;
  maps.extra_failure_strain.assign(scene.extra_points.size(), never);
  maps.extra_failure_mode.assign(scene.extra_points.size(), 0);
  return maps;
}

void FailureMaps::copy_to(Result& result) const {
  result.failure_strain = failure_strain;
  result.failure_mode = failure_mode;
  result.crush_strain = crush_strain;
  result.extra_failure_strain = extra_failure_strain;
  result.extra_failure_mode = extra_failure_mode;
}

}  // namespace mpm
