#include "apps/output/report.hpp"

#include <fmt/format.h>

#include "apps/output/html.hpp"
#include "apps/output/report_sections.hpp"
#include "apps/output/report_style.hpp"

namespace output {
namespace {

/// The page asks for nothing outside itself and runs nothing.
constexpr const char* policy = "default-src 'none'; style-src 'unsafe-inline'; img-src data:";

std::string head(const RunRecord& record) {
  return fmt::format(
      "<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>{}</title>\n<style>\n{}</style>\n</head>\n",
      policy, escape(title_of(record)), report_style());
}

}  // namespace

std::string report_html(const RunRecord& record) {
  return "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n" + head(record) +
         "<body>\n<main>\n" + header_html(record) + curve_section(record) + damage_section(record) +
         specimen_section(record) + ledger_section(record) + solution_section(record) +
         notes_section(record) + scene_section(record) + citation_section(record) +
         "</main>\n</body>\n</html>\n";
}

}  // namespace output
