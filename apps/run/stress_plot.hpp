/// The stress field of a run, from one of its frames.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "apps/drawing/drawing.hpp"
#include "apps/drawing/stress_drawing.hpp"
#include "apps/run/run_location.hpp"

namespace app {

/// "-5:5 MPa", "0 Pa : 800 kPa": two pressures of which the second is larger; a unit at the end is for both.
/// @return ends [MPa].   @throws Rejected (Exit::usage).
[[nodiscard]] output::ColourScale read_range(const std::string& text);

struct StressPlot {
  output::Drawing drawing;
  std::string words;  ///< which frame it shows: "p_000012.hdf, at 118 microstrain, 82.1 % of the peak strain"
};

/// Stress in the frame whose strain lies nearest to the one wanted, the earlier of two.
/// @param folder  of the run.   @param range  of the colours; none = from the values.
/// @param text  size of the words over the usual one.
/// @throws Rejected (Exit::data) when there are no frames, or none of this run, and mpm::FileError.
[[nodiscard]] StressPlot stress_plot(const ReadRun& run, const std::filesystem::path& folder, double strain,
                                     output::StressComponent component,
                                     const std::optional<output::ColourScale>& range, double text = 1);

}  // namespace app
