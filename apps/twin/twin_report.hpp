/// The page about an original and its twins.
#pragma once

#include <string>
#include <vector>

#include "apps/twin/twinning.hpp"

namespace app {

/// One HTML page that needs no network.   @param notes  of the conversion and of the twins.
[[nodiscard]] std::string twin_html(const TwinTask& task, const std::vector<TwinRecord>& twins,
                                    const specimen::Misfit& misfit, const std::vector<std::string>& notes);

}  // namespace app
