/// What one set of parameters gave.
#pragma once

#include <vector>

#include "apps/calibrate/calibration_target.hpp"

namespace app {

struct Evaluation {
  std::vector<double> factors;  ///< one a parameter
  double misfit = 0;            ///< [-], see misfit()
  Peak peak;                    ///< mean of the seeds; 0 where a run was of no use
  Figures figures;              ///< what the misfit compares; empty where a run was of no use
  bool coarse = false;          ///< of the search for the peak that goes before a fit to a curve
};

}  // namespace app
