#include "apps/report/report_data.hpp"

#include <nlohmann/json.hpp>

#include "apps/report/chart_json.hpp"
#include "apps/report/curve_csv.hpp"
#include "apps/report/deflate.hpp"
#include "apps/report/film_data.hpp"
#include "apps/report/reference_series.hpp"
#include "apps/report/run_charts.hpp"
#include "apps/report/specimen_charts.hpp"
#include "apps/drawing/strain_unit.hpp"

namespace output {

using Json = nlohmann::ordered_json;

Json strain_json(const RunRecord& record) {
  const StrainUnit unit = strain_unit(record.result);
  return {{"name", unit.name}, {"per_strain", unit.per_strain}};
}

Json charts_of_run(const RunRecord& record) {
  return {{"stress", chart_json(stress_chart(record), reference_series(record))},
          {"energy", chart_json(energy_chart(record))},
          {"failure", chart_json(failure_chart(record))},
          {"failure-strain", chart_json(failure_strain_chart(record))}};
}

std::string report_data(const RunRecord& record) {
  Json charts = charts_of_run(record);
  charts["sieve"] = chart_json(sieve_chart(record.specimen), sieve_references(record.specimen));
  const Json csv = record.goes_on ? Json(nullptr) : Json(deflated_base64(curve_csv(record.result.history)));
  return inert_text({{"strain", strain_json(record)},
                     {"csv", csv},
                     {"charts", std::move(charts)},
                     {"film", has_film(record) ? film_data(record) : Json(nullptr)}});
}

}  // namespace output
