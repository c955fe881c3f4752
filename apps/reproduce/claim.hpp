/// What the paper says, what a run found, and whether the two go together.
#pragma once

#include <string>
#include <vector>

namespace app::reproduce {

enum class Verdict {
  agrees,
  disagrees,
  depends,  ///< holds in some of the cases that were run, or with another value of a parameter
};

struct Claim {
  std::string id;        ///< "peaks-rise-with-m"
  std::string figure;    ///< of the paper: "12"
  std::string paper;     ///< in our words
  std::string measured;  ///< made from the numbers of the run
  Verdict verdict = Verdict::disagrees;
  std::string why;  ///< how the verdict follows from the numbers
};

[[nodiscard]] std::string word_of(Verdict verdict);  ///< "agrees", "disagrees", "depends"

/// Of a claim that was tested in several cases: holds in all, in none, in some.   @pre at least one case.
[[nodiscard]] Verdict verdict_of(const std::vector<bool>& holds);

/// Of a claim about a random thing: holds in at least 80 % of the cases, in at most 20 %, or between.
[[nodiscard]] Verdict verdict_of_share(double share);

}  // namespace app::reproduce
