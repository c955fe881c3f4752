#include "specimen/picture/preview.hpp"

#include <algorithm>
#include <array>

namespace specimen {
namespace {

constexpr std::array<Rgb, 4> standard = {{
    {255, 255, 255},  // void: white
    {112, 128, 150},  // aggregate: blue-grey
    {226, 205, 160},  // mortar: sand
    {196, 84, 0},     // ITZ: dark orange
}};

/// For the user's own phases. Source: Okabe and Ito (2008), less the two oranges, which are near the ITZ, and
/// black.
constexpr std::array<Rgb, 5> others = {{
    {0, 114, 178},
    {0, 158, 115},
    {204, 121, 167},
    {240, 228, 66},
    {86, 180, 233},
}};

std::uint8_t scaled(std::uint8_t channel, int sixteenths) {
  return static_cast<std::uint8_t>(channel * sixteenths / 16);
}

}  // namespace

Rgb phase_colour(std::uint8_t label) {
  if (label < standard.size()) return standard[label];
  const std::size_t index = label - standard.size();
  const Rgb base = others[index % others.size()];
  // Each further round is darker, so that more than five such phases still differ; after eight it starts
  // anew.
  const int brightness = 16 - 2 * static_cast<int>(index / others.size() % 8);
  return {scaled(base.r, brightness), scaled(base.g, brightness), scaled(base.b, brightness)};
}

Raster<Rgb> preview(const LabelledMask& mask) {
  Raster<Rgb> picture(mask.labels.rows, mask.labels.cols);
  std::transform(mask.labels.data.begin(), mask.labels.data.end(), picture.data.begin(), phase_colour);
  return picture;
}

}  // namespace specimen
