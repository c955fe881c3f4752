#include "apps/output/damage_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "apps/output/picture_scale.hpp"
#include "apps/output/run_words.hpp"
#include "apps/output/text.hpp"

namespace output {
namespace {

constexpr double picture_width = 480;  // [px]
constexpr double line_height = 22;
constexpr double letters = 8;  // width of one, generously

/// So many pixels that viewers which smooth pictures leave sharp edges.
specimen::Raster<specimen::Rgb> crisp(const specimen::Raster<specimen::Rgb>& picture) {
  return magnified(picture, std::max(1, static_cast<int>(std::ceil(2 * picture_width / picture.cols))));
}

/// Largest length of 1, 2 or 5 times a power of ten [m] that is at most `most`.
double round_length(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0})
    if (step * power <= most) return step * power;
  return power;
}

struct Entry {
  specimen::Rgb colour;
  std::string name;
};

std::vector<Entry> legend_of(const specimen::LabelledMask& mask, const mpm::Result& result, double strain,
                             const Palette& palette) {
  std::set<mpm::FailureMode> modes;
  for (Eigen::Index pixel = 0; pixel < result.failure_strain.size(); ++pixel)
    modes.insert(failure_at(result, pixel, strain));
  std::vector<Entry> entries;
  if (modes.count(mpm::FailureMode::tension) > 0) entries.push_back({palette.tension, "failed in tension"});
  if (modes.count(mpm::FailureMode::shear) > 0) entries.push_back({palette.shear, "failed in shear"});
  const std::set<std::uint8_t> labels(mask.labels.data.begin(), mask.labels.data.end());
  for (const std::uint8_t label : labels)
    entries.push_back({palette.phases[label], phase_word(mask.phases[label])});
  return entries;
}

void add_scale_bar(Drawing& drawing, double px_per_metre, double y) {
  const double length = round_length(0.25 * picture_width / px_per_metre);
  drawing.shapes.push_back(Stroke{{{0, y}, {length * px_per_metre, y}}, Ink::text, 3});
  drawing.shapes.push_back(Words{{length * px_per_metre + 8, y + 5}, trimmed(1e3 * length) + " mm", 14});
}

}  // namespace

Drawing damage_drawing(const specimen::LabelledMask& mask, const mpm::Result& result, double strain,
                       const Palette& palette, const std::string& words) {
  const double px_per_metre = picture_width / mask.width();
  const double height = mask.height() * px_per_metre;
  Drawing drawing{picture_width, 0, words, {}};
  drawing.shapes.push_back(
      Pixels{{0, 0}, picture_width, height, crisp(damage_picture(mask, result, strain, palette))});
  drawing.shapes.push_back(
      Stroke{{{0, 0}, {picture_width, 0}, {picture_width, height}, {0, height}, {0, 0}}, Ink::axis, 0.75});
  double y = height + line_height;
  add_scale_bar(drawing, px_per_metre, y);
  drawing.shapes.push_back(Words{{picture_width, y + 5}, words, 14, Anchor::end});
  y += line_height + 6;
  double x = 0;
  for (const Entry& entry : legend_of(mask, result, strain, palette)) {
    const double width = 22 + letters * static_cast<double>(entry.name.size()) + 12;
    if (x > 0 && x + width > picture_width) {
      x = 0;
      y += line_height;
    }
    drawing.shapes.push_back(Block{{x, y - 11}, 14, 14, entry.colour, true});
    drawing.shapes.push_back(Words{{x + 22, y + 1}, entry.name, 14});
    x += width;
  }
  drawing.height = y + 6;
  return drawing;
}

}  // namespace output
