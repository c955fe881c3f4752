/// What there is to say of a ledger of energies that does not close.
#pragma once

#include <string>

#include "libmpm/scene/result.hpp"
#include "libmpm/scene/scene.hpp"

namespace app {

/// By how much it is off, why, and what helps; empty for an error below 1 % of the energy put in, or below 10
/// % where points move.
[[nodiscard]] std::string energy_note(const mpm::Result& result, const mpm::Scene& scene);

}  // namespace app
