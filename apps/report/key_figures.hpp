/// Figures that follow from a result and its scene.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "apps/run/run_folder.hpp"

namespace output {

/// Stress over strain where the stress first reaches 40 % of its peak [Pa]; NaN without a peak.
[[nodiscard]] double secant_modulus(const mpm::Result& result);

/// Area share of each phase that the mask holds [-], in the order of labels.
[[nodiscard]] std::vector<std::pair<std::string, double>> phase_shares(const specimen::LabelledMask& mask);

/// Notes of the record, and the one about damage pictures that are missing.
[[nodiscard]] std::vector<std::string> all_notes(const RunRecord& record);

/// Version of mesopix.
[[nodiscard]] std::string version();

}  // namespace output
