#include "apps/run/stress_plot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/drawing/ticks.hpp"
#include "apps/run/frame_folder.hpp"
#include "apps/settings/assignment.hpp"
#include "apps/system/hdf5_files.hpp"

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr const char* range_example = "must be two pressures, like \"-5:5 MPa\"";

/// Behind the number at the beginning: "MPa" of "5 MPa".
std::string unit_of(const std::string& text) {
  const std::size_t unit = text.find_last_of("0123456789. ", text.find_first_of("PkMGN"));
  return unit == std::string::npos ? "" : text.substr(unit + 1);
}

fs::path nearest_frame(const std::vector<fs::path>& frames, double strain) {
  double least = std::numeric_limits<double>::infinity();
  fs::path nearest;
  for (const fs::path& frame : frames) {
    const double distance = std::abs(read_frame_heading(frame.string()).strain - strain);
    if (distance >= least) continue;
    least = distance;
    nearest = frame;
  }
  return nearest;
}

/// Frames that were copied into the folder of another run would be shown in wrong places.
void check_belongs(const mpm::Frame& frame, const fs::path& file, const ReadRun& run) {
  const std::size_t ids = run.specimen.mask.labels.size() + run.scene.extra_points.size();
  const auto rows = static_cast<std::int64_t>(run.result.history.size());
  const bool is_named_otherwise = !frame.run.empty() && !run.run.empty() && frame.run != run.run;
  const bool fits = !is_named_otherwise && (frame.points.empty() || frame.points.back().id < ids) &&
                    frame.row >= 0 && frame.row < rows;
  if (!fits)
    throw Rejected(Exit::data, file.string(), "is no frame of this run", "",
                   "take the folder as one run has written it");
  const bool are_numbers =
      std::all_of(frame.points.begin(), frame.points.end(), [](const mpm::FramePoint& p) {
        return std::isfinite(p.sxx) && std::isfinite(p.syy) && std::isfinite(p.szz) && std::isfinite(p.sxy);
      });
  if (!are_numbers)
    throw Rejected(Exit::data, file.string(), "holds a stress that is no number", "",
                   "run the simulation again with a smaller solver.cfl");
}

}  // namespace

output::ColourScale read_range(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos) throw Rejected(Exit::usage, "--range", text, range_example);
  const std::string high = text.substr(colon + 1);
  std::string low = text.substr(0, colon);
  if (unit_of(low).empty()) low += " " + unit_of(high);
  const QuantityCodec pressure{Dimension::pressure};
  const output::ColourScale range{1e-6 * read_option("range", low, pressure),
                                  1e-6 * read_option("range", high, pressure)};
  if (!(range.low < range.high))
    throw Rejected(Exit::usage, "--range", text, "the second must be larger than the first");
  return range;
}

StressPlot stress_plot(const ReadRun& run, const fs::path& folder, double strain,
                       output::StressComponent component, const std::optional<output::ColourScale>& range,
                       double text) {
  const std::vector<fs::path> frames = frames_of(folder);
  if (frames.empty())
    throw Rejected(Exit::data, "RUN", folder.string(), "has no frames, which hold the stress",
                   "run it again with --frames 40");
  const fs::path file = nearest_frame(frames, strain);
  const mpm::Frame frame = read_frame(file.string());
  check_belongs(frame, file, run);
  const std::string words = output::strain_words(run.result, frame.strain, 1);
  const bool moved = run.result.history[static_cast<std::size_t>(frame.row)].moving_points > 0;
  const bool loaded = run.scene.loading.direction != mpm::Direction::none;
  return {output::stress_drawing(run.specimen.mask, frame, {component, loaded, moved, range, words, text}),
          file.filename().string() + ", at " + words};
}

}  // namespace app
