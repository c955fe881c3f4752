// The style sheet of the report.
#include "apps/report/report_parts.hpp"

#include <fmt/format.h>

#include "apps/drawing/colours.hpp"

namespace output {
namespace {

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
         ink_variables(on_dark_paper) + "}\n" + ink_classes() + "\n" + std::string(page_style());
}

}  // namespace output
