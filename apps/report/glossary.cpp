// The terms of the report page, from docs/glossary.md.
#include <fmt/format.h>
#include <regex>
#include <set>
#include <sstream>

#include "apps/report/report_parts.hpp"
#include "apps/report/report_sections.hpp"
#include "apps/text/markup.hpp"

namespace output {

std::string glossary_section() {
  static const std::set<std::string> terms{"ITZ",
                                           "material point",
                                           "ghost point",
                                           "platen (smooth, rough)",
                                           "platen strain, stress",
                                           "Weibull scale, modulus",
                                           "seed",
                                           "tension, shear failure",
                                           "crack closure",
                                           "fracture energy",
                                           "crack band",
                                           "small strain",
                                           "moving points",
                                           "USF, USL, MUSL",
                                           "FLIP, PIC, APIC",
                                           "linear, GIMP, B-spline",
                                           "time step, CFL number",
                                           "energy ledger"};
  static const std::regex row(R"(\| (.+?) \| (.+?) \|)");  // of its table
  std::string html = "<details>\n<summary>The terms of this page</summary>\n<dl>\n";
  std::istringstream page{std::string(glossary_page())};
  std::smatch cells;
  for (std::string line; std::getline(page, line);) {
    std::erase(line, '`');
    if (std::regex_match(line, cells, row) && terms.contains(cells[1]))
      html += fmt::format("<dt>{}</dt>\n<dd>{}</dd>\n", escape(cells[1].str()), escape(cells[2].str()));
  }
  return section("Glossary",
                 html + "</dl>\n<p>More terms are in docs/glossary.md of mesopix.</p>\n</details>\n");
}

}  // namespace output
