#include "apps/reproduce/figure.hpp"

namespace app::reproduce {

Trial square_trial(const Study& study, const std::string& scene, int seed,
                   const std::vector<Setting>& settings, bool keep_maps) {
  const std::string number = std::to_string(seed);
  Trial trial{scene, {{"generate.seed", number}, {"damage.seed", number}}, keep_maps};
  for (const auto* more : {&settings, &study.square})
    trial.settings.insert(trial.settings.end(), more->begin(), more->end());
  return trial;
}

}  // namespace app::reproduce
