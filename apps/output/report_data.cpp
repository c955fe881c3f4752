#include "apps/output/report_data.hpp"

#include <nlohmann/json.hpp>

#include "apps/output/chart_json.hpp"
#include "apps/output/curve_csv.hpp"
#include "apps/output/deflate.hpp"
#include "apps/output/film_data.hpp"
#include "apps/output/reference_series.hpp"
#include "apps/output/run_charts.hpp"
#include "apps/output/specimen_charts.hpp"
#include "apps/output/strain_unit.hpp"

namespace output {
std::string report_data(const RunRecord& record) {
  using Json = nlohmann::ordered_json;
  const StrainUnit unit = strain_unit(record.result);
  Json charts;
  charts["stress"] = chart_json(stress_chart(record), reference_series(record));
  charts["energy"] = chart_json(energy_chart(record));
  charts["failure"] = chart_json(failure_chart(record));
  charts["failure-strain"] = chart_json(failure_strain_chart(record));
  charts["sieve"] = chart_json(sieve_chart(record.specimen), sieve_references(record.specimen));
  const Json data = {{"strain", {{"name", unit.name}, {"per_strain", unit.per_strain}}},
                     {"csv", deflated_base64(curve_csv(record.result.history))},
                     {"charts", charts},
                     {"film", has_film(record) ? film_data(record) : Json(nullptr)}};
  return inert_text(data);
}

}  // namespace output
