#include "apps/live/watching.hpp"

#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include "apps/report/chart_json.hpp"
#include "apps/report/curve_csv.hpp"
#include "apps/report/deflate.hpp"
#include "apps/report/film_data.hpp"
#include "apps/text/html.hpp"
#include "apps/report/report_data.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/report/report_sections.hpp"

namespace output {
namespace {

using Json = nlohmann::ordered_json;

std::string bar(const Stage& stage) {
  return fmt::format(
      "<div class=\"watch\" id=\"watch\" data-number=\"{}\">\n"
      "<progress id=\"watch-done\" max=\"1\" value=\"{:.4f}\" aria-label=\"Share of the run that is done\">"
      "</progress>\n<span id=\"watch-words\" role=\"status\">{}</span>\n"
      "<button type=\"button\" id=\"watch-stop\">Stop the run</button>\n</div>\n",
      stage.number, stage.fraction, escape(stage.words));
}

}  // namespace

std::string watching_html(const RunRecord& record, const Stage& stage) {
  return watching_page(title_of(record),
                       header_html(record) + bar(stage) + curve_section(record) + film_section(record) +
                           ledger_section(record) + specimen_section(record) + solution_section(record) +
                           notes_section(record) + scene_section(record) + citation_section(record),
                       report_data(record));
}

std::string watching_update(const RunRecord& record, const Stage& stage) {
  const Json csv = record.goes_on ? Json(nullptr) : Json(deflated_base64(curve_csv(record.result.history)));
  return inert_text({{"number", stage.number},
                     {"fraction", stage.fraction},
                     {"words", stage.words},
                     {"goes_on", record.goes_on},
                     {"strain", strain_json(record)},
                     {"csv", csv},
                     {"charts", charts_of_run(record)},
                     {"film", has_film(record) ? film_growth(record) : Json(nullptr)},
                     {"parts",
                      {{"facts", facts_part(record)},
                       {"failures", failures_part(record)},
                       {"solution", solution_part(record)}}}});
}

}  // namespace output
