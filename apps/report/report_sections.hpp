/// The sections of the report, in the order of the page. Each returns HTML.
#pragma once

#include <string>

#include "apps/report/run_record.hpp"

namespace output {

[[nodiscard]] std::string header_html(const RunRecord& record);    ///< title, setting
[[nodiscard]] std::string notes_section(const RunRecord& record);  ///< what was guessed or cut short
[[nodiscard]] std::string curve_section(const RunRecord& record);  ///< stress chart and key figures
[[nodiscard]] std::string error_section(
    const RunRecord& record);  ///< how wrong the peak may be; empty for none
[[nodiscard]] std::string film_section(
    const RunRecord& record);  ///< the damage over strain, for the script; empty for none
[[nodiscard]] std::string damage_section(const RunRecord& record);  ///< pictures at shares of the peak strain
[[nodiscard]] std::string specimen_section(const RunRecord& record);  ///< preview and statistics
[[nodiscard]] std::string ledger_section(const RunRecord& record);    ///< energies, failures, their table
[[nodiscard]] std::string solution_section(const RunRecord& record);  ///< how it was computed, from what
[[nodiscard]] std::string scene_section(const RunRecord& record);
[[nodiscard]] std::string glossary_section();  ///< the terms of the page, folded
[[nodiscard]] std::string citation_section(const RunRecord& record);

/// The parts of these sections that change while a run is going on.
[[nodiscard]] std::string facts_part(const RunRecord& record);     ///< of curve_section
[[nodiscard]] std::string failures_part(const RunRecord& record);  ///< of ledger_section
[[nodiscard]] std::string solution_part(const RunRecord& record);  ///< of solution_section

/// The user's title, or one made from the setting.
[[nodiscard]] std::string title_of(const RunRecord& record);

}  // namespace output
