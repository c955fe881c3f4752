/// An effort that takes a moment: specimens of 24 mm with pixels of 1 mm, two coarse aggregates, and no fine
/// pixels.
#pragma once

#include "apps/reproduce/figure.hpp"

namespace test {

inline app::reproduce::Effort tiny_effort() {
  return {2,
          1,
          {{"generate.width", "24 mm"},
           {"generate.height", "24 mm"},
           {"generate.pixel_size", "1 mm"},
           {"generate.d_min", "4 mm"},
           {"generate.d_max", "8 mm"}},
          {{"generate.pixel_size", "2.5 mm"}},
          {2, 1}};
}

}  // namespace test
