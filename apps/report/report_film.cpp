#include "apps/report/film_data.hpp"
#include "apps/text/html.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/report/report_sections.hpp"

namespace output {
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
<p class="remarks" id="film-help">Point at a pixel to see what it is and when it failed. The wheel or + and − zoom,
dragging or the arrow keys move the picture, 0 shows all of it, the space bar plays. A click on a curve goes to that
strain.</p>
)html";

}  // namespace

/// Hidden until the script of the page has something to show in it.
std::string film_section(const RunRecord& record) {
  if (!has_film(record)) return "";
  std::string beside = "<p class=\"legend\" id=\"film-legend\"></p>\n" + std::string(controls);
  if (record.result.end_x.size() > 0)
    beside += paragraph("The film shows each point at its place in the specimen before it moved.");
  return "<section id=\"film\" hidden=\"hidden\">\n<h2>The film of the damage</h2>\n" +
         side_by_side("lead", screen, beside) + "</section>\n";
}

}  // namespace output
