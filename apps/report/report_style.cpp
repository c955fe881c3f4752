#include "apps/report/report_parts.hpp"

#include <fmt/format.h>

#include "apps/drawing/colours.hpp"

namespace output {
namespace {

constexpr const char* page_rules = R"css(
:root { color-scheme: light dark; --paper: #ffffff; --panel: #f5f6f8; --rule: #dfe3e7; }
@media screen and (prefers-color-scheme: dark) {
  :root { --paper: #14181c; --panel: #1d2228; --rule: #333a42; }
}
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body { margin: 0; background: var(--paper); color: var(--text);
  font: 16px/1.55 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", "DejaVu Sans", sans-serif; }
main { max-width: 1040px; margin: 0 auto; padding: 40px 20px 56px; }
h1 { margin: 0 0 6px; font-size: 28px; line-height: 1.25; font-weight: 600; overflow-wrap: anywhere; }
h2 { margin: 0 0 16px; font-size: 19px; line-height: 1.3; font-weight: 600; }
h3 { margin: 0 0 6px; font-size: 16px; font-weight: 600; }
p { margin: 0 0 12px; max-width: 44em; }
.setting { color: var(--muted); margin: 0; max-width: none; }
section { margin-top: 44px; padding-top: 20px; border-top: 1px solid var(--rule); }
.notes { margin: 0; padding-left: 1.2em; }
.notes li { overflow-wrap: anywhere; }
figure { margin: 0; }
figcaption { color: var(--muted); font-size: 14px; line-height: 1.45; margin-top: 6px; max-width: 44em; }
.pair { display: grid; gap: 28px 40px; }
.pair > div { min-width: 0; }
@media (min-width: 900px) { .pair { grid-template-columns: 1fr 1fr; } .pair.lead { grid-template-columns: 8fr 5fr; } .pair.fit { grid-template-columns: max-content minmax(0, 30em); } }
svg { display: block; width: 100%; height: auto; font-family: inherit; font-variant-numeric: tabular-nums; }
text { paint-order: stroke; stroke: var(--paper); stroke-width: 3px; stroke-linejoin: round; }
polyline { fill: none; stroke-linejoin: round; }
.wide { max-width: 640px; }
.narrow { display: none; max-width: 440px; }
@media screen and (max-width: 599px) { .wide { display: none; } .narrow { display: block; } }
table { border-collapse: collapse; width: 100%; font-size: 15px; font-variant-numeric: tabular-nums; }
th, td { padding: 6px 0; border-bottom: 1px solid var(--rule); vertical-align: baseline; text-align: right; }
th[scope=row], th[scope=col]:first-child { text-align: left; padding-right: 16px; }
th { font-weight: 400; }
thead th { color: var(--muted); font-size: 14px; }
.numbers td, .numbers thead th + th { padding-left: 18px; white-space: nowrap; }
.facts td { white-space: nowrap; font-weight: 600; }
.facts td.unit { text-align: left; padding-left: 8px; font-weight: 400; color: var(--muted); width: 1%; }
.facts .words th { white-space: nowrap; }
.facts .words td { white-space: normal; text-align: left; overflow-wrap: anywhere; font-weight: 400; }
.scroll { overflow-x: auto; }
.claims th, .claims td { text-align: left; vertical-align: top; padding: 8px 20px 8px 0; }
.claims td { min-width: 11em; }
.claims .why { color: var(--muted); }
.claims .verdict { min-width: 0; padding-right: 0; font-weight: 600; white-space: nowrap; }
.verdict.agrees { color: var(--third); }
.verdict.disagrees { color: var(--second); }
.verdict.depends { color: var(--first); }
.pair + .scroll, .pair + .pair, .pair + p, .scroll + p, .chart + .scroll, .pictures + h3, .remarks + .legend { margin-top: 28px; }
.legend.below { margin: 10px 0 0; }
img { display: block; max-width: 100%; height: auto; border: 1px solid var(--rule); background: #fff; }
img.pixels { image-rendering: pixelated; }
.pictures { display: grid; gap: 28px 36px; grid-template-columns: repeat(auto-fill, minmax(min(100%, 300px), 1fr)); }
.remarks { margin-top: 24px; color: var(--muted); font-size: 14px; }
.remarks p { margin: 0 0 4px; max-width: none; }
.pictures b { color: var(--text); font-weight: 600; }
.legend { display: flex; flex-wrap: wrap; gap: 4px 20px; margin: 0 0 16px; font-size: 14px; }
.swatch { white-space: nowrap; }
.swatch i { display: inline-block; width: 13px; height: 13px; margin-right: 7px; vertical-align: -1px;
  border: 1px solid var(--axis); }
.choice { position: absolute; opacity: 0; }
.choice + label { display: inline-block; margin: 0 6px 14px 0; padding: 3px 14px; font-size: 14px; cursor: pointer;
  border: 1px solid var(--rule); border-radius: 999px; color: var(--muted); }
.choice:checked + label { color: var(--text); border-color: var(--text); }
.choice:focus-visible + label { outline: 2px solid var(--first); outline-offset: 2px; }
#in-colour:checked ~ * .in-grey, #in-grey:checked ~ * .in-colour,
#in-colour:checked ~ .in-grey, #in-grey:checked ~ .in-colour { display: none; }
.is-live .wide, .is-live .narrow { display: none; }
.live .u-legend { font-size: 13px; text-align: left; width: auto; }
.live .u-legend th, .live .u-legend td { border: 0; padding: 0 6px 0 0; text-align: left; font-weight: 400; }
.live .u-legend .u-off { display: none; }
.live .u-legend .u-value { font-variant-numeric: tabular-nums; min-width: 4.5em; display: inline-block; }
.screen canvas { display: block; width: 100%; border: 1px solid var(--rule); background: #fff; cursor: crosshair; touch-action: pan-y; }
.screen canvas:focus-visible { outline: 2px solid var(--first); outline-offset: 2px; }
.controls { display: flex; flex-wrap: wrap; align-items: center; gap: 8px 12px; margin: 12px 0 0; max-width: none; font-size: 14px; }
.controls input[type=range] { flex: 1 1 10em; min-width: 8em; accent-color: var(--first); }
.controls output { min-width: 9em; font-variant-numeric: tabular-nums; }
.controls button, .controls select { font: inherit; color: var(--text); background: var(--panel); border: 1px solid var(--rule);
  border-radius: 6px; padding: 5px 12px; cursor: pointer; }
.controls button:hover, .controls select:hover { border-color: var(--muted); }
.controls button:focus-visible, .controls select:focus-visible { outline: 2px solid var(--first); outline-offset: 2px; }
.readout { margin: 10px 0 0; min-height: 1.55em; max-width: none; font-size: 14px; color: var(--muted); font-variant-numeric: tabular-nums; }
#film-readout { min-height: 6.2em; color: var(--text); }
.watch { position: sticky; top: 0; z-index: 2; display: flex; flex-wrap: wrap; align-items: center; gap: 6px 14px; margin: 20px 0 0;
  padding: 10px 14px; background: var(--panel); border: 1px solid var(--rule); border-radius: 8px; font-size: 15px; font-variant-numeric: tabular-nums; }
.watch progress { flex: 1 1 8em; accent-color: var(--first); }
.watch span { flex: 4 1 20em; white-space: pre-wrap; }
html:has(.watch) { scroll-padding-top: 80px; }
.watch button { font: inherit; color: var(--paper); background: var(--second); border: 0; border-radius: 6px; padding: 5px 14px; cursor: pointer; }
.watch button:disabled { opacity: 0.5; cursor: default; }
.watch button:focus-visible { outline: 2px solid var(--first); outline-offset: 2px; }
details { margin: 0 0 12px; }
summary { cursor: pointer; padding: 4px 0; }
dl { margin: 6px 0 0; max-width: 44em; font-size: 15px; }
dt { font-weight: 600; }
dd { margin: 0 0 8px; }
pre { margin: 6px 0 0; padding: 14px 16px; overflow-x: auto; background: var(--panel); border-radius: 6px;
  font: 13px/1.5 ui-monospace, "SF Mono", Consolas, "DejaVu Sans Mono", monospace; }
blockquote { margin: 0 0 12px; padding: 2px 0 2px 16px; border-left: 3px solid var(--rule); max-width: 44em;
  overflow-wrap: anywhere; }
@media (max-width: 599px) {
  main { padding: 24px 16px 40px; }
  h1 { font-size: 23px; }
  section { margin-top: 32px; }
}
@media print {
  @page { margin: 16mm; }
  main { max-width: none; padding: 0; }
  body { font-size: 11pt; }
  .choice + label, #film, .live { display: none; }
  .is-live .wide { display: block; }
  .pictures { grid-template-columns: repeat(3, 1fr); }
  section { margin-top: 22px; }
  figure, tr, .notes { break-inside: avoid; }
  h2 { break-after: avoid; }
  table { font-size: 10pt; }
  th, td { padding: 3px 0; }
  .pair { gap: 18px 28px; }
  .pair.even { grid-template-columns: 1fr 1fr; }
  .pair.fit { grid-template-columns: 220px 1fr; }
  .wide { max-width: 520px; }
}
)css";

using Paper = specimen::Rgb (*)(Ink);

std::string ink_variables(Paper paper) {
  std::string css = ":root {";
  for (const Ink ink : all_inks) css += fmt::format(" --{}: {};", name_of(ink), hex(paper(ink)));
  return css + " }\n";
}

std::string ink_classes() {
  std::string css;
  for (const Ink ink : all_inks)
    css += fmt::format(".stroke-{0} {{ stroke: var(--{0}); }} .fill-{0} {{ fill: var(--{0}); }}\n",
                       name_of(ink));
  return css;
}

}  // namespace

std::string report_style() {
  return ink_variables(on_light_paper) + "@media screen and (prefers-color-scheme: dark) {\n" +
         ink_variables(on_dark_paper) + "}\n" + ink_classes() + page_rules;
}

}  // namespace output
