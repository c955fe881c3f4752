// The section of the report that shows the damage.
#include <fmt/format.h>
#include <algorithm>

#include "apps/drawing/damage_picture.hpp"
#include "apps/drawing/deformed_picture.hpp"
#include "apps/drawing/picture_parts.hpp"
#include "apps/drawing/ticks.hpp"
#include "apps/report/report_data.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/report/report_sections.hpp"
#include "apps/report/run_words.hpp"
#include "apps/text/figures.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/words.hpp"

namespace output {
namespace {

/// One of the two looks of the pictures, which the reader chooses between without any script.
struct Look {
  const char* css_class;
  Palette palette;
};

std::string figure(const RunRecord& record, const DamageStage& stage, const std::vector<Look>& looks) {
  const std::string share = fmt::format("{} % of {}", stage.percent, reference_strain(record.result));
  std::string html = "<figure>\n";
  for (const Look& look : looks)
    html += image(damage_picture(record.specimen.mask, record.result, stage.strain, look.palette),
                  "Damage at " + share, look.css_class);
  const StrainUnit unit = strain_unit(record.result);
  return html + fmt::format(
                    "<figcaption><b>{}</b><br/>{} {}<br/>{} failed in tension, {} in shear"
                    "</figcaption>\n</figure>\n",
                    escape(share), rounded(unit.per_strain * stage.strain), unit.name, grouped(stage.tension),
                    grouped(stage.shear));
}

/// Where the points are at the end, for runs in which they move.
std::string end_figure(const RunRecord& record, const std::vector<Look>& looks) {
  const specimen::LabelledMask& mask = record.specimen.mask;
  const int fineness = file_magnification(mask.labels.rows, mask.labels.cols);
  std::string html = "<figure>\n";
  for (const Look& look : looks)
    html += image(deformed_picture(mask, record.result, look.palette, fineness), "The specimen at the end",
                  look.css_class);
  return html + fmt::format(
                    "<figcaption><b>At the end</b>, true to scale<br/>{} failed in tension, {} in shear"
                    "</figcaption>\n</figure>\n",
                    grouped(record.result.tension_failures), grouped(record.result.shear_failures));
}

/// Whether a run went on beyond the last stage drawn, and not as far as to the next.
bool ends_between(const DamageStages& stages) {
  return !stages.drawn.empty() && !stages.missing.empty() &&
         100 * stages.reached >= stages.drawn.back().percent + 1;
}

/// The damage at the end of such a run, in which points keep their place.
std::string last_figure(const RunRecord& record, const DamageStages& stages, const std::vector<Look>& looks) {
  const double strain = stages.reached * record.result.peak_strain;
  std::string html = "<figure>\n";
  for (const Look& look : looks)
    html += image(damage_picture(record.specimen.mask, record.result, strain, look.palette),
                  "Damage at the end", look.css_class);
  const StrainUnit unit = strain_unit(record.result);
  return html + fmt::format(
                    "<figcaption><b>At the end</b>, {:.0f} % of {}<br/>{} {}<br/>{} failed in tension, "
                    "{} in shear</figcaption>\n</figure>\n",
                    100 * stages.reached, stages.of, rounded(unit.per_strain * strain), unit.name,
                    grouped(record.result.tension_failures), grouped(record.result.shear_failures));
}

/// What the pictures do not show.
std::string remarks_on(const RunRecord& record, const DamageStages& stages) {
  std::string html;
  const std::string missing = missing_note(stages);
  if (!missing.empty()) html += paragraph(missing);
  if (!record.scene.extra_points.empty())
    html += paragraph(
        "Extra ITZ points have no pixel: the pictures and the counts below them do not include them.");
  if (record.result.crush_strain.size() > 0)
    html += paragraph(
        "A point that cracked and was crushed later is drawn as failed in shear and counted in both.");
  return html;
}

}  // namespace

std::string damage_section(const RunRecord& record) {
  const DamageStages stages = damage_stages(record.result);
  const bool shows_end = has_end(record.result);
  if (stages.drawn.empty() && !shows_end) return section("Damage", paragraph(missing_note(stages)));
  const std::vector<Look> looks{{"in-colour", colour_palette()}, {"in-grey", grey_palette()}};
  std::string html =
      "<input class=\"choice\" type=\"radio\" name=\"look\" id=\"in-colour\" checked=\"checked\"/>"
      "<label for=\"in-colour\">Colours</label>\n"
      "<input class=\"choice\" type=\"radio\" name=\"look\" id=\"in-grey\"/>"
      "<label for=\"in-grey\">Greys</label>\n";
  for (const Look& look : looks)
    html += legend(look.css_class, damage_entries(record.specimen.mask, look.palette));
  std::string figures;
  for (const DamageStage& stage : stages.drawn) figures += figure(record, stage, looks);
  if (shows_end)
    figures += end_figure(record, looks);
  else if (ends_between(stages))
    figures += last_figure(record, stages, looks);
  return section("Damage", html + pictures(figures) + remarks(remarks_on(record, stages)));
}

namespace {

constexpr const char* screen = R"html(<div class="screen"><canvas id="film-screen" tabindex="0" role="img"
aria-describedby="film-help" aria-label="Damage of the specimen at the chosen strain"></canvas></div>
<p class="controls"><button type="button" id="film-play">Play</button>
<input type="range" id="film-strain" min="0" max="1000" step="1" value="0" aria-label="Strain"/>
<output id="film-at"></output></p>
)html";

constexpr const char* controls = R"html(<p class="readout" id="film-counts"></p>
<p class="readout" id="film-readout" aria-live="polite"></p>
<p class="controls"><label for="film-look">Look</label>
<select id="film-look"><option value="colour">Colours</option><option value="grey">Greys</option></select>
<button type="button" id="film-whole">Whole specimen</button></p>
<p class="controls"><button type="button" id="film-png">Save as PNG</button>
<button type="button" id="film-gif">Save as animated GIF</button></p>
<p class="remarks" id="film-help">Point at a pixel to see its phase, its strength and when it failed. Zoom with the wheel or
+ and −, move by dragging or with the arrow keys, show everything with 0, play with the space bar. Click on a curve to go
to that strain.</p>
)html";

}  // namespace

/// Hidden until the script of the page has something to show in it.
std::string film_section(const RunRecord& record) {
  if (!has_film(record)) return "";
  std::string beside = "<p class=\"legend\" id=\"film-legend\"></p>\n" + std::string(controls);
  if (record.result.end_x.size() > 0)
    beside += paragraph("The film shows each point at its initial position.");
  return "<section id=\"film\" hidden=\"hidden\">\n<h2>Film of the damage</h2>\n" +
         side_by_side("lead", screen, beside) + "</section>\n";
}

}  // namespace output
