/// What the members of a study came to, read back from its folder and as a table.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "apps/statistics/curve.hpp"
#include "apps/study/study_folder.hpp"
#include "libmpm/files/table_file.hpp"
#include "libmpm/scene/phase.hpp"
#include "libmpm/scene/result.hpp"

namespace app {

enum class MemberState { open, done, failed };

/// Figures of one member.
struct MemberOutcome {
  MemberState state = MemberState::open;
  std::string reason;        ///< why it has failed
  mpm::Result figures;       ///< of one that is done, without history and maps
  mpm::HistoryRow end;       ///< last row of its history
  bool peak_reached = true;  ///< its largest stress is a peak
  std::string inertia = {};  ///< why it is no slow test, see inertia_note(); empty if it is one
};

/// How often each pixel has failed by the end of a run.
struct CrackCount {
  mpm::PixelField<int> failures;  ///< by pixel, row 0 on top; empty when the members have no common picture
  int members = 0;
};

struct StudyResults {
  std::vector<MemberOutcome> outcomes;  ///< by member
  std::vector<Curve> curves;            ///< strain [-] and stress [Pa] by member, thinned; empty unless done
  CrackCount cracks;

  [[nodiscard]] std::size_t count(MemberState state) const;
  /// A figure of every member; NaN for those that are not done.
  [[nodiscard]] std::vector<double> figure(const std::function<double(const MemberOutcome&)>& of) const;
  /// Of members whose largest stress is a peak; NaN for all others, so that no statistics hold them.
  [[nodiscard]] std::vector<double> peak_stress() const;  ///< [Pa]
  [[nodiscard]] std::vector<double> peak_strain() const;  ///< [-]
  [[nodiscard]] std::size_t without_peak() const;         ///< members that are done and have none
};

/// "3 of 20 members reached no peak and count in no statistics; choose ..."; empty where all have one.
[[nodiscard]] std::string without_peak_text(const StudyResults& results);

/// "3 of 20 members are no slow tests, such as member 4: ..."; empty where all are.
[[nodiscard]] std::string inertia_text(const StudyResults& results);

/// Read one result after the other; of each some 200 points of the curve are kept, and of the maps their sum.
/// @throws mpm::FileError for a result that cannot be read, or is that of another scene.
[[nodiscard]] StudyResults read_results(const StudyFolder& folder, const std::vector<Member>& members);

/// Number, id, state, parameters, seed, and the figures of a result. All follow from the study alone:
/// whatever ran where and in which order, the table is the same to the last bit, on processors with one
/// instruction set.
[[nodiscard]] std::vector<mpm::TableColumn> study_table(const Study& study,
                                                        const std::vector<Member>& members,
                                                        const StudyResults& results);

/// What each member took: number, id, wall time of its steps, instruction set.
[[nodiscard]] std::vector<mpm::TableColumn> timing_table(const std::vector<Member>& members,
                                                         const StudyResults& results);

/// Comma separated, one header line with the SI unit in each name. Numbers read back as the same doubles, in
/// any locale; a number that is none is an empty cell. Texts with commas or quotes stand in quotes (RFC
/// 4180).
[[nodiscard]] std::string table_csv(const std::vector<mpm::TableColumn>& columns);

}  // namespace app
