#include "apps/evidence_commands.hpp"

#include "apps/bench/bench_command.hpp"
#include "apps/reproduce/campaign.hpp"

namespace app {

MoreCommands evidence_commands() {
  return {[](CLI::App& program) { return std::make_unique<ReproduceCommand>(program); },
          [](CLI::App& program) { return std::make_unique<BenchCommand>(program); }};
}

}  // namespace app
