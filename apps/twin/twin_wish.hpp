/// What twins are asked for, as texts, and the task that it makes of an original.
#pragma once

#include <string>

#include "apps/settings/offer.hpp"
#include "apps/twin/twinning.hpp"

namespace app {

/// Options of twin; empty = not given.
struct TwinWish {
  std::string count = "10";
  std::string seed = "1";
  std::string width;
  std::string height;
  std::string pixel_size;
  std::string gap = "auto";
  std::string border = "auto";
};

/// @throws Rejected (Exit::usage).
[[nodiscard]] specimen::TwinOptions twin_options(const TwinWish& wish);

/// @param input  path of the original: twins are called after its stem.   @param itz  of the twins.
/// @throws Rejected for a wish that cannot be read and for an original that tells of no inclusions;
/// specimen::Error.
[[nodiscard]] TwinTask make_twin_task(const TwinWish& wish, const std::string& input,
                                      const Settings& settings, const specimen::ItzOptions& itz,
                                      specimen::Specimen original);

}  // namespace app
