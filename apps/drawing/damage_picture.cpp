#include "apps/drawing/damage_picture.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <set>

#include "apps/drawing/picture_parts.hpp"
#include "apps/drawing/ticks.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/words.hpp"
#include "specimen/picture/picture.hpp"

namespace output {
namespace {

DamageStage stage_at(const mpm::Result& result, int percent) {
  DamageStage stage{percent, percent / 100.0 * result.peak_strain, 0, 0};
  const auto strain = static_cast<float>(stage.strain);
  for (Eigen::Index i = 0; i < result.failure_strain.size(); ++i) {
    const bool failed = result.failure_strain.data()[i] <= strain;
    const auto mode = static_cast<mpm::FailureMode>(result.failure_mode.data()[i]);
    stage.tension += failed && mode == mpm::FailureMode::tension;
    stage.shear += failed && mode == mpm::FailureMode::shear;
    stage.shear += result.crush_strain.size() > 0 && result.crush_strain.data()[i] <= strain;
  }
  return stage;
}

}  // namespace

DamageStages damage_stages(const mpm::Result& result) {
  DamageStages stages;
  stages.of_peak = mpm::peak_reached(result);
  stages.of = reference_strain(result);
  const bool was_loaded = std::isfinite(result.peak_strain) && result.peak_strain > 0;
  stages.reached = was_loaded ? largest_strain(result) / result.peak_strain : 0;
  for (const int percent : stage_percents)
    if (percent <= 100 * stages.reached * (1 + 1e-6))  // the last row may miss a round strain by round-off
      stages.drawn.push_back(stage_at(result, percent));
    else
      stages.missing.push_back(percent);
  return stages;
}

std::string missing_note(const DamageStages& stages) {
  if (stages.missing.empty()) return "";
  if (stages.reached == 0) return "No stress rose above 0, so no picture of damage was drawn.";
  std::vector<std::string> percents;
  for (const int percent : stages.missing) percents.push_back(fmt::format("{} %", percent));
  return fmt::format("The run ended at {:.0f} % of {}: there is no picture of damage at {}.",
                     std::floor(100 * stages.reached * (1 + 1e-6)), stages.of, app::listed(percents, "and"));
}

std::string picture_name(int percent, bool colour) {
  return fmt::format("damage_{:03}{}.png", percent, colour ? "_colour" : "");
}

namespace {

using specimen::Rgb;

Rgb towards_white(Rgb colour, double share) {
  const auto mix = [share](std::uint8_t channel) {
    return static_cast<std::uint8_t>(std::lround(channel + share * (255 - channel)));
  };
  return {mix(colour.r), mix(colour.g), mix(colour.b)};
}

Rgb grey(int level) {
  const auto channel = static_cast<std::uint8_t>(level);
  return {channel, channel, channel};
}

/// The maps hold strains in 32 bits; compared in 32 bits, a failure at the very strain has happened.
bool has_happened(float event_strain, double strain) { return event_strain <= static_cast<float>(strain); }

}  // namespace

Palette grey_palette() {
  Palette palette;
  for (std::size_t label = 0; label < palette.phases.size(); ++label)
    palette.phases[label] = grey(236 - static_cast<int>(label % 4) * 9);  // phases that the user named
  palette.phases[specimen::phase::void_] = grey(150);
  palette.phases[specimen::phase::aggregate] = grey(255);
  palette.phases[specimen::phase::mortar] = grey(216);
  palette.phases[specimen::phase::itz] = grey(192);
  palette.tension = grey(0);
  palette.shear = grey(88);
  return palette;
}

Palette colour_palette() {
  Palette palette;
  for (std::size_t label = 0; label < palette.phases.size(); ++label)
    palette.phases[label] = towards_white(specimen::phase_colour(static_cast<std::uint8_t>(label)), 0.5);
  palette.tension = {0x0b, 0x2c, 0x7a};
  palette.shear = {0xd8, 0x2b, 0x00};
  return palette;
}

mpm::FailureMode failure_at(const mpm::Result& result, Eigen::Index pixel, double strain) {
  if (result.failure_strain.size() == 0) return mpm::FailureMode::none;
  if (result.crush_strain.size() > 0 && has_happened(result.crush_strain.data()[pixel], strain))
    return mpm::FailureMode::shear;
  if (has_happened(result.failure_strain.data()[pixel], strain))
    return static_cast<mpm::FailureMode>(result.failure_mode.data()[pixel]);
  return mpm::FailureMode::none;
}

specimen::Raster<Rgb> damage_picture(const specimen::LabelledMask& mask, const mpm::Result& result,
                                     double strain, const Palette& palette) {
  assert(result.failure_strain.size() == 0 || (result.failure_strain.rows() == mask.labels.rows &&
                                               result.failure_strain.cols() == mask.labels.cols));
  specimen::Raster<Rgb> picture(mask.labels.rows, mask.labels.cols);
  for (std::size_t pixel = 0; pixel < picture.size(); ++pixel) {
    const mpm::FailureMode failure = failure_at(result, static_cast<Eigen::Index>(pixel), strain);
    picture.data[pixel] = failure == mpm::FailureMode::tension ? palette.tension
                          : failure == mpm::FailureMode::shear ? palette.shear
                                                               : palette.phases[mask.labels.data[pixel]];
  }
  return picture;
}

std::vector<LegendEntry> phases_in(const specimen::LabelledMask& mask,
                                   const std::function<Rgb(std::uint8_t)>& colour_of) {
  std::vector<LegendEntry> entries;
  for (const std::uint8_t label : std::set(mask.labels.data.begin(), mask.labels.data.end()))
    entries.push_back({colour_of(label), phase_word(mask.phases[label])});
  return entries;
}

std::vector<LegendEntry> damage_entries(const specimen::LabelledMask& mask, const Palette& palette) {
  std::vector<LegendEntry> entries =
      phases_in(mask, [&](std::uint8_t label) { return palette.phases[label]; });
  entries.insert(entries.begin(),
                 {{palette.tension, "failed in tension"}, {palette.shear, "failed in shear"}});
  return entries;
}

namespace {

/// Of what is in the picture.
std::vector<LegendEntry> legend_of(const specimen::LabelledMask& mask, const mpm::Result& result,
                                   double strain, const Palette& palette) {
  std::set<mpm::FailureMode> modes;
  for (Eigen::Index pixel = 0; pixel < result.failure_strain.size(); ++pixel)
    modes.insert(failure_at(result, pixel, strain));
  std::vector<LegendEntry> entries = damage_entries(mask, palette);
  if (modes.count(mpm::FailureMode::shear) == 0) entries.erase(entries.begin() + 1);
  if (modes.count(mpm::FailureMode::tension) == 0) entries.erase(entries.begin());
  return entries;
}

}  // namespace

Drawing damage_drawing(const specimen::LabelledMask& mask, const mpm::Result& result, double strain,
                       const Palette& palette, const std::string& words, double text) {
  Drawing drawing{picture_width, 0, words, {}, text};
  const int factor = crisp_factor(mask.labels.rows, mask.labels.cols);
  double y = add_picture(drawing, magnified(damage_picture(mask, result, strain, palette), factor)) +
             text_line * text;
  y = add_scale_bar(drawing, picture_width / mask.width(), y, words);
  y = add_legend(drawing, legend_of(mask, result, strain, palette), y + text_line * text + 6);
  drawing.height = y + 6;
  return drawing;
}

}  // namespace output
