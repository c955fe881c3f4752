/// Pictures of damage at a strain, alone and with all that a reader needs beside them.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "apps/drawing/drawing.hpp"
#include "apps/drawing/picture_parts.hpp"
#include "libmpm/scene/result.hpp"
#include "specimen/body/mask.hpp"
#include "specimen/picture/picture.hpp"

namespace output {

/// Where pictures are taken [% of the strain at the largest stress].
inline constexpr std::array stage_percents{25, 50, 75, 100, 125, 150};

struct DamageStage {
  int percent = 0;           ///< of the strain at the largest stress
  double strain = 0;         ///< of the platens [-]
  std::int64_t tension = 0;  ///< pixels whose point had failed in tension by then
  std::int64_t shear = 0;    ///< the same in shear; ones crushed after cracking count in both
};

struct DamageStages {
  std::vector<DamageStage> drawn;  ///< those that the run reached
  std::vector<int> missing;        ///< those that it did not [%]
  double reached = 0;              ///< largest strain over that at the largest stress [-]
  bool of_peak = false;            ///< the largest stress is a peak
  const char* of = "";             ///< reference_strain()
};

/// Stages of a run; none are drawn where no stress rose above 0.
[[nodiscard]] DamageStages damage_stages(const mpm::Result& result);

/// One sentence about the stages that are missing; empty when none is.
[[nodiscard]] std::string missing_note(const DamageStages& stages);

/// "damage_025.png", "damage_025_colour.png".
[[nodiscard]] std::string picture_name(int percent, bool colour);

/// What each phase and each failure looks like.
struct Palette {
  std::array<specimen::Rgb, 256> phases{};  ///< by label
  specimen::Rgb tension;
  specimen::Rgb shear;
};

/// As in the paper: white aggregate, light grey mortar, dark grey shear failures, black tension failures; the
/// ITZ a little darker than the mortar, voids middle grey.
[[nodiscard]] Palette grey_palette();

/// Phases in pale shades of the colours of the preview; tension failures dark blue, shear failures vermilion,
/// which differ in hue and in lightness for every kind of colour vision.
[[nodiscard]] Palette colour_palette();

/// Failure of a pixel at a platen strain, as it looked then. A point that cracked and was crushed later has
/// failed in shear from its crushing on.
[[nodiscard]] mpm::FailureMode failure_at(const mpm::Result& result, Eigen::Index pixel, double strain);

/// Damage at a platen strain [-], one pixel a pixel, row 0 on top as in the mask.
/// @pre the maps of the result have the shape of the mask, or are empty: nothing can fail.
[[nodiscard]] specimen::Raster<specimen::Rgb> damage_picture(const specimen::LabelledMask& mask,
                                                             const mpm::Result& result, double strain,
                                                             const Palette& palette);

/// The phases that are in a mask.
[[nodiscard]] std::vector<LegendEntry> phases_in(const specimen::LabelledMask& mask,
                                                 const std::function<specimen::Rgb(std::uint8_t)>& colour_of);

/// Both kinds of failure, and the phases that are in a mask.
[[nodiscard]] std::vector<LegendEntry> damage_entries(const specimen::LabelledMask& mask,
                                                      const Palette& palette);

/// Damage at a platen strain [-], with a scale bar, a legend of what is in it, and a line of words below.
/// @param text  size of the words over the usual one.   @pre as damage_picture.
[[nodiscard]] Drawing damage_drawing(const specimen::LabelledMask& mask, const mpm::Result& result,
                                     double strain, const Palette& palette, const std::string& words,
                                     double text = 1);

}  // namespace output
