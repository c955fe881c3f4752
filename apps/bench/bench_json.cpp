#include "apps/bench/bench_json.hpp"

#include <nlohmann/json.hpp>

namespace app::bench {
namespace {

using Json = nlohmann::ordered_json;

Json sample_json(const ProblemResult& result, const MethodResult& method, const Sample& sample) {
  return {{"problem", result.problem.name},
          {"method", method.method->name},
          {"refined", method.method->refined},
          {"size", sample.size},
          {"unit", method.method->unit},
          {"error", sample.error},
          {"wall_time_s", sample.wall_time},
          {"point_updates", sample.point_updates},
          {"order", method.order},
          {"front", sample.in_front},
          {"trouble", sample.trouble}};
}

}  // namespace

Json error_json(const std::vector<ProblemResult>& results) {
  Json samples = Json::array();
  for (const ProblemResult& result : results)
    for (const MethodResult& method : result.methods)
      for (const Sample& sample : method.samples) samples.push_back(sample_json(result, method, sample));
  return samples;
}

Json stability_json(const StabilityOutcome& outcome) {
  Json cases = Json::array();
  for (const StabilityRow& row : outcome.rows)
    cases.push_back({{"name", row.name},
                     {"group", row.group},
                     {"holds", row.done ? Json(row.finding.holds) : Json(nullptr)},
                     {"seconds", row.seconds},
                     {"must", row.must},
                     {"seen", row.finding.seen}});
  return cases;
}

Json feature_json(const std::vector<FeatureCost>& costs) {
  Json features = Json::array();
  for (const FeatureCost& cost : costs)
    features.push_back({{"feature", cost.feature},
                        {"kinematics", cost.kinematics},
                        {"scene", cost.scene},
                        {"without_s", cost.time_without},
                        {"with_s", cost.time_with},
                        {"difference", cost.difference},
                        {"same_failures", cost.same_failures},
                        {"agrees", cost.agrees()}});
  return features;
}

}  // namespace app::bench
