#include "apps/run/run_remarks.hpp"

#include <nlohmann/json.hpp>

#include "apps/text/complaint.hpp"

namespace app {
namespace {

using nlohmann::json;

json json_of(const output::ErrorSource& source) {
  return {{"name", source.name},
          {"compared", source.compared},
          {"peak_stress", source.peak_stress},
          {"peak_strain", source.peak_strain},
          {"stress_error", source.stress_error},
          {"strain_error", source.strain_error},
          {"wall_time", source.wall_time}};
}

output::ErrorSource source_of(const json& source) {
  return {source.at("name"),        source.at("compared"),     source.at("peak_stress"),
          source.at("peak_strain"), source.at("stress_error"), source.at("strain_error"),
          source.at("wall_time")};
}

}  // namespace

std::string remarks_text(const RunRemarks& remarks) {
  json sources = json::array();
  for (const output::ErrorSource& source : remarks.tolerated.sources) sources.push_back(json_of(source));
  const json all{{"notes", remarks.notes},
                 {"estimate_error", remarks.estimate_error},
                 {"tolerated", sources},
                 {"checkpoint_every", remarks.checkpoint_every}};
  return all.dump(-1, ' ', false, json::error_handler_t::replace);
}

RunRemarks parse_remarks(const std::string& text, const std::string& path) try {
  const json all = json::parse(text);
  RunRemarks remarks;
  all.at("notes").get_to(remarks.notes);
  all.at("estimate_error").get_to(remarks.estimate_error);
  for (const json& source : all.at("tolerated")) remarks.tolerated.sources.push_back(source_of(source));
  all.at("checkpoint_every").get_to(remarks.checkpoint_every);
  return remarks;
} catch (const json::exception& error) {
  throw Rejected(Exit::data, complaint(path, error.what(), "must be a checkpoint of mesopix simulate",
                                       "begin the run anew"));
}

}  // namespace app
