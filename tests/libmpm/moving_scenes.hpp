/// The problems with a known answer, as tests call them.
#pragma once

#include <cstdio>
#include <cstdlib>

#include "libmpm/problems/method.hpp"

namespace samples {

using namespace mpm::problems;

/// Whether tests print what they measured: with MESOPIX_FIGURES in the environment.
inline const bool figures = std::getenv("MESOPIX_FIGURES") != nullptr;

}  // namespace samples
