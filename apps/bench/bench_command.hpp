/// What the benches found, as JSON: a list with an object for each line of their tables.
/// mesopix bench: how exact the program is for its time, measured on the spot.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "apps/bench/error_study.hpp"
#include "apps/bench/feature_study.hpp"
#include "apps/bench/stability.hpp"
#include "apps/command/command.hpp"

namespace app::bench {

[[nodiscard]] nlohmann::ordered_json error_json(const std::vector<ProblemResult>& results);
[[nodiscard]] nlohmann::ordered_json stability_json(const StabilityOutcome& outcome);
[[nodiscard]] nlohmann::ordered_json feature_json(const std::vector<FeatureCost>& costs);

}  // namespace app::bench

namespace app {

class BenchCommand : public Command {
 public:
  explicit BenchCommand(CLI::App& program);
  Exit run(Console& console) override;

 private:
  Exit run_error(Console& console) const;
  Exit run_stability(Console& console) const;
  Exit run_features(Console& console) const;

  std::string what_;
  std::vector<std::string> problems_;
  std::vector<std::string> cases_;
  std::string output_;
  bool overwrite_ = false;
  bool json_ = false;
  bool quiet_ = false;
};

}  // namespace app
