#include "apps/report/report.hpp"

#include "apps/report/report_data.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/report/report_sections.hpp"

namespace output {

std::string report_html(const RunRecord& record) {
  return live_page(title_of(record),
                   header_html(record) + curve_section(record) + error_section(record) +
                       film_section(record) + damage_section(record) + specimen_section(record) +
                       ledger_section(record) + solution_section(record) + notes_section(record) +
                       scene_section(record) + citation_section(record),
                   report_data(record));
}

}  // namespace output
