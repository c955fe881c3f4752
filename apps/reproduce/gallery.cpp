#include "apps/reproduce/gallery.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "apps/drawing/damage_picture.hpp"
#include "apps/drawing/damage_stages.hpp"
#include "apps/text/html.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/report/run_words.hpp"
#include "apps/text/text.hpp"
#include "apps/reproduce/words.hpp"

namespace app::reproduce {

std::string damage_legend(const specimen::LabelledMask& mask) {
  const output::Palette palette = output::colour_palette();
  std::string html =
      output::swatch(palette.tension, "failed in tension") + output::swatch(palette.shear, "failed in shear");
  const auto& labels = mask.labels.data;
  for (std::size_t label = 0; label < mask.phases.size(); ++label)
    if (std::find(labels.begin(), labels.end(), static_cast<std::uint8_t>(label)) != labels.end())
      html += output::swatch(palette.phases[label], output::phase_word(mask.phases[label]));
  return "<p class=\"legend\">\n" + html + "</p>\n";
}

std::string damage_pictures(const Outcome& outcome, const std::vector<int>& percents,
                            const std::string& caption) {
  std::string html;
  for (const output::DamageStage& stage : output::damage_stages(outcome.result).drawn) {
    if (std::find(percents.begin(), percents.end(), stage.percent) == percents.end()) continue;
    const std::string share = fmt::format("{} % of the peak strain", stage.percent);
    html +=
        "<figure>\n" +
        output::image(output::damage_picture(outcome.specimen.mask, outcome.result, stage.strain,
                                             output::colour_palette()),
                      "Damage at " + share, "") +
        fmt::format(
            "<figcaption><b>{}</b>{}<br/>{}<br/>{} failed in tension, {} in shear</figcaption>\n</figure>\n",
            share, output::escape(caption), microstrain(stage.strain), output::grouped(stage.tension),
            output::grouped(stage.shear));
  }
  return html;
}

std::string gallery(const std::string& pictures_html) {
  return "<div class=\"pictures\">\n" + pictures_html + "</div>\n";
}

}  // namespace app::reproduce
