#include "apps/manual/completions.hpp"

namespace manual {

std::vector<File> completions(const Command& program) {
  return {{"mesopix.bash", bash_completion(program)},
          {"_mesopix", zsh_completion(program)},
          {"mesopix.fish", fish_completion(program)}};
}

}  // namespace manual
