#include "apps/drawing/damage_drawing.hpp"

#include <set>

#include "apps/drawing/picture_parts.hpp"
#include "apps/drawing/picture_scale.hpp"
#include "apps/report/run_words.hpp"

namespace output {
namespace {

std::vector<LegendEntry> legend_of(const specimen::LabelledMask& mask, const mpm::Result& result,
                                   double strain, const Palette& palette) {
  std::set<mpm::FailureMode> modes;
  for (Eigen::Index pixel = 0; pixel < result.failure_strain.size(); ++pixel)
    modes.insert(failure_at(result, pixel, strain));
  std::vector<LegendEntry> entries;
  if (modes.count(mpm::FailureMode::tension) > 0) entries.push_back({palette.tension, "failed in tension"});
  if (modes.count(mpm::FailureMode::shear) > 0) entries.push_back({palette.shear, "failed in shear"});
  const std::set<std::uint8_t> labels(mask.labels.data.begin(), mask.labels.data.end());
  for (const std::uint8_t label : labels)
    entries.push_back({palette.phases[label], phase_word(mask.phases[label])});
  return entries;
}

}  // namespace

Drawing damage_drawing(const specimen::LabelledMask& mask, const mpm::Result& result, double strain,
                       const Palette& palette, const std::string& words) {
  Drawing drawing{picture_width, 0, words, {}};
  const int factor = crisp_factor(mask.labels.rows, mask.labels.cols);
  double y =
      add_picture(drawing, magnified(damage_picture(mask, result, strain, palette), factor)) + text_line;
  add_scale_bar(drawing, picture_width / mask.width(), y, words);
  y = add_legend(drawing, legend_of(mask, result, strain, palette), y + text_line + 6);
  drawing.height = y + 6;
  return drawing;
}

}  // namespace output
