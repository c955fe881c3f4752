#include "apps/evidence_commands.hpp"

#ifdef MESOPIX_EVIDENCE
#include "apps/bench/bench_command.hpp"
#include "apps/reproduce/campaign.hpp"
#endif

namespace app {

MoreCommands evidence_commands() {
#ifdef MESOPIX_EVIDENCE
  return {reproduce_command, bench_command};
#else
  return {};
#endif
}

}  // namespace app
