#include "apps/text/strain_text.hpp"

#include <fmt/format.h>

namespace app {

std::string strain_text(double strain) {
  return strain < 0.01 ? fmt::format("{:.4g}e-6", 1e6 * strain) : fmt::format("{:.4g} %", 100 * strain);
}

}  // namespace app
