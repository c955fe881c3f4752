/// The members of a study as a table, one a row.
#pragma once

#include <string>
#include <vector>

#include "apps/study/study_results.hpp"
#include "libmpm/files/table_file.hpp"

namespace app {

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
