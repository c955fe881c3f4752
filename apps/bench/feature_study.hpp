/// What each feature costs that a scene can leave out, and that leaving it out changes nothing.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "apps/system/job_pool.hpp"
#include "libmpm/scene/scene.hpp"
#include "libmpm/solver/plan.hpp"

namespace app::bench {

/// A scene that does without a feature, and the plan that has it all the same.
struct FeatureCase {
  std::string feature;     ///< "shear test"
  std::string kinematics;  ///< "small strain" or "moving points"
  std::string scene;       ///< what makes the scene do without it: "no phase can fail in shear"
  std::function<mpm::Scene()> make;
  std::function<void(mpm::Plan&)> add;
  double tolerance = 0;  ///< largest difference of the stress over its peak that is rounding [-]
};

struct FeatureCost {
  std::string feature, kinematics, scene;
  double time_without = 0, time_with = 0;  ///< of a point and step: medians [s]
  double difference = 0;                   ///< largest of the stress in the history, over its peak [-]
  bool same_failures = false;              ///< every point failed alike, at the same strain
  double tolerance = 0;                    ///< [-]

  [[nodiscard]] bool agrees() const { return same_failures && difference <= tolerance; }
};

/// @param pixels  along an edge of the square of concrete, a multiple of 4.
[[nodiscard]] std::vector<FeatureCase> all_features(int pixels = 300);

/// Run both plans of each in turn, `repeats` times.   @return those done before the watch said no.
[[nodiscard]] std::vector<FeatureCost> measure_features(const std::vector<FeatureCase>& cases, int repeats,
                                                        const Watch& watch);

/// A table for the console; as a page; with a line a feature.
[[nodiscard]] std::string feature_text(const std::vector<FeatureCost>& costs);
[[nodiscard]] std::string feature_html(const std::vector<FeatureCost>& costs);
[[nodiscard]] std::string feature_csv(const std::vector<FeatureCost>& costs);

}  // namespace app::bench
