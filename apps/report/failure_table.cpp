#include "apps/report/failure_table.hpp"

#include <cmath>

namespace output {
namespace {

void count_pixel(FailureCount& count, const mpm::Result& result, Eigen::Index pixel) {
  ++count.points;
  if (result.failure_mode.size() == 0) return;
  const auto mode = static_cast<mpm::FailureMode>(result.failure_mode.data()[pixel]);
  count.tension += mode == mpm::FailureMode::tension;
  count.shear += mode == mpm::FailureMode::shear;
  count.crushed += result.crush_strain.size() > 0 && !std::isnan(result.crush_strain.data()[pixel]);
}

}  // namespace

std::vector<FailureCount> failures_by_phase(const RunRecord& record) {
  const specimen::LabelledMask& mask = record.specimen.mask;
  std::vector<FailureCount> counts;
  for (const std::string& phase : mask.phases) counts.push_back({phase});
  for (std::size_t i = 0; i < mask.labels.size(); ++i)
    count_pixel(counts.at(mask.labels.data[i]), record.result, static_cast<Eigen::Index>(i));
  std::erase_if(counts, [](const FailureCount& count) { return count.points == 0; });
  return counts;
}

FailureCount failures_of_extra_points(const RunRecord& record, const std::vector<FailureCount>& by_phase) {
  FailureCount extra{"extra points", static_cast<std::int64_t>(record.scene.extra_points.size()),
                     record.result.tension_failures, record.result.shear_failures, 0};
  for (const FailureCount& count : by_phase) {
    extra.tension -= count.tension;
    extra.shear -= count.shear + count.crushed;
  }
  return extra;
}

}  // namespace output
