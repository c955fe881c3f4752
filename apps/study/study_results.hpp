/// What the members of a study came to, read back from its folder.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "apps/statistics/curve.hpp"
#include "apps/study/study_folder.hpp"
#include "libmpm/scene/lattice.hpp"
#include "libmpm/scene/result.hpp"

namespace app {

enum class MemberState { open, done, failed };

/// Figures of one member.
struct MemberOutcome {
  MemberState state = MemberState::open;
  std::string reason;   ///< why it has failed
  mpm::Result figures;  ///< of one that is done, without history and maps
  mpm::HistoryRow end;  ///< last row of its history
};

/// How often each pixel has failed by the end of a run.
struct CrackCount {
  mpm::Lattice<int> failures;  ///< by pixel, row 0 on top; empty when the members have no common picture
  int members = 0;
};

struct StudyResults {
  std::vector<MemberOutcome> outcomes;  ///< by member
  std::vector<Curve> curves;            ///< strain [-] and stress [Pa] by member, thinned; empty unless done
  CrackCount cracks;

  [[nodiscard]] std::size_t count(MemberState state) const;
  /// A figure of every member; NaN for those that are not done.
  [[nodiscard]] std::vector<double> figure(const std::function<double(const MemberOutcome&)>& of) const;
  [[nodiscard]] std::vector<double> peak_stress() const;  ///< [Pa]
  [[nodiscard]] std::vector<double> peak_strain() const;  ///< [-]
};

/// Read one result after the other; of each some 200 points of the curve are kept, and of the maps their sum.
/// @throws mpm::FileError for a result that cannot be read, or is that of another scene.
[[nodiscard]] StudyResults read_results(const StudyFolder& folder, const std::vector<Member>& members);

}  // namespace app
