#include "apps/drawing/damage_picture.hpp"

#include <cassert>
#include <cmath>

#include "specimen/picture/preview.hpp"

namespace output {
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

}  // namespace output
