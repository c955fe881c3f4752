#include "apps/study/study_results.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "apps/system/hdf5_turn.hpp"
#include "libmpm/scene/error.hpp"
#include "libmpm/files/result_file.hpp"
#include "specimen/body/digest.hpp"

namespace app {
namespace {

constexpr std::size_t points_kept = 200;

/// Every so many rows of the history, and the one at the peak.
Curve thinned(const mpm::Result& result) {
  const Curve whole = stress_curve(result);
  const std::size_t count = whole.x.size();
  if (count <= points_kept) return whole;
  std::vector<std::size_t> rows{peak_row(result)};
  for (std::size_t i = 0; i < points_kept; ++i) rows.push_back(i * (count - 1) / (points_kept - 1));
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  Curve curve;
  for (const std::size_t row : rows) {
    curve.x.push_back(whole.x[row]);
    curve.y.push_back(whole.y[row]);
  }
  return curve;
}

mpm::Result read_member(const StudyFolder& folder, const Member& member) {
  const std::string path = folder.result_file(member).string();
  const Hdf5Turn turn = hdf5_turn();
  if (specimen::sha256_of_text(mpm::read_scene_text(path)).rfind(member.id, 0) != 0)
    throw mpm::FileError(path, "is the result of another scene", "", "remove it, and run the study again");
  return mpm::read_result(path);
}

void add_cracks(CrackCount& cracks, const mpm::Result& result) {
  const auto& mode = result.failure_mode;
  const bool first = cracks.members == 0;
  ++cracks.members;
  if (first) cracks.failures = mpm::Lattice<int>::Zero(mode.rows(), mode.cols());
  const bool fits = cracks.failures.rows() == mode.rows() && cracks.failures.cols() == mode.cols();
  if (fits)
    cracks.failures += (mode != 0).cast<int>();
  else
    cracks.failures.resize(0, 0);
}

MemberOutcome outcome_of(mpm::Result result) {
  MemberOutcome outcome{MemberState::done, {}, {}, result.history.back()};
  result.history.clear();
  result.failure_strain.resize(0, 0);
  result.failure_mode.resize(0, 0);
  result.crush_strain.resize(0, 0);
  result.end_x.resize(0, 0);
  result.end_y.resize(0, 0);
  for (auto& map : result.deformation) map.resize(0, 0);
  result.extra_failure_strain.clear();
  result.extra_failure_mode.clear();
  outcome.figures = std::move(result);
  return outcome;
}

}  // namespace

std::size_t StudyResults::count(MemberState state) const {
  return static_cast<std::size_t>(std::count_if(
      outcomes.begin(), outcomes.end(), [&](const MemberOutcome& one) { return one.state == state; }));
}

std::vector<double> StudyResults::figure(const std::function<double(const MemberOutcome&)>& of) const {
  std::vector<double> values;
  for (const MemberOutcome& outcome : outcomes)
    values.push_back(outcome.state == MemberState::done ? of(outcome)
                                                        : std::numeric_limits<double>::quiet_NaN());
  return values;
}

std::vector<double> StudyResults::peak_stress() const {
  return figure([](const MemberOutcome& outcome) { return outcome.figures.peak_stress; });
}

std::vector<double> StudyResults::peak_strain() const {
  return figure([](const MemberOutcome& outcome) { return outcome.figures.peak_strain; });
}

StudyResults read_results(const StudyFolder& folder, const std::vector<Member>& members) {
  StudyResults results;
  for (const Member& member : members) {
    results.curves.emplace_back();
    if (folder.has_result(member)) {
      mpm::Result result = read_member(folder, member);
      results.curves.back() = thinned(result);
      add_cracks(results.cracks, result);
      results.outcomes.push_back(outcome_of(std::move(result)));
    } else {
      const std::string reason = folder.failure(member);
      results.outcomes.push_back({reason.empty() ? MemberState::open : MemberState::failed, reason, {}, {}});
    }
  }
  return results;
}

}  // namespace app
