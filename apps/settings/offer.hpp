/// Which settings a command takes, and what they are called there.
#pragma once

#include <string>
#include <vector>

#include "apps/settings/schema.hpp"

namespace app {

struct Offer {
  std::vector<std::string> own;     ///< groups whose settings stand in the help
  std::vector<std::string> others;  ///< groups whose settings are understood
  std::vector<std::string> hidden;  ///< keys of these groups that the command does not offer

  [[nodiscard]] bool is_own(const std::string& group) const;
  [[nodiscard]] bool has(const std::string& key) const;
};

[[nodiscard]] const Offer& offer_of_generate();
[[nodiscard]] const Offer& offer_of_convert();
[[nodiscard]] const Offer& offer_of_twin();
[[nodiscard]] const Offer& offer_of_simulate();
[[nodiscard]] const Offer& offer_of_calibrate();
[[nodiscard]] const Offer& offer_of_stiffness();

/// "velocity" or "itz-mode": the short name of a setting, without dashes before it.
[[nodiscard]] std::string short_option(const Group& group, const Field& field);

/// The names of options have -, the keys of scenes have _.
[[nodiscard]] std::string with_dashes(std::string text);
[[nodiscard]] std::string with_underscores(std::string text);

/// "phases.mortar.young" of the option "mortar.young" or "phases.mortar.young"; empty for other options.
[[nodiscard]] std::string phase_key(const std::string& option);

/// Key of a setting by one of its names: the key itself, the short name of one of the own groups, or
/// PHASE.PROPERTY; - and _ are the same in them.
/// @throws Rejected (Exit::usage) for a name that nothing has, with "did you mean", and for a setting that is
/// not offered.
[[nodiscard]] std::string key_named(const Offer& offer, const std::string& name);

}  // namespace app
