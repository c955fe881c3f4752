#include "specimen/body/mask.hpp"

#include <algorithm>

#include "specimen/body/error.hpp"

namespace specimen {

std::vector<std::string> standard_phases() { return {"void", "aggregate", "mortar", "itz"}; }

std::uint8_t label_of(std::vector<std::string>& phases, std::string_view name) {
  constexpr std::size_t most_phases = 256;
  const auto found = std::find(phases.begin(), phases.end(), name);
  if (found != phases.end()) return static_cast<std::uint8_t>(found - phases.begin());
  if (name.empty()) throw Error("phase", "an empty name", "must have at least one letter");
  if (phases.size() >= most_phases) {
    throw Error("phase", std::string(name), "at most 256 phases can be told apart",
                "give several phases one name");
  }
  phases.emplace_back(name);
  return static_cast<std::uint8_t>(phases.size() - 1);
}

std::vector<std::int64_t> count_labels(const LabelledMask& mask) {
  std::vector<std::int64_t> counts(256, 0);
  for (const std::uint8_t label : mask.labels.data) ++counts[label];
  const auto last = std::find_if(counts.rbegin(), counts.rend(), [](std::int64_t n) { return n > 0; });
  const auto used = static_cast<std::size_t>(counts.rend() - last);
  if (used > mask.phases.size()) {
    throw Error("mask", "label " + std::to_string(used - 1),
                "has no name: there are " + std::to_string(mask.phases.size()) + " phases");
  }
  counts.resize(mask.phases.size());
  return counts;
}

}  // namespace specimen
