// What the bench of limits says: on the terminal, as a page and as a table.
#include <fmt/format.h>

#include <algorithm>

#include "apps/bench/stability.hpp"
#include "apps/report/key_figures.hpp"
#include "apps/report/report_parts.hpp"
#include "apps/text/markup.hpp"
#include "apps/text/text_parts.hpp"
#include "apps/text/version.hpp"

namespace app::bench {
namespace {

using output::escape;

std::string verdict_of(const StabilityRow& row) {
  if (!row.done) return "not run";
  return row.finding.holds ? "holds" : "FAILS";
}

std::string summary(const StabilityOutcome& outcome) {
  const auto count = [&](const auto& is) {
    return std::count_if(outcome.rows.begin(), outcome.rows.end(), is);
  };
  const auto done = count([](const StabilityRow& row) { return row.done; });
  const auto failed = count([](const StabilityRow& row) { return row.done && !row.finding.holds; });
  std::string text = failed > 0 ? fmt::format("{} of {} cases FAIL", failed, done)
                                : fmt::format("all of {} cases hold", done);
  if (done < static_cast<std::ptrdiff_t>(outcome.rows.size()))
    text += fmt::format(", {} were not run", static_cast<std::ptrdiff_t>(outcome.rows.size()) - done);
  return text + fmt::format("; {:.0f} s, {} at a time", outcome.wall_time, outcome.workers);
}

std::string html_row(const StabilityRow& row) {
  const char* css = row.done && row.finding.holds ? "agrees" : "disagrees";
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td>{}<br/><span class=\"why\">{}</span></td><td>{:.1f}</td>"
      "<td class=\"verdict {}\">{}</td></tr>\n",
      escape(row.name), escape(row.must), escape(row.finding.seen), row.seconds, css, verdict_of(row));
}

/// A group is what stands one after the other under one name.
std::string sections(const StabilityOutcome& outcome) {
  std::string html;
  for (auto row = outcome.rows.begin(); row != outcome.rows.end();) {
    const std::string& group = row->group;
    std::string rows;
    for (; row != outcome.rows.end() && row->group == group; ++row) rows += html_row(*row);
    html += output::section(
        group,
        output::table("claims", {"Case", "What must happen, and what was seen", "s", "Verdict"}, rows));
  }
  return html;
}

/// Words in lines of at most 100 letters, each behind an indent.
std::string in_lines(const std::string& text, const std::string& indent) {
  std::string lines;
  std::size_t length = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, end - at);
    const bool fits = length > 0 && length + 1 + word.size() <= 100;
    lines += fits ? " " : (lines.empty() ? "" : "\n") + indent;
    lines += word;
    length = (fits ? length + 1 : 0) + word.size();
    at = end + 1;
  }
  return lines + "\n";
}

}  // namespace

std::string stability_text(const StabilityOutcome& outcome) {
  std::size_t width = 0;
  for (const StabilityRow& row : outcome.rows) width = std::max(width, row.name.size());
  std::string text;
  std::string group;
  for (const StabilityRow& row : outcome.rows) {
    if (row.group != group) text += (group.empty() ? "" : "\n") + row.group + "\n";
    group = row.group;
    text += fmt::format("  {:7}  {:{}}  {:5.1f} s\n", verdict_of(row), row.name, width, row.seconds);
    text += in_lines(row.must, "           ");
    if (row.done) text += in_lines(row.finding.seen, "             ");
  }
  return text + summary(outcome) + "\n";
}

std::string stability_html(const StabilityOutcome& outcome) {
  const std::string title = "Limits of the solver";
  const std::string header = output::heading(
      title, fmt::format("Runs at the edge of what mesopix {} bears, each with what must come of it: {}.",
                         version(), summary(outcome)));
  return output::page(title, header + sections(outcome));
}

std::string stability_csv(const StabilityOutcome& outcome) {
  std::string text = "name,group,verdict,seconds,must,seen\n";
  for (const StabilityRow& row : outcome.rows)
    text += fmt::format("{},{},{},{:.2f},{},{}\n", row.name, row.group, verdict_of(row), row.seconds,
                        quoted_cell(row.must), quoted_cell(row.finding.seen));
  return text;
}

}  // namespace app::bench
